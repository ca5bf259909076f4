#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "viz/image.h"

namespace citrine::viz {

using Pixel = Eigen::Vector2d;  ///< x to the right, y down, from the centre of the top left pixel

/// A picture of the ground plane seen from above, north (world y) up, and a strip for text on its right.
/// Everything is anti-aliased and may lie outside: what does is cut off.
class Canvas {
 public:
  enum class Align { kLeft, kCentre, kRight };
  /// The map part of a picture of 1920 by 1080, the strip beside it.
  inline static const Pixel kFullHdMap_px{1520, 1080};

  /// @param area_W [m] what the map part shows
  Canvas(const Eigen::AlignedBox2d& area_W, double pixels_per_m);

  Pixel ToPixel(const Eigen::Vector2d& p_W) const;
  Pixel ToPixel(const Eigen::Vector3d& p_W) const { return ToPixel(Eigen::Vector2d(p_W.head<2>())); }
  std::vector<Pixel> ToPixels(const std::vector<Eigen::Vector3d>& points_W) const;
  double pixels_per_m() const { return pixels_per_m_; }
  /// Size of text and marks relative to a picture of 1080 rows.
  double scale() const { return scale_; }
  Eigen::AlignedBox2d map_px() const;
  Eigen::AlignedBox2d strip_px() const;

  void Polyline(const std::vector<Pixel>& points, Colour colour, double width_px, double opacity = 1);
  /// Every other `dash_px` of the way.
  void Dashes(const std::vector<Pixel>& points, Colour colour, double width_px, double dash_px);
  void Disc(const Pixel& centre, double radius_px, Colour colour, double opacity = 1);
  void Ring(const Pixel& centre, double radius_px, Colour colour, double width_px, double opacity = 1);
  void Fill(const Eigen::AlignedBox2d& box, Colour colour, double opacity = 1);
  void Outline(const Eigen::AlignedBox2d& box, Colour colour, double width_px);

  /// Text whose capitals are `height_px` high, standing on `at`.
  void Text(const Pixel& at, const std::string& text, Colour colour, double height_px,
            Align align = Align::kLeft, bool bold = false);

  /// Lays a picture of one pixel a cell over the map, north up, each cell `cell_m` wide from `corner_W`
  /// (lower left).
  /// @param cover one a cell, how much of it hides what lies below; row by row from the top as `cells`
  void Lay(const Image& cells, const std::vector<float>& cover, const Eigen::Vector2d& corner_W,
           double cell_m);

  const Image& image() const { return image_; }

 private:
  template <class Draw>
  void Blend(const Eigen::AlignedBox2d& box, double opacity, const Draw& draw);

  Eigen::AlignedBox2d area_W_;
  double pixels_per_m_;
  double scale_ = 1;
  double map_width_ = 0;
  Image image_;
};

}  // namespace citrine::viz
