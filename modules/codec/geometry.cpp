#include "modules/codec/geometry.h"

#include <cmath>

#include "modules/codec/bad_message.h"

namespace citrine {
namespace {

constexpr double kUnitTolerance = 1e-3;  // of a quaternion's norm: rounding passes, another quantity does not

}  // namespace

void EncodeVector(const Eigen::Vector3d& v, double (&out)[3]) {
  for (int i = 0; i < 3; ++i) out[i] = v[i];
}

void EncodePose(const Pose& X, double (&p)[3], double (&q)[4]) {
  EncodeVector(X.p, p);
  q[0] = X.q.w();
  q[1] = X.q.x();
  q[2] = X.q.y();
  q[3] = X.q.z();
}

Eigen::Vector3d DecodeVector(const double (&v)[3], const char* what) {
  RequireFinite(what, v[0], v[1], v[2]);
  return {v[0], v[1], v[2]};
}

Pose DecodePose(const double (&p)[3], const double (&q)[4], const char* what) {
  RequireFinite(what, q[0], q[1], q[2], q[3]);
  const Pose X{DecodeVector(p, what), Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
  Require(std::abs(X.q.norm() - 1) < kUnitTolerance, what);
  return X;
}

}  // namespace citrine
