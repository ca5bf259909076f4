#include "modules/codec/saved_map.h"

#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "core/config/number_text.h"
#include "core/map/mission_grid.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/packed_bytes.h"

namespace citrine {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian");

// A line of text that says of what grid the map is, then the length of the rest and the rest, packed.
constexpr const char* kMagic = "citrine map 1: ";
constexpr std::size_t kBlockBytes = 2 * sizeof(std::uint32_t) + sizeof(TsdfBlock);

/// What two maps must have in common, in one line.
std::string GridText(const MissionConfig& config) {
  const Eigen::AlignedBox3d volume_W = config.volume_W();
  return "volume " + VectorText(volume_W.min()) + " to " + VectorText(volume_W.max()) + " m, voxel " +
         NumberText(config.map.voxel_m) + " m, truncation " + NumberText(config.map.truncation_m) + " m, " +
         config.map.weight_policy;
}

template <class Value>
void Append(std::vector<std::uint8_t>& bytes, const Value& value) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

template <class Value>
Value Take(const std::vector<std::uint8_t>& bytes, std::size_t& at) {
  Value value;
  Require(at + sizeof value <= bytes.size(), "is cut short");
  std::memcpy(&value, bytes.data() + at, sizeof value);
  at += sizeof value;
  return value;
}

SavedMap Parse(const std::vector<std::uint8_t>& file, std::size_t at, const MissionConfig& config) {
  SavedMap saved{TsdfMap(MissionGrid(config), config.map.truncation_m), 0};
  const int num_blocks = saved.map.grid().num_blocks();
  const auto size = Take<std::uint64_t>(file, at);
  Require(size <= sizeof(std::int64_t) + static_cast<std::size_t>(num_blocks) * kBlockBytes, "is damaged");
  const auto bytes = Unpack({file.begin() + static_cast<std::ptrdiff_t>(at), file.end()}, size, "is damaged");
  at = 0;
  saved.integrations = Take<std::int64_t>(bytes, at);
  while (at < bytes.size()) {
    const auto index = Take<std::uint32_t>(bytes, at), version = Take<std::uint32_t>(bytes, at);
    Require(index < static_cast<std::uint32_t>(num_blocks), "is damaged");
    saved.map.Restore(static_cast<int>(index), Take<TsdfBlock>(bytes, at), version);
  }
  return saved;
}

}  // namespace

void WriteSavedMap(const std::string& path, const TsdfMap& map, std::int64_t integrations,
                   const MissionConfig& config) {
  std::vector<std::uint8_t> bytes;
  Append(bytes, integrations);
  for (int block = 0; block < map.grid().num_blocks(); ++block)
    if (const TsdfBlock* full = map.Find(block)) {
      Append(bytes, static_cast<std::uint32_t>(block));
      Append(bytes, map.version(block));
      Append(bytes, *full);
    }
  const std::vector<std::uint8_t> packed = Pack(bytes);
  const std::uint64_t size = bytes.size();
  std::ofstream file(path, std::ios::binary);
  file << kMagic << GridText(config) << '\n';
  file.write(reinterpret_cast<const char*>(&size), sizeof size);
  file.write(reinterpret_cast<const char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

SavedMap ReadSavedMap(const std::string& path, const MissionConfig& config) {
  const auto fail = [&](const std::string& why) -> ConfigError {
    return ConfigError("map.start = \"" + path + "\": " + why);
  };
  std::ifstream in(path, std::ios::binary);
  std::string head;
  if (!in) throw fail("cannot be read");
  std::getline(in, head);
  if (!head.starts_with(kMagic)) throw fail("is no saved map (map.tsdf of a result folder)");
  if (const std::string of = head.substr(std::strlen(kMagic)); of != GridText(config))
    throw fail("is of " + of + "; this mission asks for " + GridText(config));
  const std::vector<std::uint8_t> file{std::istreambuf_iterator<char>(in), {}};
  try {
    return Parse(file, 0, config);
  } catch (const BadMessage& error) {
    throw fail(error.what());
  }
}

}  // namespace citrine
