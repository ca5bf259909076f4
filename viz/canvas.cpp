#include "viz/canvas.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "viz/palette.h"

namespace citrine::viz {

namespace {

constexpr int kShift = 4;  // OpenCV takes coordinates in sixteenths of a pixel
constexpr double kStripWidth_px = 400;
constexpr int kRowsMin = 720;

cv::Mat View(Image& image) { return {image.height, image.width, CV_8UC3, image.bgr.data()}; }

cv::Scalar ToScalar(Colour colour) { return {double(colour.b), double(colour.g), double(colour.r)}; }

cv::Point ToPoint(const Pixel& p) {
  const double limit = 1e6;  // keeps what lies far outside within OpenCV's integers
  return {static_cast<int>(std::lround(std::clamp(p.x(), -limit, limit) * (1 << kShift))),
          static_cast<int>(std::lround(std::clamp(p.y(), -limit, limit) * (1 << kShift)))};
}

int Thickness(double width_px) { return std::max(1, static_cast<int>(std::lround(width_px))); }

/// Video codecs want it. What rounding has added to a whole number is not rounded up.
int Even(double pixels) { return 2 * static_cast<int>(std::ceil(pixels / 2 - 1e-6)); }

Eigen::AlignedBox2d Around(const Pixel& centre, double radius) {
  return {centre - Pixel::Constant(radius), centre + Pixel::Constant(radius)};
}

}  // namespace

Canvas::Canvas(const Eigen::AlignedBox2d& area_W, double pixels_per_m)
    : area_W_(area_W), pixels_per_m_(pixels_per_m) {
  const int rows = std::max(kRowsMin, Even(area_W.sizes().y() * pixels_per_m));
  scale_ = std::max(rows / 1080.0, 0.72);
  map_width_ = Even(area_W.sizes().x() * pixels_per_m);
  image_ = Image(static_cast<int>(map_width_) + Even(kStripWidth_px * scale_), rows, kUnknown);
}

Pixel Canvas::ToPixel(const Eigen::Vector2d& p_W) const {
  const double below =
      (image_.height - area_W_.sizes().y() * pixels_per_m_) / 2;  // the map part stands in the middle
  return {(p_W.x() - area_W_.min().x()) * pixels_per_m_ - 0.5,
          image_.height - below - (p_W.y() - area_W_.min().y()) * pixels_per_m_ - 0.5};
}

std::vector<Pixel> Canvas::ToPixels(const std::vector<Eigen::Vector3d>& points_W) const {
  std::vector<Pixel> pixels;
  pixels.reserve(points_W.size());
  for (const Eigen::Vector3d& p_W : points_W) pixels.push_back(ToPixel(p_W));
  return pixels;
}

Eigen::AlignedBox2d Canvas::map_px() const { return {Pixel(0, 0), Pixel(map_width_, image_.height)}; }
Eigen::AlignedBox2d Canvas::strip_px() const {
  return {Pixel(map_width_, 0), Pixel(image_.width, image_.height)};
}

/// Draws on a copy of the pixels in `box` and mixes it with them.
template <class Draw>
void Canvas::Blend(const Eigen::AlignedBox2d& box, double opacity, const Draw& draw) {
  cv::Mat whole = View(image_);
  if (opacity >= 1) return draw(whole, Pixel(0, 0));
  const cv::Rect2d wanted(box.min().x() - 2, box.min().y() - 2, box.sizes().x() + 4, box.sizes().y() + 4);
  const cv::Rect frame(0, 0, image_.width, image_.height);
  const cv::Rect part = cv::Rect(wanted & cv::Rect2d(frame)) & frame;
  if (part.empty()) return;
  cv::Mat below = whole(part), drawn = below.clone();
  draw(drawn, Pixel(-part.x, -part.y));
  cv::addWeighted(drawn, opacity, below, 1 - opacity, 0, below);
}

void Canvas::Polyline(const std::vector<Pixel>& points, Colour colour, double width_px, double opacity) {
  if (points.size() < 2) return;
  Eigen::AlignedBox2d box;
  for (const Pixel& p : points) box.extend(p);
  box.extend(box.min() - Pixel::Constant(width_px)).extend(box.max() + Pixel::Constant(width_px));
  Blend(box, opacity, [&](cv::Mat& mat, const Pixel& shift) {
    std::vector<cv::Point> line;
    for (const Pixel& p : points) line.push_back(ToPoint(p + shift));
    cv::polylines(mat, line, false, ToScalar(colour), Thickness(width_px), cv::LINE_AA, kShift);
  });
}

void Canvas::Dashes(const std::vector<Pixel>& points, Colour colour, double width_px, double dash_px) {
  double along = 0;  // since the first point
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Pixel leg = points[i] - points[i - 1];
    const double length = leg.norm();
    for (double from = 0; from < length;) {
      const double phase = std::fmod(along + from, 2 * dash_px);
      const double to =
          std::min(length, from + (phase < dash_px ? dash_px - phase : 2 * dash_px - phase) + 1e-6);
      if (phase < dash_px) {
        Polyline({points[i - 1] + leg * (from / length), points[i - 1] + leg * (to / length)}, colour,
                 width_px);
      }
      from = to;
    }
    along += length;
  }
}

