#include "planner/fleet/balanced_kmeans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <tuple>

#include "core/random.h"

namespace citrine::planner {

namespace {

constexpr int kRoundsMax = 50;
constexpr int kManyElements = 1 << 30;
constexpr double kMustFill =
    1e12;  ///< reward of a cluster's place that has to be taken; above any distance squared

/// Successive shortest paths over the k clusters. Moving an element from cluster a to b costs what the point
/// does that loses least by it; a heap for each pair keeps these.
class Flow {
 public:
  Flow(const std::vector<WeightedPoint>& points, const std::vector<Eigen::Vector3d>& centroids_W,
       const SizeRule& rule)
      : k_(static_cast<int>(centroids_W.size())), cost_(points.size() * k_), heaps_(k_ * k_) {
    int total = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      total += points[i].weight;
      for (int j = 0; j < k_; ++j) cost_[i * k_ + j] = (points[i].p_W - centroids_W[j]).squaredNorm();
    }
    floor_ = total / k_;
    extras_ = total % k_;
    if (rule.lambda_m2) lambda_ = *rule.lambda_m2 * k_ / total;
    share_.assign(points.size(), std::vector<int>(k_));
    size_.assign(k_, 0);
    for (std::size_t i = 0; i < points.size(); ++i) Place(static_cast<int>(i), points[i].weight);
  }

  const std::vector<std::vector<int>>& share() const { return share_; }
  const std::vector<int>& size() const { return size_; }
  double Cost() const {
    double sum = 0;
    for (std::size_t i = 0; i < share_.size(); ++i)
      for (int j = 0; j < k_; ++j) sum += share_[i][j] * cost_[i * k_ + j];
    for (const int size : size_) sum += lambda_.value_or(0) * size * size;
    return sum;
  }

 private:
  struct Move {
    double cost;
    int point;
    bool operator>(const Move& other) const {
      return std::tie(cost, point) > std::tie(other.cost, other.point);
    }
  };
  using Heap = std::priority_queue<Move, std::vector<Move>, std::greater<>>;

  /// The cheapest move from a to b; drops entries of points that have left a.
  const Move* Cheapest(int a, int b) {
    Heap& heap = heaps_[a * k_ + b];
    while (!heap.empty() && share_[heap.top().point][a] == 0) heap.pop();
    return heap.empty() ? nullptr : &heap.top();
  }

  void Give(int point, int cluster, int count) {
    if (share_[point][cluster] == 0)
      for (int j = 0; j < k_; ++j)
        if (j != cluster)
          heaps_[cluster * k_ + j].push({cost_[point * k_ + j] - cost_[point * k_ + cluster], point});
    share_[point][cluster] += count;
  }

  void Place(int point, int count) {
    while (count > 0) {
      std::vector<double> length(k_);
      std::vector<int> from(k_, -1);
      for (int j = 0; j < k_; ++j) length[j] = cost_[point * k_ + j];
      for (int round = 0; round < k_; ++round)
        for (int a = 0; a < k_; ++a)
          for (int b = 0; b < k_; ++b) {
            const Move* move = a == b ? nullptr : Cheapest(a, b);
            if (move && length[a] + move->cost < length[b] - 1e-12 * (1 + std::abs(length[b]))) {
              length[b] = length[a] + move->cost;
              from[b] = a;
            }
          }
      count -= Augment(point, count, length, from);
    }
  }

  /// Elements that cluster j may still take: in the hard form up to its floor, or one beyond while extras are
  /// left.
  int Room(int j) const {
    if (lambda_) return std::numeric_limits<int>::max();
    if (size_[j] < floor_) return floor_ - size_[j];
    return size_[j] == floor_ && extras_ > 0 ? 1 : 0;
  }

  /// What the next element costs cluster j for its size.
  double Price(int j) const {
    if (lambda_) return *lambda_ * (2 * size_[j] + 1);
    return size_[j] < floor_ ? -kMustFill : 0;
  }

