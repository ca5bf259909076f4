#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace citrine::logs {

/// One record of an MCAP file while it is put together: little-endian numbers, counted texts
/// (https://mcap.dev/spec).
class McapRecord {
 public:
  enum Opcode : std::uint8_t {
    kHeader = 0x01,
    kFooter = 0x02,
    kSchema = 0x03,
    kChannel = 0x04,
    kMessage = 0x05,
    kChunk = 0x06,
    kMessageIndex = 0x07,
    kChunkIndex = 0x08,
    kAttachment = 0x09,
    kAttachmentIndex = 0x0a,
    kStatistics = 0x0b,
    kMetadata = 0x0c,
    kMetadataIndex = 0x0d,
    kSummaryOffset = 0x0e,
    kDataEnd = 0x0f,
  };

  explicit McapRecord(Opcode opcode) : opcode_(opcode) {}

  template <class Integer>
  McapRecord& Number(Integer value) {
    for (std::size_t i = 0; i < sizeof value; ++i)
      content_.push_back(static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xff));
    return *this;
  }
  McapRecord& Text(const std::string& text) {
    Number(static_cast<std::uint32_t>(text.size()));
    return Bytes(text);
  }
  McapRecord& Bytes(const std::string& bytes) {
    content_ += bytes;
    return *this;
  }
  /// Entries counted in bytes.
  template <class Entries, class Add>
  McapRecord& List(const Entries& entries, const Add& add) {
    McapRecord inner(opcode_);
    for (const auto& entry : entries) add(inner, entry);
    return Text(inner.content_);
  }
  McapRecord& Texts(const std::map<std::string, std::string>& texts) {
    return List(texts,
                [](McapRecord& inner, const auto& entry) { inner.Text(entry.first).Text(entry.second); });
  }

  Opcode opcode() const { return opcode_; }
  const std::string& content() const { return content_; }
  /// As it stands in the file: opcode, length, content.
  std::string Whole() const {
    return McapRecord(opcode_)
        .Number(static_cast<std::uint8_t>(opcode_))
        .Number(std::uint64_t{content_.size()})
        .Bytes(content_)
        .content_;
  }

 private:
  Opcode opcode_;
  std::string content_;
};

}  // namespace citrine::logs
