#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace citrine::fusion {

/// Files of a folder that hold clouds, by their endings .bin, .ply and .pcd in any case; sorted by name.
/// @throws std::runtime_error if there is no such folder, or nothing of the kind in it
std::vector<std::string> FindCloudFiles(const std::string& folder);

/// [m] points of one cloud in the sensor frame; those that are not finite are left out. By its ending:
/// KITTI's .bin (x, y, z, intensity as little-endian float32), .ply (ascii or little-endian, vertices with x,
/// y, z) or .pcd (ascii or binary, fields x, y, z).
/// @throws std::runtime_error with the file, the line or byte, and what is wrong there
std::vector<Eigen::Vector3f> ReadCloud(const std::string& file);

}  // namespace citrine::fusion
