#include "modules/launch/supervisor.h"

#include <signal.h>

#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine {
namespace {

using ::testing::ElementsAre;

class SupervisorTest : public ::testing::Test {
 protected:
  SupervisorTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~SupervisorTest() override { std::filesystem::remove_all(folder_); }

  std::vector<Departure> AwaitDepartures(Supervisor& supervisor) {
    for (int i = 0; i < 500; ++i) {
      if (auto departures = supervisor.TakeDepartures(); !departures.empty()) return departures;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return {};
  }

  const std::string folder_ = ::testing::TempDir() + "/supervisor_test_" + std::to_string(getpid());
};

TEST_F(SupervisorTest, NamesTheExitCodeOfOneThatLeft) {
  Supervisor supervisor(folder_);
  supervisor.Start({"shell", {"sh", "-c", "exit 7"}});
  const auto departures = AwaitDepartures(supervisor);
  ASSERT_EQ(departures.size(), 1u);
  EXPECT_EQ(departures[0].name, "shell");
  EXPECT_EQ(departures[0].how(), "exited with 7");
  EXPECT_FALSE(departures[0].orderly());
  EXPECT_FALSE(supervisor.runs("shell"));
}

TEST_F(SupervisorTest, NamesTheSignalOfOneThatDied) {
  Supervisor supervisor(folder_);
  supervisor.Start({"shell", {"sh", "-c", "kill -SEGV $$"}});
  const auto departures = AwaitDepartures(supervisor);
  ASSERT_EQ(departures.size(), 1u);
  EXPECT_EQ(departures[0].how(), "died (SIGSEGV)");
}

TEST_F(SupervisorTest, KeepsTheLastWordsOfEach) {
  Supervisor supervisor(folder_);
  supervisor.Start({"shell", {"sh", "-c", "echo one; echo two; echo three >&2"}});
  ASSERT_EQ(AwaitDepartures(supervisor).size(), 1u);
  EXPECT_EQ(supervisor.LastWords("shell", 2), "    two\n    three\n");
}

TEST_F(SupervisorTest, RefusesAProgramThatIsNotThere) {
  Supervisor supervisor(folder_);
  EXPECT_THROW(supervisor.Start({"ghost", {folder_ + "/ghost"}}), std::system_error);
  EXPECT_FALSE(supervisor.runs("ghost"));
}

TEST_F(SupervisorTest, SignalsAllButOne) {
  Supervisor supervisor(folder_);
  supervisor.Start({"a", {"sleep", "60"}});
  supervisor.Start({"b", {"sleep", "60"}});
  supervisor.SignalAllBut("b", SIGTERM);
  const auto departures = AwaitDepartures(supervisor);
  ASSERT_EQ(departures.size(), 1u);
  EXPECT_EQ(departures[0].how(), "died (SIGTERM)");
  EXPECT_THAT(supervisor.running(), ElementsAre("b"));
}

TEST_F(SupervisorTest, LeavesNobodyBehind) {
  const std::string pid_file = folder_ + "/pid";
  {
    Supervisor supervisor(folder_);
    supervisor.Start({"shell", {"sh", "-c", "echo $$ > " + pid_file + "; exec sleep 60"}});
    while (!std::filesystem::exists(pid_file) || std::filesystem::file_size(pid_file) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  pid_t pid = 0;
  std::FILE* file = std::fopen(pid_file.c_str(), "r");
  ASSERT_EQ(std::fscanf(file, "%d", &pid), 1);
  std::fclose(file);
  EXPECT_EQ(kill(pid, 0), -1);
}

}  // namespace
}  // namespace citrine
