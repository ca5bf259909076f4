#include "fusion/pose_file.h"

#include <array>
#include <cmath>
#include <sstream>

#include "fusion/record_reader.h"

namespace citrine::fusion {

std::vector<Pose> ReadTumPoses(const std::string& file) {
  RecordReader reader(file);
  std::vector<Pose> X_WS;
  for (std::string line; reader.NextLine(line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word[0] == '#') continue;
    std::array<double, 8> numbers{};
    std::size_t count = 0;
    do {
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (*end != '\0' || !std::isfinite(number)) reader.RefuseLine("\"" + word + "\" is no number");
      if (count < numbers.size()) numbers[count] = number;
      ++count;
    } while (words >> word);
    if (count != numbers.size())
      reader.RefuseLine(std::to_string(count) + " numbers, t x y z qx qy qz qw are expected");
    const auto [t, x, y, z, qx, qy, qz, qw] = numbers;
    const Eigen::Quaterniond q(qw, qx, qy, qz);
    if (!(std::abs(q.norm() - 1) < 0.01)) reader.RefuseLine("qx qy qz qw is no unit quaternion");
    X_WS.push_back({{x, y, z}, q.normalized()});
  }
  return X_WS;
}

}  // namespace citrine::fusion
