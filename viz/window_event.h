#pragma once

#include <Eigen/Core>

namespace citrine::viz {

/// What a person did in a window.
struct WindowEvent {
  enum class Kind { kKey, kDrag, kDoubleClick };
  static WindowEvent Key(int key) { return {Kind::kKey, key, {0, 0}, {0, 0}}; }
  static WindowEvent DoubleClick(const Eigen::Vector2d& at_px) {
    return {Kind::kDoubleClick, 0, at_px, {0, 0}};
  }
  static WindowEvent Drag(const Eigen::Vector2d& to_px, const Eigen::Vector2d& moved_px) {
    return {Kind::kDrag, 0, to_px, moved_px};
  }

  Kind kind = Kind::kKey;
  int key = 0;  ///< of kKey: what it types (the arrows move the window's own scroll bars)
  Eigen::Vector2d at_px = Eigen::Vector2d::Zero();     ///< of the others, in the picture
  Eigen::Vector2d moved_px = Eigen::Vector2d::Zero();  ///< of kDrag, since the last of these
};

}  // namespace citrine::viz
