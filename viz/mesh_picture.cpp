#include "viz/mesh_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace citrine::viz {

namespace {

constexpr int kSupersampling = 2;
const cv::Vec3f kBackground(246, 244, 242);
const cv::Vec3f kPlain(205, 205, 205);
const cv::Vec3f kPoor(176, 114, 0);    // Okabe & Ito's blue
const cv::Vec3f kGood(66, 196, 240);   // a warm yellow beside it
const cv::Vec3f kBack(150, 110, 90);

/// Maps the world to pixels and depth: x right, y down, z towards the viewer.
struct Projection {
  Eigen::Matrix3d R_VW;
  Eigen::Vector3d centre_W;
  double pixels_per_m;
  cv::Size size;

  Eigen::Vector3d operator()(const Eigen::Vector3d& p_W) const {
    const Eigen::Vector3d p = R_VW * (p_W - centre_W) * pixels_per_m;
    return {size.width / 2.0 + p.x(), size.height / 2.0 - p.y(), p.z()};
  }
};

Projection Fit(const MeshView& view, const cv::Size& size) {
  Projection projection;
  const double ca = std::cos(view.azimuth_rad), sa = std::sin(view.azimuth_rad);
  const double ce = std::cos(view.elevation_rad), se = std::sin(view.elevation_rad);
  const Eigen::Vector3d to_viewer(ca * ce, sa * ce, se), right(-sa, ca, 0);
  projection.R_VW << right.transpose(), to_viewer.cross(right).transpose(), to_viewer.transpose();
  projection.centre_W = view.box_W.center();
  projection.size = size;
  const Eigen::Vector3d extent = projection.R_VW.cwiseAbs() * view.box_W.sizes();
  projection.pixels_per_m = 0.96 * std::min(size.width / extent.x(), size.height / extent.y());
  return projection;
}

cv::Vec3f Colour(float confidence, float weight_goal) {
  if (weight_goal <= 0) return kPlain;
  const float share = std::clamp(confidence / weight_goal, 0.0f, 1.0f);
  return kPoor * (1 - share) + kGood * share;
}

}  // namespace

cv::Mat DrawMesh(const TriMesh& mesh, const MeshView& view) {
  const cv::Size size = view.size * kSupersampling;
  const Projection project = Fit(view, size);
  cv::Mat picture(size, CV_32FC3, kBackground);
  cv::Mat depth(size, CV_32F, cv::Scalar(-std::numeric_limits<float>::infinity()));
  const Eigen::Vector3d light = (project.R_VW.transpose() * Eigen::Vector3d(-0.4, 0.75, 0.6)).normalized();

  for (const auto& triangle : mesh.triangles) {
    Eigen::Vector3d w[3], p[3];
    float confidence = 0;
    for (int k = 0; k < 3; ++k) {
      w[k] = mesh.vertices_W[triangle[k]].cast<double>();
      p[k] = project(w[k]);
      if (!mesh.confidence.empty()) confidence += mesh.confidence[triangle[k]] / 3;
    }
    if (std::min({w[0].z(), w[1].z(), w[2].z()}) > view.ceiling_m) continue;
    const Eigen::Vector3d normal = (w[1] - w[0]).cross(w[2] - w[0]).normalized();
    const double area = (p[1] - p[0]).head<2>().x() * (p[2] - p[0]).y() - (p[1] - p[0]).y() * (p[2] - p[0]).x();
    if (std::abs(area) < 1e-9 || !normal.allFinite()) continue;
    const bool front = area < 0;  // y goes down, so that a counter-clockwise face has a negative area
    const auto shade = static_cast<float>(0.35 + 0.65 * std::max(0.0, (front ? 1.0 : -1.0) * normal.dot(light)));
    const cv::Vec3f colour = (front ? Colour(confidence, view.weight_goal) : kBack) * shade;

    const auto bound = [](double v, int top) { return std::clamp(static_cast<int>(std::floor(v)), 0, top); };
    const int x0 = bound(std::min({p[0].x(), p[1].x(), p[2].x()}), size.width - 1);
    const int x1 = bound(std::max({p[0].x(), p[1].x(), p[2].x()}), size.width - 1);
    const int y0 = bound(std::min({p[0].y(), p[1].y(), p[2].y()}), size.height - 1);
    const int y1 = bound(std::max({p[0].y(), p[1].y(), p[2].y()}), size.height - 1);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const auto edge = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
          return ((b.x() - a.x()) * (y + 0.5 - a.y()) - (b.y() - a.y()) * (x + 0.5 - a.x())) / area;
        };
        const double b0 = edge(p[1], p[2]), b1 = edge(p[2], p[0]), b2 = edge(p[0], p[1]);
        if (b0 < 0 || b1 < 0 || b2 < 0) continue;
        const auto z = static_cast<float>(b0 * p[0].z() + b1 * p[1].z() + b2 * p[2].z());
        if (z <= depth.at<float>(y, x)) continue;
        depth.at<float>(y, x) = z;
        picture.at<cv::Vec3f>(y, x) = colour;
      }
    }
  }
  cv::Mat bgr, small;
  picture.convertTo(bgr, CV_8UC3);
  cv::resize(bgr, small, view.size, 0, 0, cv::INTER_AREA);
  return small;
}

}  // namespace citrine::viz
