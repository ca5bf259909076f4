#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>

#include "core/random.h"
#include "core/sensor/lidar_scan.h"

namespace citrine::test {

/// A scene of boxes, spheres, upright cylinders and half spaces whose distances and ray hits are known
/// exactly.
class AnalyticScene {
 public:
  void AddBox(const Eigen::Vector3d& min_W, const Eigen::Vector3d& max_W) {
    AddTurnedBox((max_W - min_W) / 2, {(min_W + max_W) / 2, Eigen::Quaterniond::Identity()});
  }
  /// @param half_m  of its sides @param X_WB  its middle and how it is turned
  void AddTurnedBox(const Eigen::Vector3d& half_m, const Pose& X_WB) {
    boxes_.push_back({half_m, X_WB.q.conjugate().toRotationMatrix(), X_WB.p});
  }
  void AddCylinder(const Eigen::Vector3d& bottom_W, double radius_m, double height_m) {
    cylinders_.push_back({bottom_W, radius_m, height_m});
  }
  void AddSphere(const Eigen::Vector3d& centre_W, double radius_m) {
    spheres_.push_back({centre_W, radius_m});
  }
  /// Solid below normal . p = offset.
  void AddHalfSpace(const Eigen::Vector3d& normal_W, double offset_m) {
    half_spaces_.push_back({normal_W.normalized(), offset_m});
  }

  /// [m] signed distance to the nearest surface, negative inside a solid (exact outside solids).
  double Distance(const Eigen::Vector3d& p) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& box : boxes_) {
      const Eigen::Vector3d q = (box.R_BW * (p - box.p_WB)).cwiseAbs() - box.half;
      nearest = std::min(nearest, q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0));
    }
    for (const Cylinder& c : cylinders_) {
      const Eigen::Vector3d at = p - c.bottom;
      const Eigen::Vector2d q(at.head<2>().norm() - c.radius, std::max(-at.z(), at.z() - c.height));
      nearest = std::min(nearest, q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0));
    }
    for (const Sphere& s : spheres_) nearest = std::min(nearest, (p - s.centre).norm() - s.radius);
    for (const HalfSpace& h : half_spaces_) nearest = std::min(nearest, h.normal.dot(p) - h.offset);
    return nearest;
  }

  /// [m] range at which a ray first meets a solid; infinity if it never does.
  double Range(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& box : boxes_) {
      double enter = 0, leave = nearest;
      const Eigen::Vector3d from_B = box.R_BW * (from - box.p_WB), along_B = box.R_BW * direction;
      for (int axis = 0; axis < 3; ++axis) {
        double a = (-box.half[axis] - from_B[axis]) / along_B[axis],
               b = (box.half[axis] - from_B[axis]) / along_B[axis];
        if (a > b) std::swap(a, b);
        enter = std::max(enter, a);
        leave = std::min(leave, b);
      }
      if (enter < leave && enter > 0) nearest = std::min(nearest, enter);
    }
    for (const Cylinder& c : cylinders_) {
      const Eigen::Vector3d at = from - c.bottom;
      const double a = direction.head<2>().squaredNorm(), b = direction.head<2>().dot(at.head<2>());
      const double root = b * b - a * (at.head<2>().squaredNorm() - c.radius * c.radius);
      if (root < 0 || a == 0) continue;
      double low = -at.z() / direction.z(), high = (c.height - at.z()) / direction.z();
      if (low > high) std::swap(low, high);
      const double enter = std::max(low, (-b - std::sqrt(root)) / a),
                   leave = std::min(high, (-b + std::sqrt(root)) / a);
      if (enter < leave && enter > 0) nearest = std::min(nearest, enter);
    }
    for (const Sphere& s : spheres_) {
      const double along = direction.dot(s.centre - from);
      const double inside = s.radius * s.radius - ((s.centre - from).squaredNorm() - along * along);
      if (inside >= 0 && along - std::sqrt(inside) > 0)
        nearest = std::min(nearest, along - std::sqrt(inside));
    }
    for (const HalfSpace& h : half_spaces_) {
      const double range = (h.offset - h.normal.dot(from)) / h.normal.dot(direction);
      if (range > 0) nearest = std::min(nearest, range);
    }
    return nearest;
  }

  /// What a LiDAR measures. @param noise_m_per_m2  sigma(r) = this * r^2
  LidarScan Scan(const Pose& X_WS, const LidarModel& model = {}, double noise_m_per_m2 = 0,
                 Random* random = nullptr) const {
    LidarScan scan{.measured = 0, .X_WS = X_WS, .model = model, .ranges_m = {}};
    for (int row = 0; row < model.rows; ++row)
      for (int col = 0; col < model.cols; ++col) {
        double range = Range(X_WS.p, X_WS.q * model.Direction(row, col));
        if (random && std::isfinite(range)) range += noise_m_per_m2 * range * range * random->Normal();
        const bool returned = range <= model.range_max_m;
        scan.ranges_m.push_back(!returned                   ? kNoReturn
                                : range < model.range_min_m ? kInvalid
                                                            : static_cast<float>(range));
      }
    return scan;
  }

 private:
  struct Box {
    Eigen::Vector3d half;
    Eigen::Matrix3d R_BW;
    Eigen::Vector3d p_WB;
  };
  struct Cylinder {
    Eigen::Vector3d bottom;
    double radius, height;
  };
  struct Sphere {
    Eigen::Vector3d centre;
    double radius;
  };
  struct HalfSpace {
    Eigen::Vector3d normal;
    double offset;
  };
  std::vector<Box> boxes_;
  std::vector<Cylinder> cylinders_;
  std::vector<Sphere> spheres_;
  std::vector<HalfSpace> half_spaces_;
};

}  // namespace citrine::test