  /// Elements after which a cluster whose price is `ahead` lower has the same price as another.
  int UntilLevel(double ahead) const {
    const double count = lambda_.value_or(0) > 0 ? ahead / (2 * *lambda_) : kManyElements;
    return static_cast<int>(std::min<double>(count, kManyElements)) + 1;
  }

  int Augment(int point, int count, const std::vector<double>& length, const std::vector<int>& from) {
    int end = -1;
    double best = std::numeric_limits<double>::infinity(), second = best;
    for (int j = 0; j < k_; ++j) {
      if (Room(j) == 0) continue;
      const double total = length[j] + Price(j);
      if (total < best)
        second = best, best = total, end = j;
      else
        second = std::min(second, total);
    }
    int amount = std::min({count, Room(end), UntilLevel(second - best)});
    for (int b = end; from[b] >= 0; b = from[b])
      amount = std::min(amount, share_[Cheapest(from[b], b)->point][from[b]]);
    // All moves are read before the first is made.
    std::vector<std::array<int, 3>> moves;
    int first = end;
    for (; from[first] >= 0; first = from[first])
      moves.push_back({Cheapest(from[first], first)->point, from[first], first});
    for (const auto& [mover, a, b] : moves) {
      share_[mover][a] -= amount;
      Give(mover, b, amount);
    }
    Give(point, first, amount);
    if (!lambda_ && size_[end] == floor_) --extras_;
    size_[end] += amount;
    return amount;
  }

  int k_, floor_ = 0, extras_ = 0;
  std::optional<double> lambda_;  ///< of the soft form
  std::vector<double> cost_;
  std::vector<Heap> heaps_;
  std::vector<std::vector<int>> share_;
  std::vector<int> size_;
};

std::vector<Eigen::Vector3d> Centroids(const std::vector<WeightedPoint>& points, const Clusters& clusters) {
  const std::size_t k = clusters.centroid_W.size();
  std::vector<Eigen::Vector3d> centroids(k, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < k; ++j) centroids[j] += clusters.share[i][j] * points[i].p_W;
  for (std::size_t j = 0; j < k; ++j)
    centroids[j] =
        clusters.size[j] > 0 ? Eigen::Vector3d(centroids[j] / clusters.size[j]) : clusters.centroid_W[j];
  return centroids;
}

}  // namespace

Clusters Divide(const std::vector<WeightedPoint>& points, const std::vector<Eigen::Vector3d>& centroids_W,
                const SizeRule& rule) {
  const Flow flow(points, centroids_W, rule);
  return {centroids_W, flow.share(), flow.size(), flow.Cost(), 0};
}

Clusters BalancedKmeans(const std::vector<WeightedPoint>& points, int k, const SizeRule& rule,
                        std::uint64_t seed) {
  Random random(seed);
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::vector<Eigen::Vector3d> centroids;
  for (int j = 0; j < k; ++j) {
    std::swap(order[j], order[j + random.Below(static_cast<std::uint32_t>(order.size()) - j)]);
    centroids.push_back(points[order[j]].p_W);
  }
  Clusters clusters = Divide(points, centroids, rule);
  for (int round = 1; round < kRoundsMax; ++round) {
    Clusters next = Divide(points, Centroids(points, clusters), rule);
    next.iterations = round;
    const bool settled = next.share == clusters.share;
    clusters = std::move(next);
    if (settled) break;
  }
  clusters.centroid_W = Centroids(points, clusters);
  return clusters;
}

std::vector<WeightedPoint> GatherCells(const std::vector<Eigen::Vector3d>& elements_W, double cell_m) {
  std::map<std::array<int, 3>, std::pair<Eigen::Vector3d, int>> cells;
  for (const Eigen::Vector3d& p_W : elements_W) {
    const Eigen::Vector3i c = (p_W / cell_m).array().floor().cast<int>();
    auto [it, fresh] = cells.try_emplace({c.z(), c.y(), c.x()}, Eigen::Vector3d::Zero(), 0);
    it->second.first += p_W;
    ++it->second.second;
  }
  std::vector<WeightedPoint> points;
  for (const auto& [cell, sum] : cells) points.push_back({sum.first / sum.second, sum.second});
  return points;
}

}  // namespace citrine::planner
