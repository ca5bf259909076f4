#include "logs/reconstruction_score.h"

#include <gtest/gtest.h>

#include "logs/surface_samples.h"
#include "tests/logs/shapes.h"
#include "tests/logs/triangle_distance.h"

namespace citrine::logs {
namespace {

constexpr double kThreshold_m = 0.30618621784789724;  // sqrt(3/2) of 0.25 m

ScoreTruth TruthOf(const TriMesh& mesh, double samples_per_m2) {
  return {SampleSurface(mesh, samples_per_m2, 99), {}, [mesh](const Eigen::Vector3d& p) {
            return MeshDistance(mesh, p);
          }};
}

double BruteForcePct(const std::vector<Eigen::Vector3f>& queries,
                     const std::vector<Eigen::Vector3f>& points) {
  int near = 0;
  for (const auto& q : queries) {
    float least = 1e30f;
    for (const auto& p : points) least = std::min(least, (p - q).norm());
    near += least < static_cast<float>(kThreshold_m);
  }
  return 100.0 * near / static_cast<double>(queries.size());
}

TEST(ReconstructionScore, OfTheTruthItselfIsFull) {
  for (const TriMesh& mesh : {Box({0, 0, 0}, {4, 3, 2}), Sphere(2, 20)}) {
    const auto score = ScoreReconstruction(mesh, TruthOf(mesh, 100), {kThreshold_m, 100, 100, 1});
    EXPECT_DOUBLE_EQ(score->coverage_pct, 100);
    EXPECT_DOUBLE_EQ(score->precision_pct, 100);
    EXPECT_DOUBLE_EQ(score->f_score_pct, 100);
    EXPECT_LT(*score->surface_error_p95_m, 1e-6);  // rounding of floats
  }
}

TEST(ReconstructionScore, OfNothingIsNothing) {
  const auto score =
      ScoreReconstruction({}, TruthOf(Box({0, 0, 0}, {1, 1, 1}), 50), {kThreshold_m, 50, 50, 1});
  EXPECT_DOUBLE_EQ(score->coverage_pct, 0);
  EXPECT_DOUBLE_EQ(score->precision_pct, 0);
  EXPECT_DOUBLE_EQ(score->f_score_pct, 0);
  EXPECT_FALSE(score->surface_error_mean_m.has_value());
  EXPECT_FALSE(ScoreReconstruction(Sphere(1, 8), {}, {kThreshold_m, 50, 50, 1}).has_value());
}

TEST(ReconstructionScore, OfAShiftedMeshEqualsBruteForce) {
  const TriMesh box = Box({0, 0, 0}, {3, 2, 2});
  const TriMesh shifted = Shifted(box, {0.35f, 0.2f, 0.1f});
  const ScoreTruth truth = TruthOf(box, 60);
  const auto score = ScoreReconstruction(shifted, truth, {kThreshold_m, 60, 60, 4});
  const auto mesh_W = SampleSurface(shifted, 60, 4);
  EXPECT_NEAR(score->coverage_pct, BruteForcePct(truth.samples_W, mesh_W), 1e-9);
  EXPECT_NEAR(score->precision_pct, BruteForcePct(SampleSurface(shifted, 60, 5), SampleSurface(box, 4000, 6)),
              0.5);
  // Precision is exact; 4000 points a square metre lie 1.6 cm apart, which moves the threshold by less than a
  // millimetre.
  EXPECT_GT(score->coverage_pct, 20);
  EXPECT_LT(score->coverage_pct, 95);
  EXPECT_NEAR(score->f_score_pct, 2 / (1 / score->coverage_pct + 1 / score->precision_pct), 1e-9);
}

TEST(ReconstructionScore, OfAMeshShiftedByOneThresholdEqualsBruteForceAndGeometry) {
  const TriMesh box = Box({0, 0, 0}, {3, 2, 2});
  const double shift_m =
      1.001 * kThreshold_m;  // a thousandth more, so that no face lies just at the threshold
  const TriMesh shifted = Shifted(box, {static_cast<float>(shift_m), 0, 0});
  const ScoreTruth truth = TruthOf(box, 100);
  const auto score = ScoreReconstruction(shifted, truth, {kThreshold_m, 400, 100, 4});
  EXPECT_NEAR(score->coverage_pct, BruteForcePct(truth.samples_W, SampleSurface(shifted, 400, 4)), 1e-9);
  int near = 0;
  const auto points_W = SampleSurface(shifted, 100, 5);
  for (const auto& p_W : points_W) near += MeshDistance(box, p_W.cast<double>()) < kThreshold_m;
  EXPECT_NEAR(score->precision_pct, 100.0 * near / static_cast<double>(points_W.size()), 1e-9);
  // Of 32 m^2 too far: the face that leads (4 m^2), the face that follows where it is further than the
  // threshold from the four sides, and a strip of the sides a thousandth of the threshold wide.
  const double inner_m = 2 - 2 * kThreshold_m;
  const double far_m2 = 4 + inner_m * inner_m + 8 * (shift_m - kThreshold_m);
  EXPECT_NEAR(score->precision_pct, 100 * (1 - far_m2 / 32), 0.5);  // 3200 samples, stratified
}

TEST(ReconstructionScore, CoversHalfOfTwoEqualSpheresWhenOneIsMissing) {
  const TriMesh one = Sphere(1, 24);
  TriMesh both = one;
  const TriMesh other = Shifted(one, {10, 0, 0});
  const int offset = static_cast<int>(both.vertices_W.size());
  both.vertices_W.insert(both.vertices_W.end(), other.vertices_W.begin(), other.vertices_W.end());
  for (const auto& t : other.triangles)
    both.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});

  ScoreTruth truth = TruthOf(both, 100);
  for (const auto& p : truth.samples_W) truth.observable.push_back(p.x() < 5);
  const auto score = ScoreReconstruction(one, truth, {kThreshold_m, 100, 100, 1});
  EXPECT_NEAR(score->coverage_pct, 50, 0.1);  // counts of strata differ by one
  EXPECT_DOUBLE_EQ(score->precision_pct, 100);
  EXPECT_DOUBLE_EQ(*score->observable_coverage_pct, 100);
}

TEST(ReconstructionScore, MeasuresTheErrorOfAnInflatedSphereWhateverTheDensity) {
  const TriMesh truth = Sphere(2, 24), inflated = Sphere(2.1f, 24);
  for (const double density : {5.0, 50.0}) {
    const auto score =
        ScoreReconstruction(inflated, TruthOf(truth, density), {kThreshold_m, density, density, 1});
    // Facets of both lie 1 - cos(pi / 48) of 2 m nearer to the centre, in the same direction.
    EXPECT_NEAR(*score->surface_error_mean_m, 0.1, 0.001) << density;
    EXPECT_NEAR(*score->surface_error_p95_m, 0.1, 0.001) << density;
  }
}

}  // namespace
}  // namespace citrine::logs
