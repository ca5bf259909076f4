#include "planner/view/view_generator.h"

#include <gtest/gtest.h>

#include "planner/view/visibility.h"
#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

/// An element in the middle of an empty map.
class ViewGeneratorTest : public ::testing::Test {
 protected:
  ViewGeneratorTest() {
    for (int index = 0; index < grid.num_blocks(); ++index) {
      MapBlock block;
      block.index = index;
      block.version = 1;
      block.distance.fill(255);
      map.Apply(block);
    }
    map.Update();
    element.voxel = grid.IndexOf({10, 10, 10});
    element.linear = static_cast<std::uint32_t>(grid.Linear(element.voxel));
    element.p_W = grid.Centre(element.voxel);
    element.d_star_m = 4.5;
    element.normal_W = {1, 0, 0};
  }
  ViewGenerator Make(ViewGenerator::Safe safe) { return ViewGenerator(map, window, std::move(safe), {}); }

  VoxelGrid grid{0.25, Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), Eigen::Vector3d::Constant(20)), 0.75};
  PlanningMap map{grid, Quantisation(0.5, 1 / 20.25)};
  SensorWindow window{LidarModel()};
  Element element;
};

TEST_F(ViewGeneratorTest, TriesTheOptimalDistanceThenCloseThenFar) {
  const auto distance_if = [&](double min, double max) {
    const auto view = Make([&](const auto& p_W) {
                        const double d = (p_W - element.p_W).norm();
                        return d > min && d < max;
                      }).AlongNormal(element, {0, 0, 0});
    return view ? (view->p_W - element.p_W).norm() : 0;
  };
  EXPECT_NEAR(distance_if(0, 99), 4.25, 1e-9);  // d* - eta / 2
  EXPECT_LT(distance_if(0, 4.2), 4.0);
  EXPECT_GT(distance_if(0, 4.2), 0);
  EXPECT_GT(distance_if(4.6, 99), 5.0);
  EXPECT_EQ(distance_if(0, 0.1), 0);
}

TEST_F(ViewGeneratorTest, EveryViewHasItsElementInTheFieldOfViewWhateverTheNormal) {
  const ViewGenerator generator = Make([](const auto&) { return true; });
  Random random(5);
  for (int trial = 0; trial < 500; ++trial) {
    element.normal_W = Eigen::Vector3d(random.Normal(), random.Normal(), random.Normal()).normalized();
    const auto view = generator.AlongNormal(element, {1, 2, 3});
    ASSERT_TRUE(view);
    const Eigen::Vector3d to = element.p_W - view->p_W;
    const double elevation = std::asin(to.z() / to.norm()) * 180 / EIGEN_PI;
    ASSERT_GE(elevation, -35);
    ASSERT_LE(elevation, 30);
    ASSERT_NEAR(std::remainder(view->yaw_rad - std::atan2(to.y(), to.x()), 2 * EIGEN_PI), 0, 1e-9);
    const double normal = std::asin(element.normal_W.z()) * 180 / EIGEN_PI;
    if (normal > 35)
      ASSERT_NEAR(elevation, -34, 1e-6);  // from above, the limit minus a degree
    else if (normal < -30)
      ASSERT_NEAR(elevation, 29, 1e-6);
    else
      ASSERT_NEAR(elevation, -normal, 1e-6);
  }
}

TEST_F(ViewGeneratorTest, AVerticalNormalTakesItsAzimuthFromTheUav) {
  element.normal_W = {0, 0, 1};
  const auto view =
      Make([](const auto&) { return true; }).AlongNormal(element, element.p_W + Eigen::Vector3d(0, 3, 1));
  ASSERT_TRUE(view);
  EXPECT_GT((view->p_W - element.p_W).y(), 3);
  EXPECT_NEAR((view->p_W - element.p_W).x(), 0, 1e-9);
}

TEST_F(ViewGeneratorTest, LooksAroundWhereTheNormalIsBlockedAndSearchesWhereTheFanIsToo) {
  const auto aside = Make([&](const auto& p_W) { return (p_W - element.p_W).normalized().x() < 0.8; });
  EXPECT_FALSE(aside.AlongNormal(element, {0, 0, 0}));
  const auto view = aside.Around(element);
  ASSERT_TRUE(view);
  EXPECT_TRUE(aside.Holds(*view, element));
  EXPECT_GT((view->p_W - element.p_W).normalized().x(), 0.5);  // the nearest direction left

  const Eigen::Vector3d hole = grid.Centre(element.voxel + VoxelIndex(-8, 6, 2));
  const auto narrow = Make([&](const auto& p_W) { return (p_W - hole).norm() < 0.45; });
  EXPECT_FALSE(narrow.Around(element));
  const auto found = narrow.Search(element);
  ASSERT_TRUE(found);
  EXPECT_LT((found->p_W - hole).norm(), 0.45);
  EXPECT_FALSE(Make([](const auto&) { return false; }).Search(element));
}

