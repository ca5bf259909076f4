#include "modules/reflection/message_fields.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "modules/codec/bad_message.h"

namespace citrine {
namespace {

using Kind = FieldType::Kind;

/// Bytes of a message, front to back; big-endian, as LCM writes them.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }
  std::span<const std::uint8_t> Take(std::size_t size) {
    Require(size <= bytes_.size(), "cut short");
    const auto taken = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return taken;
  }
  template <class Unsigned>
  Unsigned TakeNumber() {
    Unsigned value = 0;
    for (const std::uint8_t byte : Take(sizeof(Unsigned))) value = static_cast<Unsigned>(value << 8 | byte);
    return value;
  }
  std::string TakeText() {
    const auto size = TakeNumber<std::uint32_t>();
    Require(size > 0, "a text without its zero");
    const auto bytes = Take(size);
    Require(bytes.back() == 0, "a text without its zero");
    return {bytes.begin(), bytes.end() - 1};
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

std::int64_t TakeInteger(Reader& reader, Kind kind) {
  switch (kind) {
    case Kind::kInt16:
      return static_cast<std::int16_t>(reader.TakeNumber<std::uint16_t>());
    case Kind::kInt32:
      return static_cast<std::int32_t>(reader.TakeNumber<std::uint32_t>());
    case Kind::kInt64:
      return static_cast<std::int64_t>(reader.TakeNumber<std::uint64_t>());
    default:
      return static_cast<std::int8_t>(reader.TakeNumber<std::uint8_t>());
  }
}

std::size_t LeastBytes(Kind kind) {
  switch (kind) {
    case Kind::kInt16:
      return 2;
    case Kind::kInt32:
    case Kind::kFloat:
    case Kind::kString:
      return 4;
    case Kind::kInt64:
    case Kind::kDouble:
      return 8;
    default:
      return 1;
  }
}

/// How many values a field has, by the counts read so far. Never more than the bytes that are left can hold.
std::size_t CountOf(const FieldType& field, const std::vector<FieldValues>& before, std::size_t bytes_left) {
  std::size_t count = 1;
  for (const std::string& dimension : field.dimensions) {
    const auto named = std::find_if(before.begin(), before.end(),
                                    [&](const FieldValues& f) { return f.type->name == dimension; });
    const std::int64_t size =
        named == before.end() ? std::strtoll(dimension.c_str(), nullptr, 10) : named->integer();
    Require(size >= 0, "a negative count");
    const std::size_t most = bytes_left / LeastBytes(field.kind);
    Require(size == 0 || count <= most / static_cast<std::size_t>(size), "cut short");
    count *= static_cast<std::size_t>(size);
  }
  return count;
}

template <class Value, class Take>
std::vector<Value> TakeMany(std::size_t count, Take&& take) {
  std::vector<Value> values;
  values.reserve(count);
  while (values.size() < count) values.push_back(take());
  return values;
}

FieldValues::Values TakeValues(Reader& reader, Kind kind, std::size_t count) {
  switch (kind) {
    case Kind::kByte: {
      const auto bytes = reader.Take(count);
      return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
    }
    case Kind::kFloat:
      return TakeMany<double>(
          count, [&] { return double{std::bit_cast<float>(reader.TakeNumber<std::uint32_t>())}; });
    case Kind::kDouble:
      return TakeMany<double>(count,
                              [&] { return std::bit_cast<double>(reader.TakeNumber<std::uint64_t>()); });
    case Kind::kString:
      return TakeMany<std::string>(count, [&] { return reader.TakeText(); });
    default:
      return TakeMany<std::int64_t>(count, [&] { return TakeInteger(reader, kind); });
  }
}

const FieldValues* Find(const std::vector<FieldValues>& fields, const char* name) {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const FieldValues& f) { return f.type->name == name; });
  return found == fields.end() ? nullptr : &*found;
}

}  // namespace

std::int64_t FieldValues::integer() const {
  const auto* integers = std::get_if<std::vector<std::int64_t>>(&values);
  return integers && integers->size() == 1 ? integers->front() : 0;
}

std::string FieldValues::text() const {
  const auto* texts = std::get_if<std::vector<std::string>>(&values);
  return texts && texts->size() == 1 ? texts->front() : std::string();
}

std::vector<FieldValues> ReadFields(const MessageType& type, std::span<const std::uint8_t> message) {
  Reader reader(message);
  Require(static_cast<std::int64_t>(reader.TakeNumber<std::uint64_t>()) == type.fingerprint, "another type");
  std::vector<FieldValues> fields;
  for (const FieldType& field : type.fields) {
    const std::size_t count = CountOf(field, fields, reader.left());
    fields.push_back({&field, TakeValues(reader, field.kind, count)});
  }
  Require(reader.left() == 0, "longer than its type");
  return fields;
}

std::string SenderOf(const std::vector<FieldValues>& fields) {
  if (const FieldValues* module = Find(fields, "module")) {
    const FieldValues* uav = Find(fields, "uav");
    return module->text() + "/" + std::to_string(uav ? uav->integer() : 0);
  }
  const FieldValues* sender = Find(fields, "sender");
  return sender ? std::to_string(sender->integer()) : std::string();
}

}  // namespace citrine
