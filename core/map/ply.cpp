#include "core/map/ply.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace citrine {
namespace {

template <class T>
void Put(std::vector<char>& bytes, const T& value) {
  const char* from = reinterpret_cast<const char*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof value);
}

/// Bytes of a file from the front, with complaints that say where.
class Cursor {
 public:
  explicit Cursor(const std::string& path) : path_(path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::runtime_error(path + ": cannot be opened");
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
  }
  [[noreturn]] void Refuse(const std::string& what) const {
    throw std::runtime_error(path_ + ": " + what + " at byte " + std::to_string(at_));
  }
  std::string Line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string::npos) Refuse("the header does not end");
    std::string line = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }
  void Expect(const std::string& line) {
    const std::size_t at = at_;
    if (Line() == line) return;
    at_ = at;
    Refuse("\"" + line + "\" is expected");
  }
  /// Number of elements in a line "element <name> <count>".
  std::size_t Count(const std::string& name) {
    const std::size_t at = at_;
    std::istringstream line(Line());
    std::string element, named;
    long long count = -1;
    if (line >> element >> named >> count && element == "element" && named == name && count >= 0)
      return static_cast<std::size_t>(count);
    at_ = at;
    Refuse("\"element " + name + " <count>\" is expected");
  }
  template <class T>
  T Take() {
    if (left() < sizeof(T)) Refuse("the file is cut short");
    T value;
    std::memcpy(&value, &bytes_[at_], sizeof value);
    at_ += sizeof value;
    return value;
  }
  bool NextIs(const std::string& text) const { return bytes_.compare(at_, text.size(), text) == 0; }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string path_, bytes_;
  std::size_t at_ = 0;
};

}  // namespace

void WritePly(const std::string& path, const TriMesh& mesh) {
  const bool confident = !mesh.confidence.empty();
  std::ostringstream header;
  header << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.vertices_W.size()
         << "\nproperty float x\nproperty float y\nproperty float z\n"
         << (confident ? "property float confidence\n" : "") << "element face " << mesh.triangles.size()
         << "\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string text = header.str();
  std::vector<char> bytes(text.begin(), text.end());
  for (std::size_t i = 0; i < mesh.vertices_W.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) Put(bytes, mesh.vertices_W[i][axis]);
    if (confident) Put(bytes, mesh.confidence[i]);
  }
  for (const auto& triangle : mesh.triangles) {
    Put(bytes, std::uint8_t{3});
    for (const int vertex : triangle) Put(bytes, static_cast<std::int32_t>(vertex));
  }
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

TriMesh ReadPly(const std::string& path) {
  Cursor file(path);
  file.Expect("ply");
  file.Expect("format binary_little_endian 1.0");
  const std::size_t num_vertices = file.Count("vertex");
  for (const char* axis : {"x", "y", "z"}) file.Expect(std::string("property float ") + axis);
  const bool confident = file.NextIs("property float confidence");
  if (confident) file.Line();
  const std::size_t num_triangles = file.Count("face");
  file.Expect("property list uchar int vertex_indices");
  file.Expect("end_header");
  constexpr std::size_t kTriangleBytes = 13;
  const std::size_t vertex_bytes = confident ? 16 : 12;
  if (num_vertices > file.left() / vertex_bytes ||
      num_triangles > (file.left() - num_vertices * vertex_bytes) / kTriangleBytes)
    file.Refuse("fewer bytes than the header says follow");

  TriMesh mesh;
  for (std::size_t i = 0; i < num_vertices; ++i) {
    Eigen::Vector3f p_W;
    for (int axis = 0; axis < 3; ++axis) p_W[axis] = file.Take<float>();
    if (!p_W.allFinite()) file.Refuse("vertex " + std::to_string(i) + " is not finite");
    mesh.vertices_W.push_back(p_W);
    if (confident) mesh.confidence.push_back(file.Take<float>());
  }
  for (std::size_t i = 0; i < num_triangles; ++i) {
    if (file.Take<std::uint8_t>() != 3) file.Refuse("face " + std::to_string(i) + " is no triangle");
    std::array<int, 3> triangle;
    for (int& vertex : triangle) {
      vertex = file.Take<std::int32_t>();
      if (vertex < 0 || static_cast<std::size_t>(vertex) >= num_vertices)
        file.Refuse("face " + std::to_string(i) + " names a vertex that does not exist");
    }
    mesh.triangles.push_back(triangle);
  }
  if (file.left() != 0) file.Refuse("more bytes than the header says follow");
  return mesh;
}

}  // namespace citrine