TEST_F(ViewGeneratorTest, SearchFindsTheBestOfAllSafePosesOfTheLattice) {
  testing::RandomMap world(31);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  surface.Update(world.map);
  const std::vector<Element> elements = ListElements(world.map, surface, [](std::uint32_t) { return false; });
  const auto safe = [](const Eigen::Vector3d& p_W) {
    return std::sin(3 * p_W.x()) + std::cos(2 * p_W.y()) > 1;
  };
  const ViewGenerator generator(world.map, window, safe, {});
  const VoxelGrid& map_grid = world.map.grid();
  int found = 0;
  ViewGenerator::LatticeAnswers answers;
  for (int trial = 0; trial < 60; ++trial) {
    Element e = elements[world.random().Below(static_cast<std::uint32_t>(elements.size()))];
    e.attempts = trial % 2;
    const double ideal_m = e.attempts > 0 ? 0.6 * (4.5 - 0.5) : 4.5 - 0.25;
    std::optional<Eigen::Vector3d> expected_W;
    std::pair<int, double> least{1 << 20, 0};
    VoxelIndex v;
    for (v.z() = 0; v.z() < map_grid.inside_max().z(); v.z() += 2)
      for (v.y() = 0; v.y() < map_grid.inside_max().y(); v.y() += 2)
        for (v.x() = 0; v.x() < map_grid.inside_max().x(); v.x() += 2) {
          const Eigen::Vector3d p_W = map_grid.Centre(v);
          const double distance_m = (e.p_W - p_W).norm();
          if (!map_grid.Inside(v) || !window.Sees(e.p_W - p_W) || distance_m > generator.UsefulRange(e))
            continue;
          const Sight sight = LookAt(world.map, e, p_W);
          const std::pair<int, double> cost{sight.unknown, std::abs(distance_m - ideal_m)};
          if (!safe(p_W) || !sight.clear || cost.first > least.first) continue;
          if (cost.first == least.first && cost.second > least.second - 1e-9) continue;
          expected_W = p_W, least = cost;
        }
    const std::optional<View> view = generator.Search(e, answers), alone = generator.Search(e);
    ASSERT_EQ(view.has_value(), alone.has_value());
    if (view && alone) {
      EXPECT_EQ(view->p_W, alone->p_W);
    }
    ASSERT_EQ(view.has_value(), expected_W.has_value());
    if (!view) continue;
    // Of poses that are equally far off up to rounding it may be another one.
    EXPECT_EQ(LookAt(world.map, e, view->p_W).unknown, least.first);
    EXPECT_NEAR(std::abs((e.p_W - view->p_W).norm() - ideal_m), least.second, 1e-8);
    EXPECT_TRUE(safe(view->p_W));
    ++found;
  }
  EXPECT_GT(found, 20);
}

TEST_F(ViewGeneratorTest, MakesNoViewFromWhereNothingCanBeGained) {
  element.kind = SurfaceClass::kLqse;
  element.weight = 1 / (6.0 * 6.0);  // seen from 6 m
  const auto only_far = Make([&](const auto& p_W) { return (p_W - element.p_W).norm() > 5.9; });
  EXPECT_FALSE(only_far.Search(element));
  element.weight = 1 / (9.0 * 9.0);
  EXPECT_TRUE(only_far.Search(element));
}

TEST_F(ViewGeneratorTest, LikeElementsOfACellShareAView) {
  Element turned = element, beside = element, elsewhere = element;
  turned.normal_W = {0, 1, 0};
  const VoxelIndex first = grid.inside_min();
  element.voxel = first + VoxelIndex(30, 30, 30);
  beside.voxel = turned.voxel = first + VoxelIndex(32, 31, 30);
  elsewhere.voxel = first + VoxelIndex(33, 30, 30);
  const std::vector<Element> elements{element, beside, turned, elsewhere};
  SharedViews shared(grid);
  EXPECT_EQ(shared.Leader(elements, 0), -1);
  shared.Lead(elements, 0);
  EXPECT_EQ(shared.Leader(elements, 1), 0);
  EXPECT_EQ(shared.Leader(elements, 2), -1);
  EXPECT_EQ(shared.Leader(elements, 3), -1);
}

TEST(SurfaceNormals, PointOutOfAFlatSurface) {
  testing::RandomMap world(1, {8, 8, 6}, 0);  // nothing but the ground
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  surface.Update(world.map);
  int ground = 0;
  for (const Element& e : ListElements(world.map, surface, [](std::uint32_t) { return false; })) {
    if (e.kind != SurfaceClass::kLqse || !world.map.grid().Inside(e.voxel - VoxelIndex(1, 1, 0)) ||
        !world.map.grid().Inside(e.voxel + VoxelIndex(1, 1, 0)))
      continue;
    bool known = true;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = 0; z <= 1; ++z)
          known &=
              world.map.state(world.map.grid().Linear(e.voxel + VoxelIndex(x, y, z))) != VoxelState::kUnknown;
    if (!known) continue;
    ++ground;
    EXPECT_GT(e.normal_W.z(), 0.9);
  }
  EXPECT_GT(ground, 20);
}

}  // namespace
}  // namespace citrine::planner
