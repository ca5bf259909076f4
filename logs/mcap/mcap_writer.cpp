#include "logs/mcap/mcap_writer.h"

#include <algorithm>
#include <stdexcept>

#include <zlib.h>
#include <zstd.h>

namespace citrine::logs {
namespace {

using enum McapRecord::Opcode;

constexpr char kMagic[] = "\x89MCAP0\r\n";
constexpr std::size_t kMagicBytes = 8;
constexpr std::size_t kChunkBytes = 1 << 20;  // what a reader has to unpack to reach one message
constexpr int kZstdLevel = 3;
constexpr const char* kCompression = "zstd";

std::uint32_t Crc(const std::string& bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      crc32(before, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

std::string Compress(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), kZstdLevel);
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

std::uint64_t Nanoseconds(Utime time) { return static_cast<std::uint64_t>(time) * 1000; }

}  // namespace

McapWriter::McapWriter(const std::string& path) : path_(path), file_(path, std::ios::binary) {
  Append({kMagic, kMagicBytes});
  Append(McapRecord(kHeader).Text("").Text("citrine").Whole());
}

void McapWriter::Append(const std::string& bytes) {
  crc_ = Crc(bytes, crc_);
  num_bytes_ += bytes.size();
  if (!file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw std::runtime_error("cannot write '" + path_ + "'");
}

std::uint16_t McapWriter::AddTopic(const Topic& topic) {
  const auto [schema, is_new] =
      schema_ids_.try_emplace(topic.schema_name, static_cast<std::uint16_t>(schema_ids_.size() + 1));
  if (is_new) {
    McapRecord record(kSchema);
    record.Number(schema->second).Text(topic.schema_name).Text(topic.schema_encoding).Text(topic.schema_data);
    Append(record.Whole());
    summary_[kSchema].push_back(record);
  }
  const auto id = static_cast<std::uint16_t>(counts_.size() + 1);
  counts_[id] = 0;
  McapRecord record(kChannel);
  record.Number(id).Number(schema->second).Text(topic.name).Text(topic.encoding).Texts({});
  Append(record.Whole());
  summary_[kChannel].push_back(record);
  return id;
}

void McapWriter::Write(std::uint16_t topic, Utime time, const std::string& data) {
  const std::uint64_t time_ns = Nanoseconds(time);
  const auto sequence = static_cast<std::uint32_t>(++counts_.at(topic));
  chunk_index_[topic].emplace_back(time_ns, chunk_.size());
  chunk_ +=
      McapRecord(kMessage).Number(topic).Number(sequence).Number(time_ns).Number(time_ns).Bytes(data).Whole();
  first_ns_ = num_messages_ == 0 ? time_ns : std::min(first_ns_, time_ns);
  last_ns_ = std::max(last_ns_, time_ns);
  ++num_messages_;
  if (chunk_.size() >= kChunkBytes) CloseChunk();
}

void McapWriter::CloseChunk() {
  if (chunk_.empty()) return;
  std::uint64_t first_ns = UINT64_MAX, last_ns = 0;
  for (const auto& [topic, messages] : chunk_index_)
    for (const auto& [time_ns, offset] : messages) {
      first_ns = std::min(first_ns, time_ns);
      last_ns = std::max(last_ns, time_ns);
    }
  const std::string packed = Compress(chunk_);
  const std::uint64_t start = num_bytes_;
  Append(McapRecord(kChunk)
             .Number(first_ns)
             .Number(last_ns)
             .Number(std::uint64_t{chunk_.size()})
             .Number(Crc(chunk_))
             .Text(kCompression)
             .Number(std::uint64_t{packed.size()})
             .Bytes(packed)
             .Whole());
  const std::uint64_t length = num_bytes_ - start;
  std::map<std::uint16_t, std::uint64_t> index_offsets;
  for (const auto& [topic, messages] : chunk_index_) {
    index_offsets[topic] = num_bytes_;
    Append(McapRecord(kMessageIndex)
               .Number(topic)
               .List(messages, [](McapRecord& r, const auto& m) { r.Number(m.first).Number(m.second); })
               .Whole());
  }
  summary_[kChunkIndex].push_back(
      McapRecord(kChunkIndex)
          .Number(first_ns)
          .Number(last_ns)
          .Number(start)
          .Number(length)
          .List(index_offsets, [](McapRecord& r, const auto& o) { r.Number(o.first).Number(o.second); })
          .Number(num_bytes_ - start - length)
          .Text(kCompression)
          .Number(std::uint64_t{packed.size()})
          .Number(std::uint64_t{chunk_.size()}));
  chunk_.clear();
  chunk_index_.clear();
}

void McapWriter::Attach(const std::string& name, const std::string& media_type, const std::string& data) {
  const std::uint64_t start = num_bytes_;
  const std::uint64_t none = 0;  // mission time has no date
  McapRecord record(kAttachment);
  record.Number(none).Number(none).Text(name).Text(media_type).Number(std::uint64_t{data.size()}).Bytes(data);
  record.Number(Crc(record.content()));
  Append(record.Whole());
  summary_[kAttachmentIndex].push_back(McapRecord(kAttachmentIndex)
                                           .Number(start)
                                           .Number(num_bytes_ - start)
                                           .Number(none)
                                           .Number(none)
                                           .Number(std::uint64_t{data.size()})
                                           .Text(name)
                                           .Text(media_type));
}

void McapWriter::Describe(const std::string& name, const std::map<std::string, std::string>& metadata) {
  const std::uint64_t start = num_bytes_;
  Append(McapRecord(kMetadata).Text(name).Texts(metadata).Whole());
  summary_[kMetadataIndex].push_back(
      McapRecord(kMetadataIndex).Number(start).Number(num_bytes_ - start).Text(name));
}

void McapWriter::Finish() {
  CloseChunk();
  Append(McapRecord(kDataEnd).Number(crc_).Whole());
  AppendSummary();
  Append({kMagic, kMagicBytes});
  if (!file_.flush()) throw std::runtime_error("cannot write '" + path_ + "': is the disk full?");
}

void McapWriter::AppendSummary() {
  const auto number_of = [&](McapRecord::Opcode opcode) {
    return static_cast<std::uint32_t>(summary_[opcode].size());
  };
  summary_[kStatistics].push_back(
      McapRecord(kStatistics)
          .Number(num_messages_)
          .Number(static_cast<std::uint16_t>(number_of(kSchema)))
          .Number(number_of(kChannel))
          .Number(number_of(kAttachmentIndex))
          .Number(number_of(kMetadataIndex))
          .Number(number_of(kChunkIndex))
          .Number(first_ns_)
          .Number(last_ns_)
          .List(counts_, [](McapRecord& r, const auto& c) { r.Number(c.first).Number(c.second); }));
  const std::uint64_t start = num_bytes_;
  crc_ = 0;  // of the summary from here on
  std::vector<McapRecord> offsets;
  for (const auto& [opcode, records] : summary_) {
    const std::uint64_t group_start = num_bytes_;
    for (const McapRecord& record : records) Append(record.Whole());
    offsets.push_back(McapRecord(kSummaryOffset)
                          .Number(static_cast<std::uint8_t>(opcode))
                          .Number(group_start)
                          .Number(num_bytes_ - group_start));
  }
  const std::uint64_t offsets_start = num_bytes_;
  for (const McapRecord& record : offsets) Append(record.Whole());
  McapRecord footer(kFooter);
  footer.Number(start).Number(offsets_start).Number(std::uint32_t{0});
  const std::string whole = footer.Whole();
  Append(whole.substr(0, whole.size() - sizeof(std::uint32_t)));
  Append(McapRecord(kFooter).Number(crc_).content());
}

}  // namespace citrine::logs
