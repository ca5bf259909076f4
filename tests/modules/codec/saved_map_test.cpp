#include "modules/codec/saved_map.h"

#include <cstring>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/map/mission_grid.h"
#include "core/random.h"

namespace citrine {
namespace {

using ::testing::HasSubstr;

class SavedMapTest : public ::testing::Test {
 protected:
  SavedMapTest() {
    config_.mission.volume_min_m = Eigen::Vector3d(-4, -4, 0);
    config_.mission.volume_max_m = Eigen::Vector3d(4, 4, 4);
  }
  ~SavedMapTest() override { std::filesystem::remove(path_); }

  TsdfMap Noise() const {
    TsdfMap map(MissionGrid(config_), config_.map.truncation_m);
    Random random(3);
    for (const int block : {0, 7, map.grid().num_blocks() - 1}) {
      TsdfBlock full{};
      for (int i = 0; i < kBlockVoxels; ++i) {
        full.distance_m[i] = static_cast<float>(random.Uniform(-0.5, 0.5));
        full.weight[i] = static_cast<float>(random.Uniform(0, 3));
        full.quality[i] = static_cast<float>(random.Uniform(0, 1));
      }
      map.Restore(block, full, static_cast<std::uint32_t>(block + 2));
    }
    return map;
  }
  std::string ErrorOf(const MissionConfig& config) const {
    try {
      ReadSavedMap(path_, config);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return {};
  }

  MissionConfig config_;
  const std::string path_ = ::testing::TempDir() + "/map.tsdf";
};

TEST_F(SavedMapTest, IsReadBackToTheBit) {
  const TsdfMap map = Noise();
  WriteSavedMap(path_, map, 42, config_);
  const SavedMap read = ReadSavedMap(path_, config_);
  EXPECT_EQ(read.integrations, 42);
  for (int block = 0; block < map.grid().num_blocks(); ++block) {
    ASSERT_EQ(read.map.Find(block) != nullptr, map.Find(block) != nullptr) << block;
    EXPECT_EQ(read.map.version(block), map.version(block));
    if (map.Find(block)) {
      EXPECT_EQ(std::memcmp(read.map.Find(block), map.Find(block), sizeof(TsdfBlock)), 0) << block;
    }
  }
}

TEST_F(SavedMapTest, IsRefusedForAnotherGridInOneLineThatSaysBoth) {
  WriteSavedMap(path_, Noise(), 1, config_);
  MissionConfig other = config_;
  other.map.voxel_m = 0.5;
  EXPECT_THAT(ErrorOf(other), HasSubstr("map.start = \"" + path_ +
                                        "\": is of volume [-4, -4, 0] to [4, 4, 4] m, voxel 0.25 m"));
  EXPECT_THAT(ErrorOf(other), HasSubstr("asks for volume [-4, -4, 0] to [4, 4, 4] m, voxel 0.5 m"));
  other = config_;
  other.map.weight_policy = "per_point";
  EXPECT_THAT(ErrorOf(other), HasSubstr("per_point"));
}

TEST_F(SavedMapTest, IsRefusedWhenItIsDamagedOrNoMapAtAll) {
  EXPECT_THAT(ErrorOf(config_), HasSubstr("cannot be read"));
  std::ofstream(path_) << "solid cube\n";
  EXPECT_THAT(ErrorOf(config_), HasSubstr("is no saved map"));
  WriteSavedMap(path_, Noise(), 1, config_);
  const auto size = std::filesystem::file_size(path_);
  std::filesystem::resize_file(path_, size / 2);
  EXPECT_THAT(ErrorOf(config_), HasSubstr("is damaged"));
  WriteSavedMap(path_, Noise(), 1, config_);
  for (std::uintmax_t at = 100; at < size; at += size / 37) {  // never a crash, wherever the damage is
    std::fstream file(path_, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file.put('\x55');
    file.close();
    ErrorOf(config_);
  }
}

}  // namespace
}  // namespace citrine
