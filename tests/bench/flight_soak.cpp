// Flies random forests and encounters with the whole of flight but the bus, and prints what came of it:
// flight_soak [forests] [encounters] [gust m/s] [localisation noise m]
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

#include "tests/soak/soak_flight.h"

namespace citrine::soak {
namespace {

constexpr double kForestLimit_s = 60, kEncounterLimit_s = 90;

double Percentile95(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() * 95 / 100];
}

void PrintRow(const char* kind, const SoakResult& r) {
  std::printf(
      "%-14s %5d %4d/%-4d %5d %5d %6d/%-5d %7.2f %7.2f %6.2f %6.2f %6.2f %6.2f %6.3f %7.1f %6.2f %6.2f\n",
      kind, r.flights, r.arrived, r.uavs, r.blocked, r.contacts, r.failures, r.plans, r.clearance_m,
      r.uavs > r.flights ? r.separation_m : 0.0, r.planned_speed_mps, r.planned_acceleration_mps2,
      r.flown_speed_mps, r.flown_acceleration_mps2, r.error_m, r.seconds / r.flights,
      Percentile95(r.smoothing_ms), Percentile95(r.planning_ms));
  std::fflush(stdout);
}

void PrintHead() {
  std::printf("%-14s %5s %9s %5s %5s %12s %7s %7s %6s %6s %6s %6s %6s %7s %6s %6s\n", "", "fly", "arrived",
              "block", "touch", "failed", "clear", "apart", "plan v", "plan a", "v", "a", "error", "mean s",
              "smooth", "plan");
}

/// Says which flight was the first to be worse than what is promised.
void Accuse(const Scenario& scenario, const SoakResult& r, const VehicleLimits& limits) {
  const bool near =
      r.clearance_m < limits.radius_m - 0.25 || (r.uavs > 1 && r.separation_m < 2 * limits.radius_m);
  const bool hard = r.planned_speed_mps > 1.01 * limits.speed_max_mps ||
                    r.planned_acceleration_mps2 > 1.01 * limits.acceleration_max_mps2 ||
                    r.flown_acceleration_mps2 > 1.01 * limits.acceleration_max_mps2 || r.jump > 1e-6;
  if (r.contacts > 0 || near || hard || r.arrived < r.uavs)
    std::printf(
        "  %s %llu with %d UAVs: %d of them arrived, contacts %d, clearance %.2f, separation %.2f, "
        "acceleration %.2f, jump %.1e\n",
        scenario.kind.c_str(), static_cast<unsigned long long>(scenario.seed), r.uavs, r.arrived, r.contacts,
        r.clearance_m, r.uavs > 1 ? r.separation_m : 0.0, r.flown_acceleration_mps2, r.jump);
}

int Run(int forests, int encounters, const UavSection& uav) {
  using Make = Scenario (*)(std::uint64_t, int);
  std::vector<std::pair<std::string, SoakResult>> rows{{"forest", {}}};
  for (int i = 1; i <= forests; ++i) {
    const Scenario scenario = Forest(static_cast<std::uint64_t>(i));
    const SoakResult result = SoakFlight(scenario, uav).Fly(kForestLimit_s);
    Accuse(scenario, result, uav.limits);
    rows[0].second.Add(result);
  }
  for (const Make make : std::array<Make, 3>{HeadOn, Crossing, NarrowGap})
    for (int uavs = 2; uavs <= 3; ++uavs) {
      SoakResult sum;
      std::string kind;
      for (int i = 1; i <= (encounters + 5) / 6; ++i) {
        const Scenario scenario = make(static_cast<std::uint64_t>(i), uavs);
        kind = scenario.kind + " " + std::to_string(uavs);
        const SoakResult result = SoakFlight(scenario, uav).Fly(kEncounterLimit_s);
        Accuse(scenario, result, uav.limits);
        sum.Add(result);
      }
      if (sum.flights > 0) rows.emplace_back(kind, sum);
    }
  PrintHead();
  SoakResult all;
  for (const auto& [kind, row] : rows) {
    if (row.flights == 0) continue;
    PrintRow(kind.c_str(), row);
    all.Add(row);
  }
  PrintRow("all", all);
  return all.contacts == 0 ? 0 : 1;
}

}  // namespace
}  // namespace citrine::soak

int main(int argc, char** argv) {
  citrine::UavSection uav;
  if (argc > 3) uav.wind_gust_mps = std::atof(argv[3]);
  if (argc > 4) uav.localisation_noise_m = std::atof(argv[4]);
  return citrine::soak::Run(argc > 1 ? std::atoi(argv[1]) : 1000, argc > 2 ? std::atoi(argv[2]) : 200, uav);
}
