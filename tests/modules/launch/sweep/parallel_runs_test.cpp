#include "modules/launch/sweep/parallel_runs.h"

#include <unistd.h>

#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/modules/launch/sweep/sweep_file.h"
#include "tests/support/citrine_command.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

class ParallelRuns : public ::testing::Test {
 protected:
  /// A program that writes its arguments to <--out>/said, and ends with 3 for seed 2.
  ParallelRuns() {
    unsetenv("SHELL");  // as where nobody is logged in
    options_.folder = file_.folder();
    options_.program = Script("fly",
                              "for word; do last=$word; done\n"
                              "echo \"$@\" > \"$last/said\"; touch \"$last/mission.lcmlog\"\n"
                              "case \"$*\" in *'--seed 2'*) exit 3;; esac\n");
    options_.jobs = 2;
    for (int seed = 1; seed <= 4; ++seed)
      jobs_.push_back({"w", "it's", seed, file_.folder() + "/w/it's " + std::to_string(seed),
                       "run x --seed " + std::to_string(seed)});
  }

  std::string Script(const std::string& name, const std::string& text) {
    const std::string path = file_.folder() + "/" + name;
    std::ofstream(path) << "#!/bin/sh\n" << text;
    fs::permissions(path, fs::perms::owner_all);
    return path;
  }

  SweepFile file_;
  ParallelOptions options_;
  std::vector<SweepJob> jobs_;
};

TEST_F(ParallelRuns, EveryJobIsRunOnceAndItsEndHeard) {
  std::multiset<std::size_t> ended;
  int exit_code_of_seed_2 = -1;
  EXPECT_TRUE(RunInParallel(jobs_, options_, [&](const EndedJob& job) {
    ended.insert(job.index);
    if (job.index == 1) exit_code_of_seed_2 = job.exit_code;
  }));
  EXPECT_EQ(ended, (std::multiset<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(exit_code_of_seed_2, 3);
  for (const SweepJob& job : jobs_) {
    std::ifstream said(job.folder + "/said");
    std::string text;
    std::getline(said, text);
    EXPECT_EQ(text, job.command + " --out " + job.folder);
    EXPECT_FALSE(fs::exists(job.folder + "/mission.lcmlog"));
  }
}

TEST_F(ParallelRuns, JobsAreSentToHostsThroughTheirShell) {
  // A shell on "another host": says which, drops the name, and runs what is left on this machine.
  const std::string ssh = Script("ssh", "echo \"$1\" >> " + file_.folder() +
                                            "/hosts\nshift\n[ \"$1\" = -- ] && shift\nexec sh -c \"$*\"\n");
  options_.hosts = ssh + " north," + ssh + " south";
  int ended = 0;
  EXPECT_TRUE(RunInParallel(jobs_, options_, [&](const EndedJob&) { ++ended; }));
  EXPECT_EQ(ended, 4);
  for (const SweepJob& job : jobs_) EXPECT_TRUE(fs::exists(job.folder + "/said")) << job.folder;
  std::ifstream in(file_.folder() + "/hosts");
  std::set<std::string> hosts;
  for (std::string host; std::getline(in, host);) hosts.insert(host);
  EXPECT_TRUE(hosts.contains("north"));
  EXPECT_TRUE(hosts.contains("south"));
}

TEST_F(ParallelRuns, ResultsOfAnotherHostComeBack) {
  if (RunCommandLine("unshare -rm true && command -v rsync").exit_code != 0)
    GTEST_SKIP() << "no unshare or no rsync";
  // Another host: the same machine with another folder where the project is.
  const std::string other = file_.folder() + "/other", relative = "results/test_" + std::to_string(getpid());
  fs::create_directories(other);
  fs::rename(options_.program, other + "/fly");
  const std::string ssh =
      Script("ssh", "shift\n[ \"$1\" = -- ] && shift\nexec unshare -rm sh -c 'mount --bind " + other +
                        " " CITRINE_SOURCE_DIR " && cd / && exec sh -c \"$1\"' sh \"$*\"\n");
  options_.program = "./fly";
  options_.hosts = ssh + " north";
  jobs_.resize(1);
  jobs_[0].folder = relative + "/1";
  const fs::path here = fs::path(CITRINE_SOURCE_DIR) / jobs_[0].folder / "said";
  EXPECT_TRUE(RunInParallel(jobs_, options_, [](const EndedJob& job) { EXPECT_EQ(job.exit_code, 0); }));
  EXPECT_TRUE(fs::exists(other + "/" + jobs_[0].folder + "/said"));
  EXPECT_TRUE(fs::exists(here)) << here;
  fs::remove_all(fs::path(CITRINE_SOURCE_DIR) / relative);
}

TEST(JobLog, IsReadLineByLineAndOneCutShortIsLeft) {
  const std::string head = "Seq\tHost\tStarttime\tJobRuntime\tSend\tReceive\tExitval\tSignal\tCommand\n";
  const std::string one = "2\t:\t1795692709.831\t    18.079\t0\t0\t3\t0\tsh -c 'x y'\n";
  const std::string killed = "1\tnorth\t1795692709.831\t 1.5\t0\t0\t0\t15\tsh -c 'z'\n";
  const auto ended = ReadJobLog(head + one + killed + "3\t:\t17956");
  ASSERT_EQ(ended.size(), 2u);
  EXPECT_EQ(ended[0].index, 1u);
  EXPECT_EQ(ended[0].exit_code, 3);
  EXPECT_DOUBLE_EQ(ended[0].wall_s, 18.079);
  EXPECT_DOUBLE_EQ(ended[0].start_s, 1795692709.831);
  EXPECT_EQ(ended[1].exit_code, 128 + 15);
  EXPECT_TRUE(ReadJobLog("").empty());
  EXPECT_TRUE(ReadJobLog(head).empty());
}

}  // namespace
}  // namespace citrine
