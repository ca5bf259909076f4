#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "modules/channels.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/uav_state.h"
#include "modules/every_channel.h"
#include "modules/mcap_export/export_mcap.h"
#include "tests/support/citrine_command.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kGolden = CITRINE_SOURCE_DIR "/logs/golden/smoke_three_uavs/mission.lcmlog";
const fs::path kReader = fs::path(CITRINE_BIN_DIR).parent_path() / "mcap_reader";

std::string ReadBytes(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Says what is missing for the independent reader; fetches it once.
std::string MissingForReader() {
  if (RunCommandLine("node --version").exit_code != 0) return "node is not there (packages-tools.txt)";
  if (fs::exists(kReader / "node_modules/@mcap/core") && fs::exists(kReader / "node_modules/fzstd") &&
      fs::exists(kReader / "node_modules/protobufjs"))
    return "";
  if (RunCommandLine("npm --version").exit_code != 0) return "npm is not there (packages-tools.txt)";
  fs::create_directories(kReader);
  const CommandResult fetched = RunCommandLine(
      "cd '" + kReader.string() + "' && flock lock timeout 120 npm install --prefix '" + kReader.string() +
      "' --no-audit --no-fund --ignore-scripts @mcap/core@2.2.2 fzstd@0.1.1 protobufjs@7.2.5");
  return fetched.exit_code == 0 ? "" : "npm cannot fetch the reader: " + fetched.output;
}

class McapExport : public ::testing::Test {
 protected:
  McapExport() : mission_(ReadMission(kGolden)) {}

  /// Messages on a channel that were said before the last step: an exporter hears no others.
  template <class Message>
  std::vector<Message> Heard(const std::string& channel) const {
    std::vector<Message> heard;
    for (const LogEvent& event : mission_.events) {
      Message message{};
      if (event.channel != channel || event.utime() >= mission_.events.back().utime()) continue;
      message.decode(event.bytes.data(), 0, static_cast<int>(event.bytes.size()));
      heard.push_back(message);
    }
    return heard;
  }

  const RecordedMission mission_;
  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(McapExport, WritesTheSameBytesForTheSameRecording) {
  const McapSize size = ExportMcap(mission_, folder_ / "a.mcap");
  ExportMcap(mission_, folder_ / "b.mcap");
  EXPECT_EQ(size.bytes, fs::file_size(folder_ / "a.mcap"));
  EXPECT_EQ(ReadBytes(folder_ / "a.mcap"), ReadBytes(folder_ / "b.mcap"));
}

TEST_F(McapExport, FailsInOneLineWhereNothingCanBeWritten) {
  EXPECT_THROW(ExportMcap(mission_, folder_ / "nowhere/a.mcap"), std::runtime_error);
}

class McapReadBack : public McapExport {
 protected:
  void SetUp() override {
    if (const std::string missing = MissingForReader(); !missing.empty()) GTEST_SKIP() << missing;
    const std::string path = folder_ / "mission.mcap";
    ExportMcap(mission_, path);
    const CommandResult read =
        RunCommandLine("node " CITRINE_SOURCE_DIR "/tests/modules/mcap_export/read_back.mjs " + path + " " +
                       kReader.string());
    ASSERT_EQ(read.exit_code, 0) << read.output;
    found_ = json::parse(read.output);
  }
  const json& Topic(const std::string& name) const { return found_.at("topics").at(name); }

  json found_;
};

TEST_F(McapReadBack, FindsEveryPoseWhereItWasSaid) {
  EXPECT_TRUE(found_["inOrder"]);
  for (int uav = 1; uav <= mission_.config.mission.uavs; ++uav) {
    const json& poses = Topic("/uav" + std::to_string(uav) + "/pose");
    const auto states = Heard<citrine_lcm::uav_state_t>(channels::kUavState.Of(uav));
    EXPECT_EQ(poses["schema"], "foxglove.PoseInFrame");
    EXPECT_EQ(poses["count"], states.size());
    const json& last = poses["last"];
    EXPECT_EQ(last["frame_id"], "map");
    EXPECT_EQ(last["timestamp"]["seconds"].get<double>() * 1e6 + last["timestamp"].value("nanos", 0.0) / 1e3,
              static_cast<double>(states.back().utime));
    EXPECT_EQ(last["pose"]["position"]["x"], states.back().p_WB[0]);
    EXPECT_EQ(last["pose"]["position"]["z"], states.back().p_WB[2]);
    EXPECT_EQ(last["pose"]["orientation"]["w"], states.back().q_WB[0]);
    EXPECT_EQ(Topic("/tf")["last"]["transforms"][uav - 1]["child_frame_id"], "uav" + std::to_string(uav));
  }
}

TEST_F(McapReadBack, FindsACloudAScanWithinTheRangeOfItsSensor) {
  for (int uav = 1; uav <= mission_.config.mission.uavs; ++uav) {
    const auto scans = Heard<citrine_lcm::lidar_scan_t>(channels::kLidarScan.Of(uav));
    const json& clouds = Topic("/uav" + std::to_string(uav) + "/cloud");
    EXPECT_EQ(clouds["schema"], "foxglove.PointCloud");
    EXPECT_EQ(clouds["count"], scans.size());
    ASSERT_GT(clouds["last"]["points"], 100);
    EXPECT_LE(clouds["last"]["points"], mission_.config.lidar.model.num_beams());
    const Eigen::Vector3d first_W(clouds["last"]["firstPoint"][0], clouds["last"]["firstPoint"][1],
                                  clouds["last"]["firstPoint"][2]);
    const Eigen::Vector3d sensor_W(scans.back().p_WS[0], scans.back().p_WS[1], scans.back().p_WS[2]);
    EXPECT_LT((first_W - sensor_W).norm(), mission_.config.lidar.model.range_max_m);
  }
}

TEST_F(McapReadBack, FindsTheSurfaceAndTheProgressThatTheBaseStationSaid) {
  const auto progress = Heard<citrine_lcm::mission_progress_t>(channels::kMissionProgress.name);
  const json& last = Topic("/progress")["last"];
  EXPECT_EQ(Topic("/progress")["count"], progress.size());
  EXPECT_EQ(last["surface_voxels"], progress.back().surface_voxels);
  EXPECT_EQ(last["z_goal"], progress.back().z_goal);
  EXPECT_NEAR(last["at_goal_pct"], 100.0 * progress.back().voxels_at_goal / progress.back().surface_voxels,
              1e-9);
  const json& surface = Topic("/map/surface");
  EXPECT_EQ(surface["schema"], "foxglove.PointCloud");
  // The map that the exporter draws at the end is the one of the last progress or a publication newer.
  EXPECT_GE(surface["last"]["points"], progress.back().surface_voxels);
  EXPECT_LE(surface["last"]["points"], 2 * progress.back().surface_voxels);
  EXPECT_EQ(surface["last"]["fields"][3]["name"], "confidence");
}

TEST_F(McapReadBack, FindsPlansAndGoalsUnderNames) {
  const json& plan = Topic("/uav1/plan");
  EXPECT_EQ(plan["schema"], "foxglove.SceneUpdate");
  std::vector<std::string> names;
  for (const char* list : {"entities", "deletions"})
    if (plan["last"].contains(list))
      for (const json& each : plan["last"][list]) names.push_back(each["id"]);
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"goal", "path", "trajectory"}));
}

TEST_F(McapReadBack, FindsTheMissionItself) {
  ASSERT_EQ(found_["attachments"].size(), 1u);
  EXPECT_EQ(found_["attachments"][0]["name"], "mission.toml");
  EXPECT_EQ(found_["attachments"][0]["text"], mission_.flown.toml);
  EXPECT_EQ(found_["metadata"]["mission"]["mission_id"], mission_.flown.mission_id);
  EXPECT_EQ(found_["metadata"]["mission"]["commit"], mission_.flown.commit);
  std::int64_t messages = 0;
  for (const auto& [name, topic] : found_["topics"].items()) messages += topic["count"].get<std::int64_t>();
  EXPECT_EQ(found_["statistics"]["messages"], messages);
  EXPECT_GT(found_["statistics"]["chunks"], 1);
}

}  // namespace
}  // namespace citrine
