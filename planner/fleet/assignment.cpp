#include "planner/fleet/assignment.h"

#include <limits>

namespace citrine::planner {

std::vector<int> Assign(const Eigen::MatrixXd& cost) {
  const int n = static_cast<int>(cost.rows());
  constexpr int kFree = -1;
  // Dual prices of rows and columns; a matched pair's reduced cost is zero, and no reduced cost is negative.
  std::vector<double> row_price(n, 0), column_price(n, 0);
  std::vector<int> row_of(n, kFree);
  for (int start = 0; start < n; ++start) {
    // Dijkstra over columns, from the row that has none, to the nearest free column.
    std::vector<double> slack(n, std::numeric_limits<double>::infinity());
    std::vector<int> from(n, kFree);  // column before this one on the way; kFree: the start row itself
    std::vector<bool> done(n, false);
    int row = start, column = kFree;
    while (row != kFree) {
      int nearest = kFree;
      for (int j = 0; j < n; ++j) {
        if (done[j]) continue;
        const double reduced = cost(row, j) - row_price[row] - column_price[j];
        if (reduced < slack[j]) slack[j] = reduced, from[j] = column;
        if (nearest == kFree || slack[j] < slack[nearest]) nearest = j;
      }
      const double step = slack[nearest];
      row_price[start] += step;
      for (int j = 0; j < n; ++j) {
        if (done[j]) {
          row_price[row_of[j]] += step;
          column_price[j] -= step;
        } else {
          slack[j] -= step;
        }
      }
      done[nearest] = true;
      column = nearest;
      row = row_of[column];
    }
    for (; column != kFree; column = from[column])
      row_of[column] = from[column] == kFree ? start : row_of[from[column]];
  }
  std::vector<int> column_of(n);
  for (int j = 0; j < n; ++j) column_of[row_of[j]] = j;
  return column_of;
}

}  // namespace citrine::planner
