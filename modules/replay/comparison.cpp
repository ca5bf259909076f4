#include "modules/replay/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>

#include "modules/replay/message_fields.h"
#include "modules/replay/said_by.h"

namespace citrine {
namespace {

constexpr const char* kNothing = "nothing";

bool IsOneBitChangesAll(const std::string& field) {
  return field == "digest" || field == "chunk" || field == "num_chunks" || field == "num_bytes" ||
         field.starts_with("data[");
}

bool IsBookkeeping(const std::string& field) {
  return field == "seq" || field == "decisions" || field == "num_blocks" || field.ends_with("_id") ||
         field.ends_with("version") || field.starts_with("index[") || field.starts_with("version[") ||
         field.find(" code of block ") != std::string::npos;
}

bool IsLookedAt(const std::string& field, const Tolerance& tolerance) {
  return (tolerance.digests || !IsOneBitChangesAll(field)) &&
         (tolerance.bookkeeping || !IsBookkeeping(field));
}

std::vector<MessageField> FieldsLookedAt(const LogEvent& event, Utime motion_from,
                                         const Tolerance& tolerance) {
  std::vector<MessageField> fields = tolerance.time > 0 ? MotionOf(event, motion_from) : FieldsOf(event);
  std::erase_if(fields, [&](const MessageField& field) { return !IsLookedAt(field.name, tolerance); });
  return fields;
}

bool Agrees(const MessageField& recorded, const MessageField& said, const Tolerance& tolerance) {
  if (recorded.name != said.name || recorded.value.index() != said.value.index()) return false;
  if (recorded.value == said.value) return true;
  if (const auto* count = std::get_if<std::int64_t>(&recorded.value)) {
    const auto by = static_cast<double>(std::abs(*count - std::get<std::int64_t>(said.value)));
    if (recorded.name.ends_with("utime")) return by <= static_cast<double>(tolerance.time);
    return by <= tolerance.count + tolerance.count_share * static_cast<double>(std::abs(*count));
  }
  if (const auto* number = std::get_if<double>(&recorded.value))
    return std::abs(*number - std::get<double>(said.value)) <=
           tolerance.number + tolerance.number_share * std::abs(*number);
  return false;
}

/// The first field beyond the tolerance; nullopt if the messages agree.
std::optional<Difference> Differs(const LogEvent& recorded, const LogEvent& said,
                                  const Tolerance& tolerance) {
  if (recorded.bytes == said.bytes) return std::nullopt;
  Difference difference{recorded.channel, recorded.utime(), recorded.seq(), "", kNothing, kNothing};
  const Utime from = recorded.utime();
  const auto a = FieldsLookedAt(recorded, from, tolerance), b = FieldsLookedAt(said, from, tolerance);
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    if (i < a.size() && i < b.size() && Agrees(a[i], b[i], tolerance)) continue;
    difference.field = i < a.size() ? a[i].name : b[i].name;
    if (i < a.size()) difference.recorded = a[i].ValueText();
    if (i < b.size() && (i >= a.size() || b[i].name == a[i].name)) difference.said = b[i].ValueText();
    return difference;
  }
  return std::nullopt;
}

Difference Missing(const LogEvent& event, bool was_recorded) {
  const char* message = "a message";
  return {event.channel,
          event.utime(),
          event.seq(),
          "",
          was_recorded ? message : kNothing,
          was_recorded ? kNothing : message};
}

auto OrderOf(const LogEvent& event) { return std::make_tuple(event.utime(), event.channel, event.seq()); }

class Tally {
 public:
  explicit Tally(Comparison& comparison) : comparison_(comparison) {}
  void Add(const LogEvent& event, const Difference& difference) {
    ++comparison_.different;
    if (comparison_.first && comparison_.first->utime <= difference.utime) return;
    comparison_.first = difference;
    comparison_.first_is_decision = IsDecision(event);
  }

 private:
  Comparison& comparison_;
};

/// Message by message: the nth of a channel against the nth.
void CompareInStep(const std::vector<LogEvent>& recorded, const std::vector<LogEvent>& said,
                   const Tolerance& tolerance, Tally& tally) {
  auto a = recorded.begin();
  auto b = said.begin();
  while (a != recorded.end() || b != said.end()) {
    const bool a_only = b == said.end() || (a != recorded.end() && OrderOf(*a) < OrderOf(*b));
    const bool b_only = a == recorded.end() || (b != said.end() && OrderOf(*b) < OrderOf(*a));
    if (a_only) {
      tally.Add(*a, Missing(*a, true));
      ++a;
    } else if (b_only) {
      tally.Add(*b, Missing(*b, false));
      ++b;
    } else {
      if (const auto difference = Differs(*a, *b, tolerance)) tally.Add(*a, *difference);
      ++a, ++b;
    }
  }
}

/// Each recorded message against those that were said on its channel about then: one has to agree.
void CompareAboutThen(const std::vector<LogEvent>& recorded, const std::vector<LogEvent>& said,
                      const Tolerance& tolerance, Tally& tally) {
  auto first = said.begin();
  for (const LogEvent& event : recorded) {
    while (first != said.end() && first->utime() < event.utime() - tolerance.time) ++first;
    std::optional<Difference> nearest;
    Utime nearest_by = tolerance.time + 1;
    bool agrees = false;
    for (auto b = first; b != said.end() && b->utime() <= event.utime() + tolerance.time && !agrees; ++b) {
      if (b->channel != event.channel) continue;
      const auto difference = Differs(event, *b, tolerance);
      agrees = !difference;
      const Utime by = std::abs(b->utime() - event.utime());
      if (difference && by < nearest_by) {
        nearest = difference;
        nearest_by = by;
      }
    }
    if (!agrees) tally.Add(event, nearest ? *nearest : Missing(event, true));
  }
}

}  // namespace

std::string Difference::Text() const {
  std::array<char, 64> when;
  std::snprintf(when.data(), when.size(), " at t = %.2f s, message %lld: ", Seconds(utime),
                static_cast<long long>(seq));
  return channel + when.data() + (field.empty() ? "" : field + " is ") + said +
         (field.empty() ? " was said" : "") + ", recorded " + recorded;
}

Comparison Compare(const std::vector<LogEvent>& recorded, const std::vector<LogEvent>& said,
                   const Tolerance& tolerance) {
  Comparison comparison{static_cast<std::int64_t>(recorded.size()), static_cast<std::int64_t>(said.size()), 0,
                        std::nullopt, false};
  Tally tally(comparison);
  if (tolerance.time > 0)
    CompareAboutThen(recorded, said, tolerance, tally);
  else
    CompareInStep(recorded, said, tolerance, tally);
  return comparison;
}

}  // namespace citrine
