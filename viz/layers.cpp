#include "viz/layers.h"

namespace citrine::viz {

const std::vector<Layer>& Layers() {
  static const std::vector<Layer> layers{
      {"height", DrawHeight},
      {"confidence", DrawConfidence},
      {"active elements", DrawActiveElements},
      {"quality regions", DrawQualityRegions},
      {"trails", DrawTrails},
      {"plans", DrawPlans},
      {"uavs", DrawUavs},
      {"scale bar", DrawScaleBar},
      {"strip", DrawStrip},
  };
  return layers;
}

}  // namespace citrine::viz
