#include "modules/replay/message_fields.h"

#include <array>
#include <cstdio>
#include <type_traits>

#include <citrine_lcm/fields.hpp>

#include "modules/codec/bad_message.h"
#include "modules/codec/map_blocks.h"
#include "modules/codec/trajectory.h"
#include "modules/every_channel.h"

namespace citrine {
namespace {

constexpr Utime kMotionEvery = 500'000, kMotionShown = 4'000'000;

class FieldList {
 public:
  void operator()(const std::string& name, const std::string& text) { fields.push_back({name, text}); }
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  void operator()(const std::string& name, Number number) {
    if constexpr (std::is_floating_point_v<Number>)
      fields.push_back({name, static_cast<double>(number)});
    else
      fields.push_back({name, static_cast<std::int64_t>(number)});
  }
  template <class Array, class = decltype(std::declval<Array>().begin())>
  void operator()(const std::string& name, const Array& array) requires(!std::is_same_v<Array, std::string>) {
    for (std::size_t i = 0; i < array.size(); ++i) (*this)(name + "[" + std::to_string(i) + "]", array[i]);
  }
  template <class Number, std::size_t N>
  void operator()(const std::string& name, const Number (&array)[N]) {
    for (std::size_t i = 0; i < N; ++i) (*this)(name + "[" + std::to_string(i) + "]", array[i]);
  }

  std::vector<MessageField> fields;
};

/// What the packed bytes of MAP_BLOCKS say, instead of the bytes, which depend on the packer's version.
void AddCodes(const citrine_lcm::map_blocks_t& message, FieldList& list) try {
  for (const MapBlock& block : Decode(message)) {
    const std::string of = "of block " + std::to_string(block.index);
    list("distance code " + of, block.distance);
    list("weight code " + of, block.weight);
  }
} catch (const BadMessage& error) {
  list("codes", std::string(error.what()));
}

}  // namespace

std::string MessageField::ValueText() const {
  if (const auto* text = std::get_if<std::string>(&value)) return '"' + *text + '"';
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  std::array<char, 40> digits;
  std::snprintf(digits.data(), digits.size(), "%.9g", std::get<double>(value));
  return digits.data();
}

std::vector<MessageField> FieldsOf(const LogEvent& event) {
  FieldList list;
  WithMessage(event, [&]<class Message>(const Message& message) {
    constexpr bool packed = std::is_same_v<Message, citrine_lcm::map_blocks_t>;
    VisitFields(message, [&](const char* name, const auto& value) {
      const std::string field(name);
      if (!packed || (field != "codes" && field != "num_bytes")) list(field, value);
    });
    if constexpr (packed) AddCodes(message, list);
  });
  return std::move(list.fields);
}

std::vector<MessageField> MotionOf(const LogEvent& event, Utime from) {
  if (!IsOn(channels::kTrajectory, event.channel)) return FieldsOf(event);
  FieldList list;
  try {
    WithMessage(event, [&]<class Message>(const Message& message) {
      if constexpr (std::is_same_v<Message, citrine_lcm::trajectory_t>)
        for (Utime t = from; t <= from + kMotionShown; t += kMotionEvery) {
          const Eigen::Vector3d p_W = Decode(message).At(t).p_W;
          std::array<char, 32> name;
          std::snprintf(name.data(), name.size(), "p_W(%.2f s)", Seconds(t));
          list(name.data(), std::vector<double>(p_W.begin(), p_W.end()));
        }
    });
  } catch (const BadMessage& error) {
    list("trajectory", std::string(error.what()));
  }
  return std::move(list.fields);
}

}  // namespace citrine
