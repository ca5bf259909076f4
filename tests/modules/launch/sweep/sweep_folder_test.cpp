#include "modules/launch/sweep/sweep_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/modules/launch/sweep/sweep_file.h"

namespace citrine {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class SweepFolder : public ::testing::Test {
 protected:
  SweepFolder() {
    SweepOptions options;
    options.sweep = file_.Write();
    options.out = file_.folder() + "/out";
    sweep_ = PlanSweep(options);
  }

  /// What a mission leaves when it has ended for this reason.
  void Fly(const SweepJob& job, const std::string& build, const std::string& stop_reason,
           double makespan_m = 50) {
    Begin(job, build);
    logs::Metrics metrics;
    metrics.stop_reason = stop_reason;
    metrics.completed = stop_reason == "surface_complete";
    metrics.makespan_m = makespan_m;
    metrics.threshold_m = 0.3062;
    metrics.world_hash = "abad1dea";
    metrics.seed = job.seed;
    std::ofstream(job.folder + "/metrics.json") << logs::ToJson(metrics);
    std::ofstream(job.folder + "/progress.csv") << "time_s,voxels_at_goal\n0.5,10\n";
  }

  SweepFile file_;
  Sweep sweep_;
};

TEST_F(SweepFolder, AJobIsFinishedByThisBuildByAnotherOrNot) {
  const SweepJob& job = sweep_.jobs[0];
  EXPECT_EQ(StateOf(job, "b1"), JobState::kOpen);
  Begin(job, "b1");
  EXPECT_EQ(StateOf(job, "b1"), JobState::kOpen);
  Fly(job, "b1", "surface_complete");
  EXPECT_EQ(StateOf(job, "b1"), JobState::kFinished);
  EXPECT_EQ(StateOf(job, "b2"), JobState::kOfAnotherBuild);
  Fly(job, "b1", "time_limit");
  EXPECT_EQ(StateOf(job, "b1"), JobState::kFinished);
  for (const char* reason : {"interrupted", "module_died"}) {
    Fly(job, "b1", reason);
    EXPECT_EQ(StateOf(job, "b1"), JobState::kOpen) << reason;
  }
}

TEST_F(SweepFolder, AJobWhoseConfigurationHasChangedIsOpen) {
  SweepJob job = sweep_.jobs[0];
  Fly(job, "b1", "surface_complete");
  job.command += " --set planner.alpha=2";
  EXPECT_EQ(StateOf(job, "b1"), JobState::kOpen);
}

TEST_F(SweepFolder, HalfAResultIsNone) {
  Fly(sweep_.jobs[0], "b1", "surface_complete");
  std::ofstream(sweep_.jobs[0].folder + "/metrics.json") << "{\"mission\": \"smo";
  EXPECT_EQ(StateOf(sweep_.jobs[0], "b1"), JobState::kOpen);
}

TEST_F(SweepFolder, TablesTellOfWhatIsFinishedSoFar) {
  for (std::size_t i = 0; i < 3; ++i)
    Fly(sweep_.jobs[i], i == 2 ? "b2" : "b1", "surface_complete", 50.0 + static_cast<double>(i));
  std::ofstream(sweep_.folder + "/joblog.tsv") << "Seq\tHost\n"
                                                  "1\t:\t1000.0\t 90.0\t0\t0\t0\t0\tx\n"
                                                  "2\t:\t1000.5\t119.5\t0\t0\t0\t0\tx\n";
  const logs::SweepResults results = ReadResults(sweep_);
  ASSERT_EQ(results.runs.size(), 3u);
  EXPECT_EQ(results.runs[1].metrics.makespan_m, 51);
  EXPECT_EQ(results.runs[1].over_time.at("voxels_at_goal").front().second, 10);
  EXPECT_THAT(results.notes, Contains(HasSubstr("3 of 4 missions are finished")));
  EXPECT_THAT(results.notes, Contains(HasSubstr("2 different builds")));
  EXPECT_THAT(results.notes, Contains(HasSubstr("flew and scored 2 missions in 2.0 minutes, 1.7 at a time")));
  EXPECT_THAT(results.notes, Contains(HasSubstr("world hash abad1dea")));
  EXPECT_THAT(results.notes, Contains(HasSubstr("= 0.3062 m; true surface clipped")));
  WriteTables(sweep_, results);
  for (const char* name : {"tables.md", "tables.tex", "runs.csv", "summary.csv", "report.html",
                           "figures/smoke-makespan_m.svg", "figures/smoke-voxels_at_goal-over_time.svg"})
    EXPECT_TRUE(std::filesystem::file_size(std::filesystem::path(sweep_.folder) / name) > 100) << name;
}

TEST_F(SweepFolder, TheDigestOfThisProgramIsAlwaysTheSame) {
  EXPECT_EQ(ProgramDigest(), ProgramDigest());
  EXPECT_EQ(ProgramDigest().size(), 16u);
}

}  // namespace
}  // namespace citrine
