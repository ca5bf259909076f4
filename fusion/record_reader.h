#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace citrine::fusion {

/// A file as text lines and then, maybe, records of numbers; complaints name the file and the line or byte.
class RecordReader {
 public:
  /// @throws std::runtime_error if the file cannot be read
  explicit RecordReader(const std::string& file);

  /// The next line without its end. @return false at the end of the file
  bool NextLine(std::string& line);
  int line() const { return line_; }
  [[noreturn]] void RefuseLine(const std::string& what) const;

  /// Numbers of a record: where x, y and z begin, and how they are written.
  struct Layout {
    struct Field {
      int offset = -1;  ///< [bytes], or the column if the file is text
      int bytes = 4;    ///< 4 float, 8 double
    };
    Field x, y, z;
    int stride = 0;  ///< [bytes] of a record, or its columns
  };
  /// `count` records from here on, as text or little-endian numbers.
  std::vector<Eigen::Vector3f> Records(std::size_t count, const Layout& layout, bool text);

  std::size_t bytes_left() const { return bytes_.size() - at_; }

 private:
  [[noreturn]] void RefuseByte(const std::string& what) const;

  std::string file_, bytes_;
  std::size_t at_ = 0;
  int line_ = 0;
};

}  // namespace citrine::fusion
