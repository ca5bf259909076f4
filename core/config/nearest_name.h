#pragma once

#include <string>
#include <vector>

namespace citrine {

/// The candidate that takes the fewest insertions, deletions and replacements of letters to become `name`
/// (Levenshtein 1966; the first of equals). Empty if there is no candidate.
std::string NearestName(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace citrine
