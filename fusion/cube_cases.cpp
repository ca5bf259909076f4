#include "fusion/cube_cases.h"

#include <algorithm>
#include <utility>

namespace citrine::fusion {
namespace {

using Face = std::array<int, 4>;  // its corners, counter-clockwise seen from outside the cube

constexpr std::array<Face, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

CubeEdge Between(int a, int b) {
  const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  return {std::min(a, b), axis};
}

std::vector<CubeTriangle> Triangles(int inside) {
  const auto is_inside = [&](int corner) { return (inside >> corner & 1) != 0; };
  // Each run of inside corners of a face is cut off by a segment, from where the run begins to where it ends.
  std::vector<std::pair<CubeEdge, CubeEdge>> segments;
  for (const Face& face : kFaces)
    for (int begin = 0; begin < 4; ++begin) {
      if (is_inside(face[begin]) || !is_inside(face[(begin + 1) % 4])) continue;
      int end = (begin + 1) % 4;
      while (is_inside(face[(end + 1) % 4])) end = (end + 1) % 4;
      segments.push_back(
          {Between(face[begin], face[(begin + 1) % 4]), Between(face[end], face[(end + 1) % 4])});
    }
  std::vector<CubeTriangle> triangles;
  while (!segments.empty()) {
    std::vector<CubeEdge> loop{segments.back().first};
    CubeEdge next = segments.back().second;
    segments.pop_back();
    while (next != loop.front()) {
      loop.push_back(next);
      const auto on =
          std::find_if(segments.begin(), segments.end(), [&](const auto& s) { return s.first == next; });
      next = on->second;
      segments.erase(on);
    }
    for (std::size_t i = 2; i < loop.size(); ++i) triangles.push_back({loop[0], loop[i - 1], loop[i]});
  }
  return triangles;
}

}  // namespace

const std::array<std::vector<CubeTriangle>, 256>& CubeCases() {
  static const auto cases = [] {
    std::array<std::vector<CubeTriangle>, 256> all;
    for (int inside = 0; inside < 256; ++inside) all[inside] = Triangles(inside);
    return all;
  }();
  return cases;
}

}  // namespace citrine::fusion
