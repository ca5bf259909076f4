#include "viz/mesh_picture.h"

#include <gtest/gtest.h>

namespace citrine::viz {
namespace {

/// A square of 2 m at height z, its face up (counter-clockwise from above) or down.
void AddSquare(TriMesh& mesh, float z, bool up) {
  const int first = static_cast<int>(mesh.vertices_W.size());
  for (const auto& [x, y] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}})
    mesh.vertices_W.emplace_back(x, y, z);
  for (const auto& t : {std::array{0, 1, 2}, std::array{0, 2, 3}})
    mesh.triangles.push_back(up ? std::array{first + t[0], first + t[1], first + t[2]}
                                : std::array{first + t[0], first + t[2], first + t[1]});
}

MeshView FromAbove() {
  MeshView view;
  view.elevation_rad = EIGEN_PI / 2;
  view.width = view.height = 100;
  return view;
}

TEST(MeshPicture, FillsThePictureAndLeavesAMargin) {
  TriMesh mesh;
  AddSquare(mesh, 0, true);
  MeshView view = FromAbove();
  view.azimuth_rad = 0;
  const Image image = DrawMesh(mesh, view);
  EXPECT_NE(image.ColourAt(5, 50), image.ColourAt(1, 50));
  EXPECT_EQ(image.ColourAt(5, 50), image.ColourAt(50, 50));
}

TEST(MeshPicture, ShowsWhatIsNearerWhateverTheOrderOfTheTriangles) {
  TriMesh top_last, top_first;
  AddSquare(top_last, 0, true);
  AddSquare(top_last, 1, false);
  AddSquare(top_first, 1, false);
  AddSquare(top_first, 0, true);
  TriMesh top;
  AddSquare(top, 1, false);
  const Colour expected = DrawMesh(top, FromAbove()).ColourAt(50, 50);
  EXPECT_EQ(DrawMesh(top_last, FromAbove()).ColourAt(50, 50), expected);
  EXPECT_EQ(DrawMesh(top_first, FromAbove()).ColourAt(50, 50), expected);
}

TEST(MeshPicture, DrawsABackDifferentlyFromAFront) {
  TriMesh front, back;
  AddSquare(front, 0, true);
  AddSquare(back, 0, false);
  EXPECT_NE(DrawMesh(front, FromAbove()).ColourAt(50, 50), DrawMesh(back, FromAbove()).ColourAt(50, 50));
}

TEST(MeshPicture, OfNothingIsEmpty) {
  const Image image = DrawMesh({}, FromAbove());
  EXPECT_EQ(image.ColourAt(50, 50), image.ColourAt(0, 0));
}

}  // namespace
}  // namespace citrine::viz
