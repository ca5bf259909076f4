#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace citrine {

/// A sweep of the smoke mission in a folder of the running test's own: two variants, two seeds.
class SweepFile {
 public:
  SweepFile() {
    const auto& test = *testing::UnitTest::GetInstance()->current_test_info();
    folder_ = testing::TempDir() + test.test_suite_name() + "." + test.name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~SweepFile() { std::filesystem::remove_all(folder_); }

  /// @param more appended to the file @return its path
  std::string Write(const std::string& more = "") const {
    std::ofstream(folder_ + "/try.toml")
        << "[sweep]\nname = \"try\"\nseeds = [1, 2]\n"
           "set = [\"mission.time_limit_s=20\"]\nover_time = [\"voxels_at_goal\"]\n"
           "[[world]]\nmission = \"smoke\"\n"
        << (more.starts_with("[[world]]") ? more : "")
        << "[[variant]]\nname = \"ours\"\n"
           "[[variant]]\nname = \"frontier\"\n"
           "set = [\"planner.strategy=nearest_frontier\"]\n"
        << (more.starts_with("[[world]]") ? "" : more);
    return folder_ + "/try.toml";
  }
  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;
};

}  // namespace citrine
