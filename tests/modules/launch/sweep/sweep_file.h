#pragma once

#include <string>

#include "tests/support/scratch_folder.h"

namespace citrine {

/// A sweep of the smoke mission in a folder of the running test's own: two variants, two seeds.
class SweepFile {
 public:
  /// @param more appended to the file @return its path
  std::string Write(const std::string& more = "") const {
    return folder_.Write("try.toml",
                         "[sweep]\nname = \"try\"\nseeds = [1, 2]\n"
                         "set = [\"mission.time_limit_s=20\"]\nover_time = [\"voxels_at_goal\"]\n"
                         "[[world]]\nmission = \"smoke\"\n" +
                             (more.starts_with("[[world]]") ? more : "") +
                             "[[variant]]\nname = \"ours\"\n"
                             "[[variant]]\nname = \"frontier\"\n"
                             "set = [\"planner.strategy=nearest_frontier\"]\n" +
                             (more.starts_with("[[world]]") ? "" : more));
  }
  std::string folder() const { return folder_.path(); }

 private:
  ScratchFolder folder_;
};

}  // namespace citrine
