#include "viz/layers.h"

namespace citrine::viz {

const std::vector<Layer>& Layers() {
  static const std::vector<Layer> layers{
      {"height", 'h', DrawHeight},
      {"confidence", 'c', DrawConfidence},
      {"active elements", 'e', DrawActiveElements},
      {"quality regions", 'r', DrawQualityRegions},
      {"trails", 't', DrawTrails},
      {"plans: path, trajectory, next view", 'p', DrawPlans},
      {"candidates of a decision", 'v', DrawCandidates},
      {"UAVs", 'u', DrawUavs},
      {"scale bar", 'b', DrawScaleBar},
      {"strip", 0, DrawStrip},
  };
  return layers;
}

}  // namespace citrine::viz
