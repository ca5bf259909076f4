#include "sim/world/world_report.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"

namespace citrine::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(WorldReport, SaysWhatAWorldIsAndThatItCanBeFlownIn) {
  WorldReportOptions options;
  options.volume_W = Eigen::AlignedBox3d(Eigen::Vector3d(-7, -7, 0), Eigen::Vector3d(7, 7, 8));
  options.uavs = 2;
  const WorldReport report = ReportWorld(CITRINE_SOURCE_DIR "/worlds/smoke.sdf", options);
  EXPECT_TRUE(report.ok) << report.text;
  EXPECT_THAT(report.text,
              AllOf(HasSubstr("14.00 x 14.00 x 4.10 m"), HasSubstr("true surface"), HasSubstr("observable"),
                    HasSubstr("free starts"), HasSubstr("can be flown in")));
}

TEST(WorldReport, HintsAtMillimetres) {
  const ScratchFolder folder;
  const WorldReport report =
      ReportWorld(folder.Write("m.obj", "v 0 0 0\nv 20000 0 0\nv 0 9000 0\nf 1 2 3\n"));
  EXPECT_FALSE(report.ok);
  EXPECT_THAT(report.text, HasSubstr("looks like millimetres"));
}

TEST(WorldReport, HintsAtASurfaceThatIsNotClosed) {
  const ScratchFolder folder;
  const WorldReport report = ReportWorld(
      folder.Write("m.obj", "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 1 2 3\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 4 5 6\n"));
  EXPECT_THAT(report.text, HasSubstr("note: not closed: 3 edges, the first in "));
  EXPECT_THAT(report.text, HasSubstr("note: MeshLab"));
}

TEST(WorldReport, SaysThatThereIsNoRoomToStart) {
  WorldReportOptions options;
  options.volume_W = Eigen::AlignedBox3d(Eigen::Vector3d(-7, -7, 0), Eigen::Vector3d(7, 7, 2));
  const WorldReport report = ReportWorld(CITRINE_SOURCE_DIR "/worlds/smoke.sdf", options);
  EXPECT_FALSE(report.ok);
  EXPECT_THAT(report.text, HasSubstr("! there is no room for 3 UAVs"));
}

TEST(WorldReport, ReportsAFileThatCannotBeRead) {
  const WorldReport report = ReportWorld("nowhere.sdf");
  EXPECT_FALSE(report.ok);
  EXPECT_THAT(report.text, HasSubstr("! nowhere.sdf: there is no such file"));
}

}  // namespace
}  // namespace citrine::sim
