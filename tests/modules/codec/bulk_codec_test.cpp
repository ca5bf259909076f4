#include <stdexcept>

#include <gtest/gtest.h>

#include "core/random.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/map_blocks.h"
#include "modules/codec/map_summary.h"
#include "modules/codec/octree.h"
#include "modules/codec/point_cloud.h"
#include "tests/modules/codec/over_the_wire.h"

namespace citrine {
namespace {

constexpr std::size_t kChunkLimit = 33'000;  // bytes of a bulk message (design, section 3)

LidarScan SmallScan() {
  LidarScan scan;
  scan.measured = 71;
  scan.X_WS = {{1.1, 2.2, 3.3}, Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5)};
  scan.model = {2, 8, -0.5, 0.4, 0.3, 12.0};
  scan.ranges_m.assign(16, 3.0f);
  return scan;
}

TEST(LidarScanCodec, KeepsRangesToHalfAMillimetreAndTheMarksExactly) {
  LidarScan said = SmallScan();
  said.ranges_m = {kNoReturn, kInvalid, 0.4237f, 11.9999f, 1.0f, 2.5004f, 7.7777f, 12.0f,
                   0.5f,      0.6f,     0.7f,    0.8f,     0.9f, 1.1f,    1.2f,    1.3f};
  const LidarScan heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.measured, 71);
  EXPECT_EQ(heard.X_WS.p, said.X_WS.p);
  EXPECT_EQ(heard.X_WS.q.coeffs(), said.X_WS.q.coeffs());
  EXPECT_EQ(heard.model, said.model);
  ASSERT_EQ(heard.ranges_m.size(), said.ranges_m.size());
  EXPECT_EQ(heard.ranges_m[0], kNoReturn);
  EXPECT_EQ(heard.ranges_m[1], kInvalid);
  for (std::size_t i = 2; i < said.ranges_m.size(); ++i)
    EXPECT_NEAR(heard.ranges_m[i], said.ranges_m[i], 0.5001e-3)
        << "half a unit of range_scale_m, and float rounding";
}

TEST(LidarScanCodec, NeverTurnsAReturnIntoNone) {
  LidarScan said = SmallScan();
  said.ranges_m[5] = 1e-5f;
  EXPECT_GT(Decode(Encode(said)).ranges_m[5], 0.0f);
}

TEST(LidarScanCodec, RefusesToSayWhatDoesNotFit) {
  LidarScan scan = SmallScan();
  scan.ranges_m[3] = 40.0f;
  EXPECT_THROW(Encode(scan), std::invalid_argument);
  scan = SmallScan();
  scan.ranges_m.pop_back();
  EXPECT_THROW(Encode(scan), std::invalid_argument);
}

