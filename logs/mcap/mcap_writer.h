#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/time.h"
#include "logs/mcap/record.h"

namespace citrine::logs {

/// Writes an MCAP file (https://mcap.dev/spec): zstd chunks with message indices, attachments, metadata, and
/// the summary from which readers seek. The same calls give the same bytes.
class McapWriter {
 public:
  /// What travels on a topic. `schema_data` is what `schema_encoding` asks for; a schema that several topics
  /// name is written once.
  struct Topic {
    std::string name, encoding, schema_name, schema_encoding, schema_data;
  };

  /// @throws std::runtime_error if the file cannot be written
  explicit McapWriter(const std::string& path);
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// @return its number, for Write
  std::uint16_t AddTopic(const Topic& topic);
  /// @throws std::runtime_error if the disk is full
  void Write(std::uint16_t topic, Utime time, const std::string& data);
  void Attach(const std::string& name, const std::string& media_type, const std::string& data);
  void Describe(const std::string& name, const std::map<std::string, std::string>& metadata);

  /// Writes what is still open and the summary; the file is none before.
  /// @throws std::runtime_error if the disk is full
  void Finish();

  std::uint64_t num_messages() const { return num_messages_; }
  std::uint64_t num_bytes() const { return num_bytes_; }

 private:
  using Index = std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>>;

  void Append(const std::string& bytes);
  void CloseChunk();
  void AppendSummary();

  std::string path_;
  std::ofstream file_;
  std::uint64_t num_bytes_ = 0, num_messages_ = 0;
  std::uint32_t crc_ = 0;

  std::string chunk_;
  Index chunk_index_;  ///< [ns] log time and offset in the chunk, by topic
  std::map<std::string, std::uint16_t> schema_ids_;
  std::map<std::uint16_t, std::uint64_t> counts_;
  std::uint64_t first_ns_ = 0, last_ns_ = 0;
  /// Of the summary, in order of opcode.
  std::map<McapRecord::Opcode, std::vector<McapRecord>> summary_;
};

}  // namespace citrine::logs
