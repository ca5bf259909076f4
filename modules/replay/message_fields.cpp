#include "modules/replay/message_fields.h"

#include <array>
#include <cstdio>
#include <type_traits>

#include "modules/codec/bad_message.h"
#include "modules/codec/map_blocks.h"
#include "modules/codec/trajectory.h"
#include "modules/every_channel.h"
#include "modules/reflection/message_fields.h"
#include "modules/reflection/message_types.h"

namespace citrine {
namespace {

constexpr Utime kMotionEvery = 500'000, kMotionShown = 4'000'000;

class FieldList {
 public:
  template <class Value>
  void Add(const std::string& name, const Value& value) {
    if constexpr (std::is_same_v<Value, std::uint8_t>)
      fields.push_back({name, std::int64_t{value}});
    else
      fields.push_back({name, value});
  }
  template <class Values>
  void AddAll(const std::string& name, const Values& values) {
    for (std::size_t i = 0; i < values.size(); ++i) Add(name + "[" + std::to_string(i) + "]", values[i]);
  }

  std::vector<MessageField> fields;
};

/// What the packed bytes of MAP_BLOCKS say, instead of the bytes, which depend on the packer's version.
void AddCodes(const LogEvent& event, FieldList& list) try {
  WithMessage(event, [&]<class Message>(const Message& message) {
    if constexpr (std::is_same_v<Message, citrine_lcm::map_blocks_t>)
      for (const MapBlock& block : Decode(message)) {
        const std::string of = "of block " + std::to_string(block.index);
        list.AddAll("distance code " + of, block.distance);
        list.AddAll("weight code " + of, block.weight);
      }
  });
} catch (const BadMessage& error) {
  list.Add("codes", std::string(error.what()));
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
  const MessageType* type = TypeOf(event.bytes);
  if (!type) return {};
  const bool packed = IsOn(channels::kMapBlocks, event.channel);
  try {
    for (const FieldValues& field : ReadFields(*type, event.bytes)) {
      const std::string& name = field.type->name;
      if (packed && (name == "codes" || name == "num_bytes")) continue;
      std::visit(
          [&](const auto& values) {
            if (field.type->dimensions.empty())
              list.Add(name, values.front());
            else
              list.AddAll(name, values);
          },
          field.values);
    }
  } catch (const BadMessage&) {
    return {};
  }
  if (packed) AddCodes(event, list);
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
          list.AddAll(name.data(), std::vector<double>(p_W.begin(), p_W.end()));
        }
    });
  } catch (const BadMessage& error) {
    list.Add("trajectory", std::string(error.what()));
  }
  return std::move(list.fields);
}

}  // namespace citrine
