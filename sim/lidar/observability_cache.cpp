#include <filesystem>
#include <fstream>
#include <optional>

#include "core/digest.h"
#include "sim/lidar/observability.h"

namespace citrine::sim {
namespace {

namespace fs = std::filesystem;

/// Digest of all that the flags depend on beside the world.
std::uint64_t KeyOf(const std::vector<SurfaceSample>& samples, const ReachableLattice& lattice,
                    const LidarModel& model, const QualityGoals& goals) {
  Digest digest;
  const auto add = [&](const auto& value) { digest.Add(&value, sizeof value); };
  for (const SurfaceSample& sample : samples) {
    digest.Add(sample.p_W.data(), sizeof(float) * 3);
    add(goals.At(sample.p_W.cast<double>()).d_star_m);
  }
  digest.Add(lattice.origin_W.data(), sizeof(double) * 3);
  digest.Add(lattice.size.data(), sizeof(int) * 3);
  digest.Add(lattice.reachable.data(), lattice.reachable.size());
  for (const double value :
       {model.elevation_min_rad, model.elevation_max_rad, model.range_min_m, model.range_max_m})
    add(value);
  return digest.value();
}

/// Two bits a sample, as one byte each, then the digest of those bytes.
std::optional<Observability> Read(const fs::path& file, std::size_t num_samples) {
  std::ifstream in(file, std::ios::binary);
  std::vector<std::uint8_t> bytes(num_samples);
  std::uint64_t sum = 0;
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  in.read(reinterpret_cast<char*>(&sum), sizeof sum);
  Digest digest;
  digest.Add(bytes.data(), bytes.size());
  if (!in || sum != digest.value()) return std::nullopt;
  Observability flags;
  for (const std::uint8_t byte : bytes) {
    flags.observable.push_back(byte & 1);
    flags.within_goal.push_back(byte >> 1);
  }
  return flags;
}

/// Written beside and moved into place, so that a reader never meets half a file.
void Write(const fs::path& file, const Observability& flags) {
  std::vector<std::uint8_t> bytes(flags.observable.size());
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(flags.observable[i] | flags.within_goal[i] << 1);
  Digest digest;
  digest.Add(bytes.data(), bytes.size());
  const std::uint64_t sum = digest.value();
  std::error_code ignored;
  fs::create_directories(file.parent_path(), ignored);
  fs::path beside = file;
  beside += ".part";
  std::ofstream out(beside, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.write(reinterpret_cast<const char*>(&sum), sizeof sum);
  out.close();
  if (out) fs::rename(beside, file, ignored);
}

}  // namespace

Observability FindObservableCached(const std::string& cache_folder, const std::vector<SurfaceSample>& samples,
                                   const ReachableLattice& lattice, const RayScene& scene,
                                   const LidarModel& model, const QualityGoals& goals) {
  const fs::path file = fs::path(cache_folder) / ("observable-" + Hex(scene.world_hash()) + "-" +
                                                  Hex(KeyOf(samples, lattice, model, goals)) + ".bin");
  if (std::optional<Observability> kept = Read(file, samples.size())) return *kept;
  const Observability found = FindObservable(samples, lattice, scene, model, goals);
  Write(file, found);
  return found;
}

}  // namespace citrine::sim