void Canvas::Disc(const Pixel& centre, double radius_px, Colour colour, double opacity) {
  Blend(Around(centre, radius_px), opacity, [&](cv::Mat& mat, const Pixel& shift) {
    cv::circle(mat, ToPoint(centre + shift), static_cast<int>(std::lround(radius_px * (1 << kShift))),
               ToScalar(colour), cv::FILLED, cv::LINE_AA, kShift);
  });
}

void Canvas::Ring(const Pixel& centre, double radius_px, Colour colour, double width_px, double opacity) {
  Blend(Around(centre, radius_px + width_px), opacity, [&](cv::Mat& mat, const Pixel& shift) {
    cv::circle(mat, ToPoint(centre + shift), static_cast<int>(std::lround(radius_px * (1 << kShift))),
               ToScalar(colour), Thickness(width_px), cv::LINE_AA, kShift);
  });
}

void Canvas::Fill(const Eigen::AlignedBox2d& box, Colour colour, double opacity) {
  Blend(box, opacity, [&](cv::Mat& mat, const Pixel& shift) {
    cv::rectangle(mat, ToPoint(box.min() + shift), ToPoint(box.max() + shift), ToScalar(colour), cv::FILLED,
                  cv::LINE_AA, kShift);
  });
}

void Canvas::Outline(const Eigen::AlignedBox2d& box, Colour colour, double width_px) {
  cv::Mat mat = View(image_);
  cv::rectangle(mat, ToPoint(box.min()), ToPoint(box.max()), ToScalar(colour), Thickness(width_px),
                cv::LINE_AA, kShift);
}

void Canvas::Text(const Pixel& at, const std::string& text, Colour colour, double height_px, Align align,
                  bool bold) {
  constexpr int kFont = cv::FONT_HERSHEY_DUPLEX;
  constexpr double kCapitals_px = 22;  // height of that font's capitals at scale 1
  const double size = height_px / kCapitals_px;
  const int thickness = Thickness(height_px / (bold ? 10 : 14));
  int below = 0;
  const double width = cv::getTextSize(text, kFont, size, thickness, &below).width;
  const double left = align == Align::kLeft ? 0 : align == Align::kCentre ? width / 2 : width;
  cv::Mat mat = View(image_);
  cv::putText(mat, text, cv::Point2d(std::round(at.x() - left), std::round(at.y())), kFont, size,
              ToScalar(colour), thickness, cv::LINE_AA);
}

void Canvas::Lay(const Image& cells, const std::vector<float>& cover, const Eigen::Vector2d& corner_W,
                 double cell_m) {
  const Pixel top_left = ToPixel(Eigen::Vector2d(corner_W.x(), corner_W.y() + cells.height * cell_m));
  const double side = cell_m * pixels_per_m_;
  // Cell (i, j) has its centre at top_left + (i + 1/2, j + 1/2) side; the warp takes pixels back to cells.
  const cv::Matx23d to_cell(1 / side, 0, -top_left.x() / side - 0.5, 0, 1 / side, -top_left.y() / side - 0.5);
  const int flags = (side > 1 ? cv::INTER_LINEAR : cv::INTER_NEAREST) | cv::WARP_INVERSE_MAP;
  const cv::Size size(static_cast<int>(map_width_), image_.height);
  Image copy = cells;
  cv::Mat mask(cells.height, cells.width, CV_8U), colours, opacity;
  std::transform(cover.begin(), cover.end(), mask.data,
                 [](float t) { return static_cast<uchar>(std::lround(255 * t)); });
  cv::warpAffine(View(copy), colours, to_cell, size, flags, cv::BORDER_REPLICATE);
  cv::warpAffine(mask, opacity, to_cell, size, flags, cv::BORDER_CONSTANT, cv::Scalar(0));
  for (int y = 0; y < size.height; ++y) {
    const uchar* over = colours.ptr<uchar>(y);
    const uchar* share = opacity.ptr<uchar>(y);
    std::uint8_t* below = image_.At(0, y);
    for (int x = 0; x < 3 * size.width; ++x) {
      const int t = share[x / 3];
      below[x] = static_cast<std::uint8_t>((below[x] * (255 - t) + over[x] * t + 127) / 255);
    }
  }
}

}  // namespace citrine::viz
