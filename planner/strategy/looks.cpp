#include "planner/strategy/looks.h"

#include <utility>

namespace citrine::planner {

namespace {
constexpr int kPatience = 3;  ///< settling times after which a map that did not change at all has judged too
}  // namespace

void Looks::Add(std::vector<ElementMemory::Before> elements, std::int64_t revision, Utime now) {
  if (!elements.empty()) looks_.push_back({std::move(elements), revision, now});
}

bool Looks::Judge(const PlanningMap& map, const ActiveSurface& surface, Utime now, ElementMemory& memory) {
  std::vector<Look> waiting;
  bool judged = false;
  for (Look& look : looks_) {
    const bool due = now >= look.at + settle_ && map.revision() > look.revision;
    if (!due && now < look.at + kPatience * settle_) {
      waiting.push_back(std::move(look));
      continue;
    }
    for (const ElementMemory::Before& before : look.elements) memory.Judge(map, surface, before);
    judged = true;
  }
  looks_ = std::move(waiting);
  return judged;
}

void Looks::AppendTo(std::vector<std::uint32_t>& voxels) const {
  for (const Look& look : looks_)
    for (const ElementMemory::Before& before : look.elements) voxels.push_back(before.linear);
}

}  // namespace citrine::planner
