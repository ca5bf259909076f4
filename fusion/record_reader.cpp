#include "fusion/record_reader.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace citrine::fusion {

RecordReader::RecordReader(const std::string& file) : file_(file) {
  std::ifstream in(file, std::ios::binary);
  if (in) bytes_.assign(std::istreambuf_iterator<char>(in), {});
  if (!in || in.bad()) throw std::runtime_error(file + ": cannot be read");
}

void RecordReader::RefuseLine(const std::string& what) const {
  throw std::runtime_error(file_ + ":" + std::to_string(line_) + ": " + what);
}
void RecordReader::RefuseByte(const std::string& what) const {
  throw std::runtime_error(file_ + ": " + what + " at byte " + std::to_string(at_));
}

bool RecordReader::NextLine(std::string& line) {
  if (at_ >= bytes_.size()) return false;
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  line = bytes_.substr(at_, end - at_);
  if (!line.empty() && line.back() == '\r') line.pop_back();
  at_ = std::min(end + 1, bytes_.size());
  ++line_;
  return true;
}

std::vector<Eigen::Vector3f> RecordReader::Records(std::size_t count, const Layout& layout, bool text) {
  std::vector<Eigen::Vector3f> points;
  const auto keep = [&](double x, double y, double z) {
    const Eigen::Vector3f p(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    if (p.allFinite()) points.push_back(p);
  };
  if (!text) {
    const auto stride = static_cast<std::size_t>(layout.stride);
    if (count > bytes_left() / stride)
      RefuseByte("the file is cut short: " + std::to_string(count) + " points are announced, " +
                 std::to_string(bytes_left() / stride) + " follow");
    const auto number = [&](const char* record, const Layout::Field& field) {
      float single = 0;
      double twice = 0;
      std::memcpy(field.bytes == 4 ? static_cast<void*>(&single) : &twice, record + field.offset,
                  static_cast<std::size_t>(field.bytes));
      return field.bytes == 4 ? static_cast<double>(single) : twice;
    };
    for (std::size_t i = 0; i < count; ++i, at_ += stride)
      keep(number(&bytes_[at_], layout.x), number(&bytes_[at_], layout.y), number(&bytes_[at_], layout.z));
    return points;
  }
  std::string line;
  for (std::size_t i = 0; i < count; ++i) {
    if (!NextLine(line)) {
      ++line_;
      RefuseLine("the file is cut short: " + std::to_string(count) + " points are announced, " +
                 std::to_string(i) + " follow");
    }
    std::vector<double> columns;
    std::istringstream in(line);
    for (std::string word; in >> word;) {
      char* end = nullptr;
      columns.push_back(std::strtod(word.c_str(), &end));
      if (*end != '\0') RefuseLine("\"" + word + "\" is no number");
    }
    if (static_cast<int>(columns.size()) != layout.stride)
      RefuseLine(std::to_string(columns.size()) + " numbers, " + std::to_string(layout.stride) +
                 " are expected");
    keep(columns[layout.x.offset], columns[layout.y.offset], columns[layout.z.offset]);
  }
  return points;
}

}  // namespace citrine::fusion
