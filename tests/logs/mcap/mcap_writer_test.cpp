#include "logs/mcap/mcap_writer.h"

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine::logs {
namespace {

using ::testing::ElementsAre;

template <class Integer>
Integer NumberAt(const std::string& bytes, std::size_t at) {
  Integer value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);  // the file and this processor are little-endian
  return value;
}

/// CRC-32 (IEEE 802.3) bit by bit.
std::uint32_t Crc(const std::string& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc;
}

struct Record {
  std::uint8_t opcode = 0;
  std::uint64_t start = 0;
  std::string content;
};

class McapFile : public ::testing::Test {
 protected:
  ~McapFile() override { std::filesystem::remove(path_); }

  void Read() {
    std::ifstream in(path_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
    ASSERT_GT(bytes_.size(), 16u);
    ASSERT_EQ(bytes_.substr(0, 8), "\x89MCAP0\r\n");
    ASSERT_EQ(bytes_.substr(bytes_.size() - 8), "\x89MCAP0\r\n");
    for (std::uint64_t at = 8; at < bytes_.size() - 8;) {
      const auto length = NumberAt<std::uint64_t>(bytes_, at + 1);
      ASSERT_LE(at + 9 + length, bytes_.size() - 8);
      records_.push_back({static_cast<std::uint8_t>(bytes_[at]), at, bytes_.substr(at + 9, length)});
      at += 9 + length;
    }
  }
  std::vector<int> Opcodes() const {
    std::vector<int> opcodes;
    for (const Record& record : records_) opcodes.push_back(record.opcode);
    return opcodes;
  }
  const Record& First(int opcode) const {
    for (const Record& record : records_)
      if (record.opcode == opcode) return record;
    throw std::out_of_range("no such record");
  }

  const std::string path_ = ::testing::TempDir() + "citrine_mcap_writer.mcap";
  std::string bytes_;
  std::vector<Record> records_;
};

TEST_F(McapFile, HasDataThenItsSummaryThenWhereToFindIt) {
  McapWriter writer(path_);
  const auto topic = writer.AddTopic({"/a", "protobuf", "a.A", "protobuf", "schema"});
  writer.AddTopic({"/b", "protobuf", "a.A", "protobuf", "schema"});
  writer.Write(topic, 20'000, "hello");
  writer.Attach("note", "text/plain", "abc");
  writer.Describe("mission", {{"seed", "1"}});
  writer.Finish();
  Read();
  EXPECT_THAT(Opcodes(), ElementsAre(0x01, 0x03, 0x04, 0x04, 0x09, 0x0c, 0x06, 0x07, 0x0f,  // data
                                     0x03, 0x04, 0x04, 0x08, 0x0a, 0x0b, 0x0d,              // summary
                                     0x0e, 0x0e, 0x0e, 0x0e, 0x0e, 0x0e, 0x02))
      << "one schema for both topics";
  const Record& footer = records_.back();
  EXPECT_EQ(NumberAt<std::uint64_t>(footer.content, 0), records_[9].start);
  EXPECT_EQ(NumberAt<std::uint64_t>(footer.content, 8), records_[16].start);
}

TEST_F(McapFile, HoldsItsChecksums) {
  McapWriter writer(path_);
  const auto topic = writer.AddTopic({"/a", "protobuf", "a.A", "protobuf", "schema"});
  writer.Write(topic, 20'000, "hello");
  writer.Attach("note", "text/plain", "abc");
  writer.Finish();
  Read();
  const Record& end = First(0x0f);
  EXPECT_EQ(NumberAt<std::uint32_t>(end.content, 0), Crc(bytes_.substr(0, end.start)));
  const Record& attachment = First(0x09);
  const std::size_t covered = attachment.content.size() - 4;
  EXPECT_EQ(NumberAt<std::uint32_t>(attachment.content, covered), Crc(attachment.content.substr(0, covered)));
  const Record& footer = records_.back();
  const auto summary_start = NumberAt<std::uint64_t>(footer.content, 0);
  const std::uint64_t summary_end = footer.start + 9 + 16;  // its own head and both offsets are covered
  EXPECT_EQ(NumberAt<std::uint32_t>(footer.content, 16),
            Crc(bytes_.substr(summary_start, summary_end - summary_start)));
}

TEST_F(McapFile, IsCutIntoChunksThatKnowTheirTimes) {
  McapWriter writer(path_);
  const auto topic = writer.AddTopic({"/a", "protobuf", "a.A", "protobuf", "schema"});
  const std::string data(400'000, 'x');
  for (Utime time = 1; time <= 7; ++time) writer.Write(topic, time, data);
  writer.Finish();
  Read();
  const auto opcodes = Opcodes();
  EXPECT_EQ(std::count(opcodes.begin(), opcodes.end(), 0x06), 3);
  EXPECT_EQ(std::count(opcodes.begin(), opcodes.end(), 0x08), 3);
  EXPECT_EQ(writer.num_messages(), 7u);
  EXPECT_EQ(writer.num_bytes(), bytes_.size());
  const Record& first = First(0x08);
  EXPECT_EQ(NumberAt<std::uint64_t>(first.content, 0), 1000u) << "[ns]";
  EXPECT_EQ(NumberAt<std::uint64_t>(first.content, 8), 3000u);
  const auto chunk_start = NumberAt<std::uint64_t>(first.content, 16);
  EXPECT_EQ(bytes_[chunk_start], 0x06);
  const Record& statistics = First(0x0b);
  EXPECT_EQ(NumberAt<std::uint64_t>(statistics.content, 0), 7u);
}

TEST(McapWriter, FailsWhereNothingCanBeWritten) {
  EXPECT_THROW(McapWriter(::testing::TempDir() + "nowhere/a.mcap"), std::runtime_error);
}

}  // namespace
}  // namespace citrine::logs
