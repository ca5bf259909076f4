#pragma once

#include <string>

#include <Eigen/Core>

namespace citrine {

/// The shortest text that reads back to the same double, such as "0.42", "900" or "-inf".
std::string NumberText(double value);

/// "[1, 2.5, 3]"
std::string VectorText(const Eigen::Vector3d& vector);

}  // namespace citrine
