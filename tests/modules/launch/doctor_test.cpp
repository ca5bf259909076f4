#include <chrono>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/citrine_command.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kBusUp = "ip link set lo up multicast on; ip route add 224.0.0.0/4 dev lo; ";

/// What people need to be told, each provoked for real in a network (and file systems) of its own.
class Doctor : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PrivateNetworksAllowed()) GTEST_SKIP() << "this host allows no private networks";
  }
  CommandResult InPrivate(const std::string& line) const {
    return RunCommandLine(
        "unshare -rnm bash " +
        scratch_.Write("line.sh", "unset LCM_DEFAULT_URL\nlaunch=" CITRINE_BIN_DIR "/launch\n" + line));
  }
  const ScratchFolder scratch_;
  const fs::path out_ = scratch_.path() / "run";
};

TEST_F(Doctor, IsContentWithABusThatHearsItself) {
  const CommandResult doctor = InPrivate(std::string(kBusUp) + "$launch doctor");
  EXPECT_THAT(doctor.output, HasSubstr("hears itself\n"));
  EXPECT_THAT(doctor.output, HasSubstr("no other mission is on it\n"));
  EXPECT_THAT(doctor.output, Not(HasSubstr("FAIL  the bus")));
}

TEST_F(Doctor, NamesTheMissingRouteAndTheCommandThatMendsIt) {
  const CommandResult doctor = InPrivate("$launch doctor");
  EXPECT_EQ(doctor.exit_code, 2);
  EXPECT_THAT(doctor.output, HasSubstr("FAIL  no multicast route: modules cannot hear each other"));
  EXPECT_THAT(doctor.output,
              HasSubstr("mend: sudo ip link set lo multicast on && sudo ip route add 224.0.0.0/4 dev lo"));
}

TEST_F(Doctor, EveryToolThatListensNamesTheMissingRouteInTwoLines) {
  const std::string expected =
      "citrine: no multicast route.\n  mend: sudo ip link set lo multicast on && sudo ip route add "
      "224.0.0.0/4 "
      "dev lo\n";
  for (const char* command : {"top", "echo CLOCK", "replay " CITRINE_SOURCE_DIR "/logs/golden/smoke"}) {
    const CommandResult listen = InPrivate(std::string("$launch ") + command);
    EXPECT_EQ(listen.exit_code, 2) << command;
    EXPECT_EQ(listen.output, expected) << command;
  }
  const CommandResult module = InPrivate(std::string(CITRINE_BIN_DIR) +
                                         "/map_fusion -O mission.volume_min_m=[0,0,0] -O "
                                         "mission.volume_max_m=[5,5,5]");
  EXPECT_EQ(module.exit_code, 2);
  EXPECT_THAT(module.output, ContainsRegex("^map_fusion: cannot open the bus .*multicast route.*\n$"));
}

TEST_F(Doctor, NamesADisplayThatDoesNotAnswerAndRunRefusesItBeforeItFlies) {
  EXPECT_THAT(InPrivate("unset DISPLAY WAYLAND_DISPLAY; $launch doctor").output,
              HasSubstr("warn  no window for --view: there is no display"));
  EXPECT_THAT(InPrivate("DISPLAY=:1234 $launch doctor").output,
              HasSubstr("warn  no window for --view: the display ':1234' does not answer"));
  const std::string run =
      "DISPLAY=:1234 $launch run smoke --in-process --view --out " + out_.string() + "_view";
  const CommandResult refused = InPrivate(run);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.output,
            "citrine: no window for --view: the display ':1234' does not answer; --video needs none\n"
            "  mend: ssh -X, or xvfb-run -a ./citrine run MISSION --view\n");
  EXPECT_FALSE(fs::exists(out_.string() + "_view"));
}

TEST_F(Doctor, NamesWhoHoldsThePort) {
  const std::string hold =
      "perl -MIO::Socket::INET -e '$s = IO::Socket::INET->new(LocalPort => 7667, Proto => \"udp\"); "
      "sleep 60' & held=$!; sleep 1; ";
  const CommandResult doctor =
      InPrivate(std::string(kBusUp) + hold + "$launch doctor; code=$?; kill $held; exit $code");
  EXPECT_EQ(doctor.exit_code, 2);
  EXPECT_THAT(doctor.output, ContainsRegex("is deaf: UDP port 7667 is held by \"perl\" \\(pid [0-9]+\\)"));
  const CommandResult run = InPrivate(std::string(kBusUp) + hold + "$launch run smoke --out " +
                                      out_.string() + "; code=$?; kill $held; exit $code");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("mend: stop it, or export LCM_DEFAULT_URL="));
}

TEST_F(Doctor, NamesAnotherMissionOnTheBusAndRunRefusesIt) {
  const std::string run = "$launch run smoke --out " + out_.string();
  const CommandResult both =
      InPrivate(std::string(kBusUp) + run + " >/dev/null 2>&1 & launcher=$!; sleep 6; $launch doctor; " +
                run + "2; echo refused with $?; " + run +
                " --in-process; echo again with $?; kill -INT $launcher; wait $launcher");
  EXPECT_THAT(both.output, HasSubstr("warn  another mission, smoke-quality_adaptive-1, is on the bus"));
  EXPECT_THAT(both.output, HasSubstr("citrine: another mission, smoke-quality_adaptive-1, is on the bus"));
  EXPECT_THAT(both.output, HasSubstr("refused with 2"));
  EXPECT_THAT(both.output, HasSubstr("another mission flies into this folder; choose another with --out"));
  EXPECT_THAT(both.output, HasSubstr("again with 2"));
}

