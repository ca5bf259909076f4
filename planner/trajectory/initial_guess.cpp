#include "planner/trajectory/initial_guess.h"

#include <algorithm>
#include <cmath>

namespace citrine::planner {

namespace {

constexpr double kCruiseShare = 0.8, kAccelerationShare = 0.6;
constexpr double kShortestLeg_m = 0.4, kShortest_s = 0.12;
constexpr double kPiecesMax = 24;

double Length(const std::vector<Eigen::Vector3d>& points_W) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < points_W.size(); ++i) length += (points_W[i + 1] - points_W[i]).norm();
  return length;
}

/// Corners that lie close together are merged; the first, the last and the one to be passed stay.
std::vector<Eigen::Vector3d> Spread(const std::vector<Eigen::Vector3d>& points_W,
                                    const std::optional<Eigen::Vector3d>& pass_W) {
  const auto near = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).norm() <= kShortestLeg_m;
  };
  std::vector<Eigen::Vector3d> apart = {points_W.front()};
  for (std::size_t i = 1; i + 1 < points_W.size(); ++i) {
    const Eigen::Vector3d& p_W = points_W[i];
    const bool spare =
        near(p_W, apart.back()) || near(p_W, points_W.back()) || (pass_W && near(p_W, *pass_W));
    if (!spare || p_W == pass_W) apart.push_back(p_W);
  }
  apart.push_back(points_W.back());
  return apart;
}

/// Time at which a speed ramp from `v0` to a stop at `length` passes `s`.
double RampTime(double s, double length, double v0, double cruise, double a) {
  const double peak = std::min(cruise, std::sqrt(a * length + v0 * v0 / 2));
  const double up = std::max(0.0, (peak * peak - v0 * v0) / (2 * a)), down = length - peak * peak / (2 * a);
  if (s < up) return (std::sqrt(v0 * v0 + 2 * a * s) - v0) / a;
  const double up_s = std::max(0.0, peak - v0) / a;
  if (s < down) return up_s + (s - up) / peak;
  const double left = std::max(0.0, length - s);
  return up_s + std::max(0.0, down - up) / peak + (peak - std::sqrt(std::min(peak * peak, 2 * a * left))) / a;
}

}  // namespace

InitialGuess GuessAlong(const std::vector<Eigen::Vector3d>& points_W, const Knot& start,
                        const VehicleLimits& limits, const std::optional<Eigen::Vector3d>& pass_W) {
  const double speed = start.v.norm();
  std::vector<Eigen::Vector3d> corners_W = points_W;
  const Eigen::Vector3d ahead = (points_W[1] - points_W[0]).normalized();
  // A start that moves away from the path first needs room to brake.
  if (speed > 1.0 && start.v.dot(ahead) < 0.3 * speed) {
    const double braking_m = speed * speed / (2 * limits.acceleration_max_mps2);
    corners_W.insert(corners_W.begin() + 1, start.p + start.v / speed * braking_m);
  }
  corners_W = Spread(corners_W, pass_W);
  const double length = Length(corners_W);
  const double piece_m = std::max(kPieceMax_m, length / kPiecesMax);

  InitialGuess guess;
  guess.points_W.push_back(corners_W.front());
  for (std::size_t i = 0; i + 1 < corners_W.size(); ++i) {
    const double leg_m = (corners_W[i + 1] - corners_W[i]).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(leg_m / piece_m - 1e-6)));
    for (int k = 1; k <= pieces; ++k)
      guess.points_W.push_back(corners_W[i] +
                               (corners_W[i + 1] - corners_W[i]) * (static_cast<double>(k) / pieces));
  }
  if (guess.points_W.size() == 2)
    guess.points_W.insert(guess.points_W.begin() + 1, (corners_W[0] + corners_W[1]) / 2);

  for (std::size_t i = 1; i + 1 < guess.points_W.size(); ++i)
    if (guess.points_W[i] == pass_W) guess.pass = i;

  const double v0 = std::clamp(start.v.dot((guess.points_W[1] - guess.points_W[0]).normalized()), 0.0,
                               limits.speed_max_mps);
  const double cruise = kCruiseShare * limits.speed_max_mps,
               a = kAccelerationShare * limits.acceleration_max_mps2;
  double s = 0;
  for (std::size_t i = 0; i + 1 < guess.points_W.size(); ++i) {
    const double next = s + (guess.points_W[i + 1] - guess.points_W[i]).norm();
    guess.durations_s.push_back(
        std::max(kShortest_s, RampTime(next, length, v0, cruise, a) - RampTime(s, length, v0, cruise, a)));
    s = next;
  }
  return guess;
}

}  // namespace citrine::planner