TEST(LidarScanCodec, RefusesRangesThatAreNotOneABeam) {
  auto message = Encode(SmallScan());
  message.num_cols = 9;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(SmallScan());
  message.num_rows = message.num_cols = 1 << 20;
  EXPECT_THROW(Decode(message), BadMessage) << "before it allocates a terabyte";
  message = Encode(SmallScan());
  message.ranges[message.ranges.size() / 2] ^= 0xff;
  message.ranges.resize(message.ranges.size() - 1);
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(SmallScan());
  message.range_min_m = 13;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(LidarScanCodec, FitsTheWireEvenWhenNothingPacks) {
  LidarScan scan;
  scan.ranges_m.resize(scan.model.num_beams());
  Random random(1);
  for (float& range_m : scan.ranges_m) range_m = static_cast<float>(random.Uniform(0.5, 10));
  EXPECT_LE(Encode(scan).getEncodedSize(), 60'000);
}

std::vector<MapBlock> NoisyBlocks(int count) {
  Random random(2);
  std::vector<MapBlock> blocks(static_cast<std::size_t>(count));
  for (MapBlock& block : blocks) {
    block.index = static_cast<int>(random.Below(10000));
    block.version = 1 + random.Below(1000);
    for (auto& code : block.distance) code = static_cast<std::uint8_t>(random.Below(256));
    for (auto& code : block.weight) code = static_cast<std::uint8_t>(random.Below(256));
  }
  return blocks;
}

TEST(MapBlocksCodec, LosesNothingInAsManyMessagesAsItTakes) {
  auto said = NoisyBlocks(70);
  said[0].version = 0xffffffffu;
  const auto messages = EncodeInMessages(said);
  EXPECT_EQ(messages.size(), 3u);
  std::vector<MapBlock> heard;
  for (const auto& message : messages) {
    EXPECT_LE(message.getEncodedSize(), static_cast<int>(kChunkLimit));
    for (const MapBlock& block : Decode(OverTheWire(message))) heard.push_back(block);
  }
  ASSERT_EQ(heard.size(), said.size());
  for (std::size_t i = 0; i < said.size(); ++i) {
    EXPECT_EQ(heard[i].index, said[i].index);
    EXPECT_EQ(heard[i].version, said[i].version);
    EXPECT_EQ(heard[i].distance, said[i].distance);
    EXPECT_EQ(heard[i].weight, said[i].weight);
  }
}

TEST(MapBlocksCodec, RefusesCodesThatDoNotFitTheCount) {
  auto message = Encode(NoisyBlocks(2));
  message.num_blocks = 1;
  message.index.resize(1);
  message.version.resize(1);
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(NoisyBlocks(2));
  message.index[1] = -1;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(NoisyBlocks(2));
  message.version[0] = 0;
  EXPECT_THROW(Decode(message), BadMessage);
  EXPECT_THROW(Encode(NoisyBlocks(kMaxBlocksAMessage + 1)), std::invalid_argument);
}

TEST(MapSummaryCodec, GivesTheSameGrid) {
  MapSummary said;
  said.grid = VoxelGrid(0.3, {Eigen::Vector3d(-1.23, 4.56, 0.07), Eigen::Vector3d(20.1, 17.9, 9.77)}, 0.8);
  said.truncation_m = 0.5;
  said.weight_max = 0.049;
  said.map_version = 81;
  said.num_blocks = 82;
  said.digest = 0xfedcba9876543210u;
  const MapSummary heard = Decode(OverTheWire(Encode(said)));
  EXPECT_TRUE(heard.grid == said.grid);
  EXPECT_EQ(heard.grid.volume_W().max(), said.grid.volume_W().max());
  EXPECT_EQ(heard.truncation_m, 0.5);
  EXPECT_EQ(heard.weight_max, 0.049);
  EXPECT_EQ(heard.map_version, 81);
  EXPECT_EQ(heard.num_blocks, 82);
  EXPECT_EQ(heard.digest, said.digest);
}

TEST(MapSummaryCodec, RefusesAGridThatNoMissionHas) {
  MapSummary said;
  said.grid = VoxelGrid(0.25, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(10, 10, 10)}, 0.75);
  said.truncation_m = 0.5;
  said.weight_max = 0.05;
  auto message = Encode(said);
  EXPECT_NO_THROW(Decode(message));
  message.volume_max_W[0] = 1e12;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(said);
  message.volume_max_W[2] = -1;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(said);
  message.num_blocks = 1 << 20;
  EXPECT_THROW(Decode(message), BadMessage);
}

OctreeBytes SomeOctree(std::int64_t version) {
  OctreeBytes octree{version, 0.25, {}};
  Random random(3);
  for (int i = 0; i < 100'000; ++i) octree.bytes.push_back(static_cast<std::uint8_t>(random.Below(256)));
  return octree;
}

TEST(OctreeCodec, IsPutTogetherFromChunksInAnyOrder) {
  const OctreeBytes said = SomeOctree(91);
  auto messages = EncodeInMessages(said);
  ASSERT_EQ(messages.size(), 4u);
  std::swap(messages[0], messages[3]);
  OctreeAssembler assembler;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(messages[i].getEncodedSize(), static_cast<int>(kChunkLimit));
    EXPECT_FALSE(assembler.Add(OverTheWire(messages[i])));
  }
  EXPECT_FALSE(assembler.Add(messages[2])) << "a repetition completes nothing";
  const auto heard = assembler.Add(messages[3]);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->map_version, 91);
  EXPECT_EQ(heard->resolution_m, 0.25);
  EXPECT_EQ(heard->bytes, said.bytes);
}

TEST(OctreeCodec, LetsAnIncompleteOneGiveWayToTheNext) {
  OctreeAssembler assembler;
  assembler.Add(EncodeInMessages(SomeOctree(1))[0]);
  std::optional<OctreeBytes> heard;
  for (const auto& message : EncodeInMessages(SomeOctree(2))) heard = assembler.Add(message);
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->map_version, 2);
}

TEST(OctreeCodec, RefusesAChunkOutsideTheCount) {
  auto message = EncodeInMessages(SomeOctree(1))[0];
  message.chunk = message.num_chunks;
  OctreeAssembler assembler;
  EXPECT_THROW(assembler.Add(message), BadMessage);
}

TEST(PointCloudCodec, LosesNothingInChunks) {
  PointCloud said;
  said.measured = 95;
  said.X_WS.p = {1.1, 2.2, 3.3};
  said.range_min_m = 0.4;
  said.range_max_m = 50;
  for (int i = 0; i < 6000; ++i) said.points_S.emplace_back(0.1f * static_cast<float>(i), 1.5f, -2.5f);
  std::vector<Eigen::Vector3f> heard;
  for (const auto& message : EncodeInMessages(said)) {
    EXPECT_LE(message.getEncodedSize(), static_cast<int>(kChunkLimit));
    const PointCloud part = Decode(OverTheWire(message));
    EXPECT_EQ(part.measured, 95);
    EXPECT_EQ(part.X_WS.p, said.X_WS.p);
    EXPECT_EQ(part.range_max_m, 50);
    heard.insert(heard.end(), part.points_S.begin(), part.points_S.end());
  }
  EXPECT_EQ(heard, said.points_S);
}

TEST(PointCloudCodec, RefusesBytesThatAreNotTwelveAPoint) {
  PointCloud cloud;
  cloud.range_max_m = 10;
  cloud.points_S.resize(3, Eigen::Vector3f::Ones());
  auto message = EncodeInMessages(cloud)[0];
  message.num_points = 2;
  EXPECT_THROW(Decode(message), BadMessage);
}

}  // namespace
}  // namespace citrine
