#include "tests/support/house_flight.h"

#include <cmath>

#include "sim/lidar/lidar_emulator.h"

namespace citrine::test {
namespace {

constexpr double kStep_m = 0.4;
const std::vector<Eigen::Vector3d> kTour_W{{-20.5, 4, 4},   {-19.5, 14.5, 5}, {-9, 15.5, 6}, {1.5, 14.5, 5},
                                           {3, 9, 3.2},     {2, 1, 3},        {9, 1, 3},     {17.5, 2.5, 3.5},
                                           {19.5, 10, 4.5}, {11, 16, 4},      {0, 12, 9},    {-5, 8, 11.5},
                                           {-4, -1, 5},     {-10, -4, 3}};

}  // namespace

HouseFlight::HouseFlight()
    : world_(sim::LoadWorld(CITRINE_SOURCE_DIR "/worlds/house.sdf")),
      scene_(std::make_shared<const sim::RayScene>(world_)) {
  std::size_t leg = 0;
  double along_m = 0;
  for (int i = 0; i < kPoses; ++i, along_m += kStep_m) {
    while (leg + 2 < kTour_W.size() && along_m > (kTour_W[leg + 1] - kTour_W[leg]).norm())
      along_m -= (kTour_W[leg + 1] - kTour_W[leg]).norm(), ++leg;
    const Eigen::Vector3d heading = (kTour_W[leg + 1] - kTour_W[leg]).normalized();
    X_WS_.push_back({kTour_W[leg] + along_m * heading,
                     Eigen::AngleAxisd(std::atan2(heading.y(), heading.x()), Eigen::Vector3d::UnitZ()) *
                         Eigen::AngleAxisd(0.087 * std::sin(0.31 * i), Eigen::Vector3d::UnitY()) *
                         Eigen::AngleAxisd(0.105 * std::sin(0.23 * i), Eigen::Vector3d::UnitX())});
  }
}

std::vector<LidarScan> HouseFlight::Scans(int rows, int cols, double noise_m_per_m2, int every) const {
  LidarModel model;
  model.rows = rows;
  model.cols = cols;
  const sim::LidarEmulator emulator(scene_, model, noise_m_per_m2);
  Random random(1);
  std::vector<LidarScan> scans;
  for (std::size_t i = 0; i < X_WS_.size(); i += static_cast<std::size_t>(every))
    scans.push_back(emulator.Scan(static_cast<Utime>(100'000 * i), X_WS_[i], {}, random));
  return scans;
}

}  // namespace citrine::test
