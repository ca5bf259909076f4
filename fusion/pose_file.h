#pragma once

#include <string>
#include <vector>

#include "core/geometry/pose.h"

namespace citrine::fusion {

/// A trajectory in the format of the TUM RGB-D benchmark (Sturm et al. 2012): `t x y z qx qy qz qw` a line;
/// empty lines and those that begin with # are passed over. Quaternions are normalised.
/// @throws std::runtime_error with file, line and what is wrong there
std::vector<Pose> ReadTumPoses(const std::string& file);

}  // namespace citrine::fusion
