#include "planner/path/tour.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace citrine::planner {

namespace {

constexpr double kShorter_m = 1e-6;
constexpr std::size_t kChainMax = 3;  ///< places that are moved together

/// A way with its start in front, to be shortened in place.
class Tour {
 public:
  Tour(const Eigen::Vector3d& start_W, const std::vector<Eigen::Vector3d>& places_W) : at_W_(places_W) {
    at_W_.insert(at_W_.begin(), start_W);
    order_.resize(at_W_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (std::size_t i = 1; i + 1 < order_.size(); ++i) {
      const auto nearer = [&](std::size_t a, std::size_t b) {
        return Leg(order_[i - 1], a) < Leg(order_[i - 1], b);
      };
      std::iter_swap(order_.begin() + Offset(i),
                     std::min_element(order_.begin() + Offset(i), order_.end(), nearer));
    }
  }

  /// Turns a part around where that is shorter.
  bool TurnParts() {
    bool shorter = false;
    for (std::size_t i = 1; i < order_.size(); ++i)
      for (std::size_t j = i + 1; j < order_.size(); ++j) {
        const double now = Between(i - 1, i) + Between(j, j + 1),
                     then = Between(i - 1, j) + Between(i, j + 1);
        if (then > now - kShorter_m) continue;
        std::reverse(order_.begin() + Offset(i), order_.begin() + Offset(j) + 1);
        shorter = true;
      }
    return shorter;
  }

  /// Moves a short chain to where it is less of a detour.
  bool MoveChains() {
    for (std::size_t length = 1; length <= kChainMax; ++length)
      for (std::size_t i = 1; i + length <= order_.size(); ++i)
        for (std::size_t to = 0; to < order_.size(); ++to) {
          if (to + 1 >= i && to < i + length) continue;
          const std::size_t last = i + length - 1;
          const double saved = Between(i - 1, i) + Between(last, last + 1) - Between(i - 1, last + 1);
          const double added = Between(to, i) + Between(last, to + 1) - Between(to, to + 1);
          if (added > saved - kShorter_m) continue;
          const auto first = order_.begin() + Offset(i), end = first + Offset(length);
          if (to < i)
            std::rotate(order_.begin() + Offset(to) + 1, first, end);
          else
            std::rotate(first, end, order_.begin() + Offset(to) + 1);
          return true;
        }
    return false;
  }

  std::vector<std::size_t> Places() const {
    std::vector<std::size_t> places;
    for (std::size_t i = 1; i < order_.size(); ++i) places.push_back(order_[i] - 1);
    return places;
  }

 private:
  static std::ptrdiff_t Offset(std::size_t i) { return static_cast<std::ptrdiff_t>(i); }
  double Leg(std::size_t a, std::size_t b) const { return (at_W_[a] - at_W_[b]).norm(); }
  /// Of two positions in the order; nothing follows the last.
  double Between(std::size_t a, std::size_t b) const {
    return a < order_.size() && b < order_.size() ? Leg(order_[a], order_[b]) : 0;
  }

  std::vector<Eigen::Vector3d> at_W_;
  std::vector<std::size_t> order_;
};

}  // namespace

std::vector<std::size_t> ShortTour(const Eigen::Vector3d& start_W,
                                   const std::vector<Eigen::Vector3d>& places_W) {
  Tour tour(start_W, places_W);
  while (tour.TurnParts() || tour.MoveChains()) {
  }
  return tour.Places();
}

}  // namespace citrine::planner
