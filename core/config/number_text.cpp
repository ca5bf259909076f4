#include "core/config/number_text.h"

#include <array>
#include <charconv>

namespace citrine {

std::string NumberText(double value) {
  std::array<char, 32> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end};
}

std::string VectorText(const Eigen::Vector3d& vector) {
  return "[" + NumberText(vector.x()) + ", " + NumberText(vector.y()) + ", " + NumberText(vector.z()) + "]";
}

}  // namespace citrine
