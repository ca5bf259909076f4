#include "sim/dynamics/trajectory_queue.h"

#include <gtest/gtest.h>

namespace citrine::sim {
namespace {

Trajectory At(double x_m, double start_s) { return Hover({x_m, 0, 0}, 0, FromSeconds(start_s)); }

TEST(TrajectoryQueue, FliesTheOlderOneUntilTheNewerOneStarts) {
  TrajectoryQueue queue(At(0, 0));
  queue.Add(At(1, 2));
  EXPECT_EQ(queue.At(FromSeconds(1.99)).p_W.x(), 0);
  EXPECT_EQ(queue.At(FromSeconds(2)).p_W.x(), 1);
}

TEST(TrajectoryQueue, TakesUpALateOneAtOnce) {
  TrajectoryQueue queue(At(0, 0));
  queue.At(FromSeconds(5));
  queue.Add(At(1, 4));
  EXPECT_EQ(queue.At(FromSeconds(5)).p_W.x(), 1);
}

TEST(TrajectoryQueue, DropsWhatWouldBeginAfterTheNewest) {
  TrajectoryQueue queue(At(0, 0));
  queue.Add(At(1, 3));
  queue.Add(At(2, 2));
  EXPECT_EQ(queue.At(FromSeconds(2.5)).p_W.x(), 2);
  EXPECT_EQ(queue.At(FromSeconds(3.5)).p_W.x(), 2);
}

TEST(TrajectoryQueue, KeepsOneThatBeginsBeforeTheNewest) {
  TrajectoryQueue queue(At(0, 0));
  queue.Add(At(1, 2));
  queue.Add(At(2, 3));
  EXPECT_EQ(queue.At(FromSeconds(2.5)).p_W.x(), 1);
  EXPECT_EQ(queue.At(FromSeconds(3.5)).p_W.x(), 2);
}

TEST(TrajectoryQueue, ForeseesWhatIsKnownWithoutTakingItUp) {
  TrajectoryQueue queue(At(0, 0));
  queue.Add(At(1, 2));
  queue.Add(At(2, 3));
  EXPECT_EQ(queue.Foresee(FromSeconds(1.99)).p_W.x(), 0);
  EXPECT_EQ(queue.Foresee(FromSeconds(2)).p_W.x(), 1);
  EXPECT_EQ(queue.Foresee(FromSeconds(3)).p_W.x(), 2);
  EXPECT_EQ(queue.At(FromSeconds(1)).p_W.x(), 0);
}

}  // namespace
}  // namespace citrine::sim