TEST_F(Doctor, NamesASmallReceiveBuffer) {
  const CommandResult doctor = InPrivate(
      "limit=$(mktemp); echo 212992 > $limit; mount --bind $limit /proc/sys/net/core/rmem_max || exit 77; " +
      std::string(kBusUp) + "$launch doctor; rm $limit");
  if (doctor.exit_code == 77) GTEST_SKIP() << "this host allows no file systems of one's own";
  EXPECT_THAT(doctor.output,
              HasSubstr("receive buffer limit is 212992 bytes: bursts on the bus may be lost"));
  EXPECT_THAT(doctor.output, HasSubstr("mend: sudo sysctl -w net.core.rmem_max=4194304"));
  const CommandResult run = InPrivate(
      "limit=$(mktemp); echo 212992 > $limit; mount --bind $limit /proc/sys/net/core/rmem_max; "
      "$launch run smoke --isolate --set mission.time_limit_s=1 --out " +
      out_.string() + "; rm $limit");
  EXPECT_THAT(run.output, HasSubstr("citrine: receive buffer limit is 212992 bytes"));
}

TEST_F(Doctor, RunFliesInOneProcessWhereNoNetworkIsAllowed) {
  const CommandResult run = InPrivate(
      "echo 0 > /proc/sys/user/max_net_namespaces; echo 0 > /proc/sys/user/max_user_namespaces; "
      "$launch doctor; $launch run smoke --set mission.time_limit_s=2 --out " +
      out_.string());
  EXPECT_THAT(run.output, HasSubstr("--isolate is refused here: it will fly in process"));
  EXPECT_THAT(run.output, HasSubstr("no multicast route, so other terminals cannot hear this mission"));
  EXPECT_THAT(run.output, HasSubstr("flying in process, in lockstep"));
  EXPECT_TRUE(fs::exists(out_ / "metrics.json")) << run.output;
}

TEST_F(Doctor, NamesAFullDiskBeforeTheMissionStarts) {
  const std::string disk = scratch_.path() / "disk";
  const CommandResult run =
      InPrivate("mkdir -p " + disk + "; mount -t tmpfs -o size=20m none " + disk +
                " || exit 77; $launch run smoke --in-process --set mission.time_limit_s=300 --set "
                "quality.d_star_m=100 --out " +
                disk + "/run");
  if (run.exit_code == 77) GTEST_SKIP() << "this host allows no file systems of one's own";
  EXPECT_THAT(run.output,
              ContainsRegex("disk: [0-9]+ MB free in .*; the log may take 120 MB until the time limit"));
}

TEST_F(Doctor, SaysWhatSpyNeeds) {
  const CommandResult no_display = InPrivate("unset DISPLAY; $launch spy");
  EXPECT_EQ(no_display.exit_code, 2);
  EXPECT_THAT(no_display.output, ContainsRegex("spy: needs .*for a terminal view use: ./citrine top"));
  const CommandResult dead_display = InPrivate("DISPLAY=:1234 $launch spy");
  EXPECT_EQ(dead_display.exit_code, 2);
  EXPECT_THAT(dead_display.output, ContainsRegex("^citrine: spy: needs .*\n$"));
  const CommandResult no_java = InPrivate(
      "folder=$(mktemp -d); ln -s $(command -v dpkg-query) $folder; PATH=$folder $launch spy; code=$?; "
      "rm -r $folder; exit $code");
  EXPECT_EQ(no_java.exit_code, 2);
  EXPECT_THAT(no_java.output, ContainsRegex("spy: needs (java|liblcm-java|libjchart2d-java)"));
  const CommandResult nothing = InPrivate("PATH=/nowhere $launch spy");
  EXPECT_THAT(nothing.output,
              HasSubstr("spy: needs liblcm-java libjchart2d-java\n  mend: sudo apt-get install"));
}

TEST_F(Doctor, NamesTypesThatAreNewerThanTheJarOfSpy) {
  const fs::path jar = fs::path(CITRINE_BIN_DIR).parent_path() / "share/java/citrine-types.jar";
  const std::string with_display = "xvfb-run -a $launch doctor";
  if (InPrivate(with_display).output.find("lcm-spy: java") == std::string::npos)
    GTEST_SKIP() << "Java, lcm-spy or the jar of types is not there (packages-tools.txt)";
  const auto written = fs::last_write_time(jar);
  fs::last_write_time(
      jar, fs::last_write_time(CITRINE_SOURCE_DIR "/lcmtypes/path_t.lcm") - std::chrono::seconds(1));
  const CommandResult doctor = InPrivate(with_display);
  fs::last_write_time(jar, written);
  EXPECT_THAT(doctor.output, ContainsRegex("warn  spy: .*path_t.*: newer than .*citrine-types.jar"));
  EXPECT_THAT(doctor.output, HasSubstr("mend: ./citrine spy builds it anew"));
}

TEST_F(Doctor, NamesABrokerThatIsNotThere) {
  const CommandResult module =
      InPrivate("ip link set lo up; " + std::string(CITRINE_BIN_DIR) +
                "/topdown_renderer -l tcpq://127.0.0.1:7999 -O mission.volume_min_m=[0,0,0] "
                "-O mission.volume_max_m=[5,5,5]");
  EXPECT_EQ(module.exit_code, 2) << module.output;
  EXPECT_THAT(module.output, HasSubstr("start its broker first"));
}

}  // namespace
}  // namespace citrine
