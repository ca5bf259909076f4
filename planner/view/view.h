#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace citrine::planner {

/// A view candidate v_e (paper, IV-A): a level pose that looks at the element which it was made for.
struct View {
  enum class Kind : std::uint8_t {
    kOptimal,  ///< along the normal within [d* - eta, d*]
    kClose,    ///< along the normal, nearer
    kFar,      ///< along the normal, farther
    kAround,   ///< off the normal: what the paper's three samples cannot see (fallback of this project)
  };
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  double yaw_rad = 0;                             ///< towards the element
  std::uint32_t element = 0;                      ///< voxel of the element that it was made for
  Eigen::Vector3d element_W = Eigen::Vector3d::Zero();
  Kind kind = Kind::kOptimal;
};

}  // namespace citrine::planner
