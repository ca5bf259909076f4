#pragma once

#include "viz/canvas.h"
#include "viz/relief.h"
#include "viz/scene.h"

namespace citrine::viz {

/// One thing that a picture shows. Drawing it changes nothing but the canvas.
struct Layer {
  const char* name;
  void (*draw)(const Scene& scene, const Relief& relief, Canvas& canvas);
};

}  // namespace citrine::viz
