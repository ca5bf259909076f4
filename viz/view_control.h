#pragma once

#include <optional>
#include <vector>

#include "viz/scene.h"
#include "viz/view.h"
#include "viz/window_event.h"

namespace citrine::viz {

/// Moves a view by keys and mouse: pan, zoom, follow, layers.
class ViewControl {
 public:
  /// What a key does besides those of the layers (Layers()), for the help.
  struct Key {
    const char* name;
    const char* does;
  };
  static const std::vector<Key>& Keys();

  /// @param whole the view that shows everything
  explicit ViewControl(const View& whole) : whole_(whole), centre_W_(whole.area_W.center()), view_(whole) {}

  void Handle(const WindowEvent& event);

  /// The view now; its centre is the followed UAV, if there is one in the scene.
  View ViewOf(const Scene& scene);

 private:
  void Press(int key);
  void Pan(const Eigen::Vector2d& by_W);
  void ZoomTo(double zoom);

  View whole_;
  double zoom_ = 1;
  Eigen::Vector2d centre_W_;
  int followed_ = 0;  ///< id of a UAV; 0: nobody
  View view_;
};

}  // namespace citrine::viz
