#pragma once

#include "viz/canvas.h"
#include "viz/relief.h"
#include "viz/scene.h"

namespace citrine::viz {

/// One thing that a picture shows. Drawing it changes nothing but the canvas.
struct Layer {
  const char* name;
  char key;  ///< that hides and shows it in a window; 0: always shown
  void (*draw)(const Scene& scene, const Relief& relief, Canvas& canvas);
};

}  // namespace citrine::viz
