#include "viz/mesh_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace citrine::viz {

namespace {

constexpr int kSupersampling = 2;
using Rgb = Eigen::Vector3f;
const Rgb kBackground(242, 244, 246), kPlain(205, 205, 205), kBack(90, 110, 150);
const Rgb kPoor(0, 114, 178), kGood(240, 214, 120);

/// Maps the world to pixels and depth: x right, y down, z towards the viewer.
struct Projection {
  Eigen::Matrix3d R_VW;
  Eigen::Vector3d centre_V;
  double pixels_per_m;
  int width, height;

  Eigen::Vector3d operator()(const Eigen::Vector3d& p_W) const {
    const Eigen::Vector3d p = (R_VW * p_W - centre_V) * pixels_per_m;
    return {width / 2.0 + p.x(), height / 2.0 - p.y(), p.z()};
  }
};

Projection Fit(const TriMesh& mesh, const MeshView& view, int width, int height) {
  Projection projection{{}, {}, 1, width, height};
  const double ca = std::cos(view.azimuth_rad), sa = std::sin(view.azimuth_rad);
  const double ce = std::cos(view.elevation_rad), se = std::sin(view.elevation_rad);
  const Eigen::Vector3d to_viewer(ca * ce, sa * ce, se), right(-sa, ca, 0);
  projection.R_VW << right.transpose(), to_viewer.cross(right).transpose(), to_viewer.transpose();
  Eigen::AlignedBox3d box_V;
  for (const Eigen::Vector3f& vertex_W : mesh.vertices_W)
    box_V.extend(projection.R_VW * vertex_W.cast<double>());
  projection.centre_V = box_V.center();
  projection.pixels_per_m = 0.94 * std::min(width / box_V.sizes().x(), height / box_V.sizes().y());
  return projection;
}

Rgb ColourOf(float confidence, float weight_goal) {
  if (weight_goal <= 0) return kPlain;
  const float share = std::clamp(confidence / weight_goal, 0.0f, 1.0f);
  return kPoor * (1 - share) + kGood * share;
}

struct Buffer {
  int width, height;
  std::vector<Rgb> colour;
  std::vector<double> depth;

  Buffer(int w, int h)
      : width(w),
        height(h),
        colour(static_cast<std::size_t>(w) * h, kBackground),
        depth(colour.size(), -std::numeric_limits<double>::infinity()) {}

  /// Fills the triangle p (pixels and depth) wherever it is nearer than what is there.
  void Fill(const std::array<Eigen::Vector3d, 3>& p, double area, const Rgb& rgb) {
    const auto clamped = [](double v, int top) {
      return std::clamp(static_cast<int>(std::floor(v)), 0, top);
    };
    const int x0 = clamped(std::min({p[0].x(), p[1].x(), p[2].x()}), width - 1);
    const int x1 = clamped(std::max({p[0].x(), p[1].x(), p[2].x()}), width - 1);
    const int y0 = clamped(std::min({p[0].y(), p[1].y(), p[2].y()}), height - 1);
    const int y1 = clamped(std::max({p[0].y(), p[1].y(), p[2].y()}), height - 1);
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const auto share = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
          return ((b.x() - a.x()) * (y + 0.5 - a.y()) - (b.y() - a.y()) * (x + 0.5 - a.x())) / area;
        };
        const double s0 = share(p[1], p[2]), s1 = share(p[2], p[0]), s2 = share(p[0], p[1]);
        if (s0 < 0 || s1 < 0 || s2 < 0) continue;
        const double z = s0 * p[0].z() + s1 * p[1].z() + s2 * p[2].z();
        const std::size_t at = static_cast<std::size_t>(y) * width + x;
        if (z <= depth[at]) continue;
        depth[at] = z;
        colour[at] = rgb;
      }
  }

  /// Averages kSupersampling x kSupersampling pixels into one.
  Image Reduced() const {
    Image image(width / kSupersampling, height / kSupersampling, Colour{});
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        Rgb sum = Rgb::Zero();
        for (int dy = 0; dy < kSupersampling; ++dy)
          for (int dx = 0; dx < kSupersampling; ++dx)
            sum +=
                colour[static_cast<std::size_t>(kSupersampling * y + dy) * width + kSupersampling * x + dx];
        sum /= kSupersampling * kSupersampling;
        const auto byte = [](float v) {
          return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0f, 255.0f)));
        };
        image.Set(x, y, Colour{byte(sum.x()), byte(sum.y()), byte(sum.z())});
      }
    return image;
  }
};

}  // namespace

Image DrawMesh(const TriMesh& mesh, const MeshView& view) {
  Buffer buffer(kSupersampling * view.width, kSupersampling * view.height);
  if (mesh.vertices_W.empty()) return buffer.Reduced();
  const Projection project = Fit(mesh, view, buffer.width, buffer.height);
  const Eigen::Vector3d light_W = (project.R_VW.transpose() * Eigen::Vector3d(-0.4, 0.75, 0.6)).normalized();
  for (const auto& triangle : mesh.triangles) {
    std::array<Eigen::Vector3d, 3> w, p;
    float confidence = 0;
    for (int k = 0; k < 3; ++k) {
      w[k] = mesh.vertices_W[triangle[k]].cast<double>();
      p[k] = project(w[k]);
      if (!mesh.confidence.empty()) confidence += mesh.confidence[triangle[k]] / 3;
    }
    const double area = (p[1] - p[0]).x() * (p[2] - p[0]).y() - (p[1] - p[0]).y() * (p[2] - p[0]).x();
    const Eigen::Vector3d normal_W = (w[1] - w[0]).cross(w[2] - w[0]).normalized();
    if (std::abs(area) < 1e-9 || !normal_W.allFinite()) continue;
    const bool front =
        area < 0;  // y goes down: a face that is counter-clockwise to the viewer has a negative area
    const double lit = std::max(0.0, (front ? 1 : -1) * normal_W.dot(light_W));
    buffer.Fill(
        p, area,
        (front ? ColourOf(confidence, view.weight_goal) : kBack) * static_cast<float>(0.35 + 0.65 * lit));
  }
  return buffer.Reduced();
}

}  // namespace citrine::viz
