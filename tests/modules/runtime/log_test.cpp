#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <lcm/eventlog.h>

#include "modules/channels.h"
#include "modules/runtime/log_digest.h"
#include "modules/runtime/log_reader.h"
#include "modules/runtime/log_writer.h"

namespace citrine {
namespace {

class LogTest : public testing::Test {
 protected:
  LogTest() { std::filesystem::create_directories(folder_); }
  ~LogTest() override { std::filesystem::remove_all(folder_); }

  static LogEvent Event(const std::string& channel, Utime utime, std::int64_t seq) {
    citrine_lcm::uav_state_t message{};
    message.utime = utime;
    message.seq = seq;
    return {utime, channel, Bus::ToBytes(message)};
  }
  std::string Write(const std::string& name, const std::vector<LogEvent>& events) const {
    LogWriter writer(folder_ + "/" + name);
    for (const LogEvent& event : events) writer.Write(event);
    return folder_ + "/" + name;
  }

  const std::string folder_ = testing::TempDir() + "citrine_log_test_" +
                              testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::vector<LogEvent> events_ = {Event("A", 0, 1), Event("UAV1_STATE", 0, 1), Event("A", 20, 2),
                                         Event("B", 20, 1)};
};

TEST_F(LogTest, ReadsBackWhatWasWritten) {
  LogReader reader(Write("log", events_));
  for (const LogEvent& event : events_) {
    const auto read = reader.Next();
    ASSERT_TRUE(read);
    EXPECT_TRUE(*read == event);
    EXPECT_EQ(read->time, event.utime());
  }
  EXPECT_FALSE(reader.Next());
  EXPECT_EQ(reader.damaged(), 0);
}

TEST_F(LogTest, IsReadByLcmItself) {
  const std::string path = Write("log", events_);
  lcm_eventlog_t* log = lcm_eventlog_create(path.c_str(), "r");
  ASSERT_TRUE(log);
  for (std::size_t i = 0; i < events_.size(); ++i) {
    lcm_eventlog_event_t* event = lcm_eventlog_read_next_event(log);
    ASSERT_TRUE(event);
    EXPECT_EQ(event->eventnum, static_cast<std::int64_t>(i));
    EXPECT_EQ(event->timestamp, events_[i].utime());
    EXPECT_EQ(std::string(event->channel, static_cast<std::size_t>(event->channellen)), events_[i].channel);
    EXPECT_EQ(event->datalen, static_cast<int>(events_[i].bytes.size()));
    lcm_eventlog_free_event(event);
  }
  EXPECT_FALSE(lcm_eventlog_read_next_event(log));
  lcm_eventlog_destroy(log);
}

TEST_F(LogTest, GetsPastDamage) {
  const std::string path = Write("log", events_);
  std::string bytes;
  {
    std::ifstream file(path, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  const std::size_t second = 28 + 1 + events_[0].bytes.size();
  bytes[second + 1] ^= 0x55;       // the second event's sync word
  bytes.resize(bytes.size() - 3);  // the last event is cut short
  std::ofstream(path, std::ios::binary) << bytes;
  LogReader reader(path);
  EXPECT_TRUE(*reader.Next() == events_[0]);
  EXPECT_TRUE(*reader.Next() == events_[2]);
  EXPECT_FALSE(reader.Next());
  EXPECT_EQ(reader.damaged(), 2);
}

TEST_F(LogTest, SaysNothingOfAnEmptyLogAndThrowsForNone) {
  EXPECT_FALSE(LogReader(Write("empty", {})).Next());
  EXPECT_THROW(LogReader(folder_ + "/none"), std::runtime_error);
  EXPECT_THROW(LogWriter(folder_ + "/no/such/folder"), std::runtime_error);
}

TEST_F(LogTest, GoesOnInPartsThatEachSayWhatIsFlown) {
  citrine_lcm::mission_config_t flown{};
  flown.mission_id = "m";
  const LogEvent config{0, "MISSION_CONFIG", Bus::ToBytes(flown)};
  std::vector<LogEvent> written = {config};
  {
    LogWriter writer(folder_ + "/log", {1000, 0});
    writer.Write(config);
    for (int i = 1; i <= 40; ++i) {
      written.push_back(Event("A", 20 * i, i));
      writer.Write(written.back());
    }
    writer.Flush();
    EXPECT_EQ(writer.num_events(), 41);
  }
  const auto parts = LogFiles(folder_ + "/log");
  ASSERT_GT(parts.size(), 3u);
  EXPECT_EQ(parts.front(), folder_ + "/log.000");
  for (const std::string& part : parts) EXPECT_EQ(LogReader(part).Next()->channel, "MISSION_CONFIG") << part;
  EXPECT_EQ(ReadInOrder(folder_ + "/log"), written);
}

TEST_F(LogTest, KeepsTheNewestPartsAlone) {
  {
    LogWriter writer(folder_ + "/log", {500, 2});
    for (int i = 1; i <= 40; ++i) writer.Write(Event("A", 20 * i, i));
  }
  const auto parts = LogFiles(folder_ + "/log");
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_GT(parts.front(), folder_ + "/log.003");
  EXPECT_EQ(ReadInOrder(folder_ + "/log").back().seq(), 40);
}

TEST_F(LogTest, SaysWhereThePartsAreDamaged) {
  {
    LogWriter writer(folder_ + "/log", {300, 0});
    for (int i = 1; i <= 6; ++i) writer.Write(Event("A", 20 * i, i));
  }
  const std::string second = LogFiles(folder_ + "/log").at(1);
  std::filesystem::resize_file(second, std::filesystem::file_size(second) - 3);
  LogReader reader(folder_ + "/log");
  int events = 0;
  while (reader.Next()) ++events;
  EXPECT_EQ(events, 5);
  ASSERT_EQ(reader.damaged(), 1);
  EXPECT_EQ(reader.damages()[0].file, second);
}

TEST_F(LogTest, PutsARecordingInOrderWithoutRepetitionsAndProbes) {
  std::vector<LogEvent> recorded = events_;
  std::reverse(recorded.begin(), recorded.end());
  recorded.push_back(events_[1]);
  recorded.push_back({7, "LCM_SELF_TEST", {'l', 'c', 'm'}});
  recorded.push_back({8, "BUS_PROBE", {'1', '@', '2'}});
  RecordingFlaws flaws;
  EXPECT_EQ(PutInOrder(Write("recording", recorded), folder_ + "/log", &flaws), 4);
  EXPECT_EQ(flaws.repeated, 1);
  EXPECT_EQ(flaws.damaged, 0);
  EXPECT_EQ(flaws.missing, 0);
  const auto read = ReadInOrder(folder_ + "/log");
  EXPECT_EQ(read, events_);
}

TEST_F(LogTest, TellsWhatTheRecorderDidNotHear) {
  auto recorded = events_;
  recorded.push_back(Event("A", 40, 5));
  RecordingFlaws flaws;
  ReadInOrder(Write("recording", recorded), &flaws);
  EXPECT_EQ(flaws.missing, 2);
}

TEST_F(LogTest, HasADigestOfChannelsAndPayloadsButNotOfTheHost) {
  const auto digest = [](const std::vector<LogEvent>& events) {
    LogDigest d;
    for (const LogEvent& event : events) d.Add(event);
    return d.value();
  };
  Digest by_hand;
  for (const LogEvent& event : events_) {
    by_hand.Add((event.channel + '\0').data(), event.channel.size() + 1);
    by_hand.Add(event.bytes.data(), event.bytes.size());
  }
  EXPECT_EQ(digest(events_), by_hand.value());
  auto other = events_;
  other.push_back(Event("MODULE_HEALTH", 20, 1));
  other.push_back(Event("MISSION_CONFIG", 20, 1));
  EXPECT_EQ(digest(other), digest(events_));
  other.push_back(Event("C", 20, 1));
  EXPECT_NE(digest(other), digest(events_));
}

}  // namespace
}  // namespace citrine
