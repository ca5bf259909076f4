#include "sim/world/world_report.h"

#include <algorithm>
#include <cstdio>

#include "core/digest.h"
#include "sim/lidar/observability.h"
#include "sim/lidar/reachability.h"
#include "sim/world/edge_flaws.h"
#include "sim/world/spawn.h"
#include "sim/world/true_surface.h"
#include "sim/world/world.h"

namespace citrine::sim {
namespace {

constexpr int kStartsCounted = 100;
constexpr std::uint64_t kSeed = 1;

template <class... Values>
std::string Line(const char* format, Values... values) {
  char text[512];
  std::snprintf(text, sizeof text, format, values...);
  return std::string(text) + "\n";
}

std::string Span(const char* label, const Eigen::AlignedBox3d& box) {
  return Line("%-18s %.2f x %.2f x %.2f m    x [%.2f, %.2f]  y [%.2f, %.2f]  z [%.2f, %.2f]", label,
              box.sizes().x(), box.sizes().y(), box.sizes().z(), box.min().x(), box.max().x(), box.min().y(),
              box.max().y(), box.min().z(), box.max().z());
}

/// What the size says about the unit; empty if it looks like metres.
std::string UnitHint(const Eigen::AlignedBox3d& bounds_W) {
  const double longest_m = bounds_W.sizes().maxCoeff();
  if (longest_m > 5000) return "that looks like millimetres: scale it by 0.001";
  if (longest_m > 1000) return "that looks like centimetres or inches: scale it by 0.01 or 0.0254";
  if (longest_m < 2)
    return "that is too small to fly around: is it in another unit, or a model at small scale?";
  return "";
}

double Share(const std::vector<std::uint8_t>& flags) {
  return flags.empty()
             ? 0
             : 100.0 * static_cast<double>(std::ranges::count(flags, 1)) / static_cast<double>(flags.size());
}

class Reporter {
 public:
  explicit Reporter(const WorldReportOptions& options) : options_(options) {}

  WorldReport Report(const std::string& path) {
    try {
      Describe(LoadWorld(path, options_.search));
    } catch (const WorldError& error) {
      Wrong(error.what());
    }
    report_.ok = wrong_.empty();
    report_.text += wrong_ + hints_;
    report_.text += report_.ok ? "It can be flown in.\n" : "";
    return report_;
  }

 private:
  void Wrong(const std::string& what) { wrong_ += "! " + what + "\n"; }
  void Hint(const std::string& what) { hints_ += "  note: " + what + "\n"; }
  void Say(const std::string& lines) { report_.text += lines; }

  void Describe(const World& world) {
    const Eigen::AlignedBox3d volume_W = options_.volume_W.value_or(DefaultVolume(world));
    const auto ground = std::ranges::count(world.parts, true, &Part::ground);
    Say(Line("%-18s %s    hash %s", "world", world.name.c_str(), Hex(world.hash).c_str()));
    Say(Span("size", world.bounds_W));
    Say(Span("mission volume", volume_W));
    Say(Line("%-18s %zu, of them %td ground; %zu triangles, %.0f m2", "parts", world.parts.size(), ground,
             world.mesh.triangles.size(), world.SurfaceArea()));
    if (const std::string hint = UnitHint(world.bounds_W); !hint.empty()) {
      char longest[32];
      std::snprintf(longest, sizeof longest, "%.6g m; ", world.bounds_W.sizes().maxCoeff());
      return Wrong("its longest side is " + (longest + hint));
    }
    if (ground == 0) Hint("no model is named \"ground...\": the shares without ground count everything");
    HintAtFlaws(FindEdgeFlaws(world));
    if (!volume_W.intersects(world.bounds_W)) return Wrong("the mission volume lies outside the world");
    DescribeSurface(world, RayScene(world), volume_W);
  }

  void HintAtFlaws(const EdgeFlaws& flaws) {
    const auto edges = [](int count, const std::string& at) {
      return std::to_string(count) + " edges, the first in " + at;
    };
    if (flaws.open > 0)
      Hint("not closed: " + edges(flaws.open, flaws.open_at) +
           "; nothing counts as inside there, and the far side of its faces as surface to be seen");
    if (flaws.against > 0)
      Hint("wound against each other: the triangles at " + edges(flaws.against, flaws.against_at) +
           "; what counts as inside may have gaps");
    if (flaws.inside_out > 0)
      Hint("inside out: " + std::to_string(flaws.inside_out) + " parts, the first " + flaws.inside_out_at +
           "; nothing counts as inside of them");
    if (flaws.open + flaws.against + flaws.inside_out > 0)
      Hint("MeshLab (Render, Show Non Manifold Edges) or Blender (Face Orientation) show where");
  }

  void DescribeSurface(const World& world, const RayScene& scene, const Eigen::AlignedBox3d& volume_W) {
    const TrueSurface surface = SampleTrueSurface(world, scene, volume_W, options_.density_per_m2, kSeed);
    Say(Line("%-18s %.0f m2 in the volume; %.1f %% left out, with solid on both sides", "true surface",
             surface.area_m2, 100 * surface.dropped_share));
    if (surface.samples.empty()) return Wrong("there is no surface in the mission volume");
    const int starts = static_cast<int>(FreeStarts(scene, volume_W, kSpawnApart_m, kStartsCounted).size());
    Say(Line("%-18s %d%s places to start, %.0f m apart, with %.2f m of free space around", "free starts",
             starts, starts == kStartsCounted ? " or more" : "", kSpawnApart_m, kSpawnFree_m));
    if (starts < options_.uavs)
      Wrong("there is no room for " + std::to_string(options_.uavs) +
            " UAVs to start: the mission volume must be larger, or the world emptier");
    if (starts == 0) return;
    const std::vector<Eigen::Vector3d> spawns_W =
        PlaceSpawns(scene, volume_W, std::min(starts, options_.uavs), {}, 0, kSeed);
    const ReachableLattice lattice = FindReachable(scene, volume_W, spawns_W, options_.radius_m);
    const Observability flags =
        FindObservable(surface.samples, lattice, scene, options_.model, options_.goals);
    Say(Line("%-18s %.1f %% of the true surface from %zu reachable poses; %.1f %% from within d* = %.2f m",
             "observable", Share(flags.observable), lattice.num_reachable(), Share(flags.within_goal),
             options_.goals.whole().d_star_m));
    if (Share(flags.observable) < 50)
      Hint("most of its surface cannot be seen: are there rooms inside, or is it wound open?");
  }

  const WorldReportOptions& options_;
  WorldReport report_;
  std::string wrong_, hints_;
};

}  // namespace

WorldReport ReportWorld(const std::string& path, const WorldReportOptions& options) {
  return Reporter(options).Report(path);
}

}  // namespace citrine::sim
