#include "sim/dynamics/fleet_simulator.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace citrine::sim {

namespace {

constexpr double kSubstepMax_s = 0.005;
/// Where a motion's jerk steps, the body's rate has to; this long before it begins to, about as long as
/// rotors and attitude take. Motions are known earlier.
constexpr Utime kPreview = 30'000;
constexpr std::uint64_t kGustStream = 0x600;  // streams of the mission's seed, one a UAV

double SubstepOf(const DynamicsSection& dynamics) {
  const double substep_s = dynamics.step_s / dynamics.substeps;
  if (substep_s > kSubstepMax_s * (1 + 1e-9)) {
    std::ostringstream message;
    message << "dynamics.substeps = " << dynamics.substeps << ": makes ODE steps of " << substep_s * 1e3
            << " ms; at most " << kSubstepMax_s * 1e3 << " ms are allowed";
    throw ConfigError(message.str());
  }
  return substep_s;
}

}  // namespace

FleetSimulator::FleetSimulator(const TriMesh& world, const std::vector<Eigen::Vector3d>& spawns_W,
                               const UavSection& uav, const DynamicsSection& dynamics, std::uint64_t seed,
                               const QuadrotorModel& model)
    : model_(model),
      substep_s_(SubstepOf(dynamics)),
      bodies_(world, model, spawns_W, seed),
      contacts_(static_cast<int>(spawns_W.size())) {
  for (std::size_t i = 0; i < spawns_W.size(); ++i) {
    vehicles_.push_back({bodies_.state(static_cast<int>(i)), Rotors(model),
                         Gust(uav.wind_gust_mps, seed, kGustStream + i),
                         TrajectoryQueue(Hover(spawns_W[i], 0, 0))});
  }
}

void FleetSimulator::Follow(int uav, Trajectory trajectory) {
  vehicles_[static_cast<std::size_t>(uav - 1)].queue.Add(std::move(trajectory));
}

void FleetSimulator::Step(Utime now, double dt_s) {
  const auto substeps = static_cast<int>(std::ceil(dt_s / substep_s_ - 1e-6));
  for (int k = 0; k < substeps; ++k) Substep(now + FromSeconds(k * dt_s / substeps), dt_s / substeps);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    vehicles_[i].state.utime = now + FromSeconds(dt_s);
    vehicles_[i].state.contacts = contacts_.count(static_cast<int>(i) + 1);
  }
}

void FleetSimulator::Substep(Utime now, double dt_s) {
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    Vehicle& vehicle = vehicles_[i];
    const TrajectoryPoint reference = vehicle.queue.At(now);
    const Eigen::Vector3d snap_W =
        (vehicle.queue.Foresee(now + kPreview).j_W - reference.j_W) / Seconds(kPreview);
    const Wrench asked = TrackOnSE3(model_, gains_, vehicle.state, reference, snap_W);
    vehicle.rotors.Step(Mix(model_, asked), dt_s);
    vehicle.gust.Step(dt_s);
    const Eigen::Vector3d airspeed_W = vehicle.state.v_W - vehicle.gust.velocity_W();
    bodies_.Exert(static_cast<int>(i), WrenchOf(model_, vehicle.rotors.thrusts_N()),
                  -model_.mass_kg * model_.drag_per_s * airspeed_W);
  }
  for (const Touch& touch : bodies_.Step(dt_s)) contacts_.Touch(touch.body + 1, touch.other + 1, now);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) vehicles_[i].state = bodies_.state(static_cast<int>(i));
}

}  // namespace citrine::sim
