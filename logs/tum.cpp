#include "logs/tum.h"

#include "core/time.h"
#include "logs/number_text.h"

namespace citrine::logs {

std::string ToTum(const std::vector<UavState>& states) {
  std::string text;
  for (const UavState& state : states) {
    const Eigen::Vector3d& p = state.X_WB.p;
    const Eigen::Quaterniond& q = state.X_WB.q;
    text += Fixed(Seconds(state.utime), 6);
    for (const double x : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) text += " " + Fixed(x, 6);
    text += "\n";
  }
  return text;
}

}  // namespace citrine::logs
