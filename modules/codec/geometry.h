#pragma once

#include <Eigen/Core>

#include "core/geometry/pose.h"

namespace citrine {

// The arrays that points and poses travel in; a quaternion as w, x, y, z. Nothing is normalised or rounded.

void EncodeVector(const Eigen::Vector3d& v, double (&out)[3]);
void EncodePose(const Pose& X, double (&p)[3], double (&q)[4]);

/// @throws BadMessage(what) if it is not finite
Eigen::Vector3d DecodeVector(const double (&v)[3], const char* what);
/// @throws BadMessage(what) if it is not finite or `q` is not a unit quaternion
Pose DecodePose(const double (&p)[3], const double (&q)[4], const char* what);

}  // namespace citrine
