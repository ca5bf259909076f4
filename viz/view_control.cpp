#include "viz/view_control.h"

#include <algorithm>

#include "viz/layers.h"

namespace citrine::viz {

namespace {

constexpr double kZoomStep = 1.25, kZoomMax = 40;
constexpr double kPanShare = 0.1;  // of what is seen

}  // namespace

const std::vector<ViewControl::Key>& ViewControl::Keys() {
  static const std::vector<Key> keys{
      {"+ -", "zoom; a double click zooms in there"},
      {"w a s d", "pan; or drag with the mouse"},
      {"0", "the whole mission"},
      {"1 .. 9", "follow a UAV; again: stay"},
      {"?", "these keys"},
  };
  return keys;
}

void ViewControl::Handle(const WindowEvent& event) {
  switch (event.kind) {
    case WindowEvent::Kind::kKey:
      return Press(event.key);
    case WindowEvent::Kind::kDrag:
      return Pan(Eigen::Vector2d(-event.moved_px.x(), event.moved_px.y()) / view_.pixels_per_m);
    case WindowEvent::Kind::kDoubleClick: {
      const Eigen::Vector2d middle_px = view_.area_W.sizes() * view_.pixels_per_m / 2;
      const Eigen::Vector2d from_middle_px = event.at_px - middle_px;
      Pan(Eigen::Vector2d(from_middle_px.x(), -from_middle_px.y()) / view_.pixels_per_m);
      return ZoomTo(zoom_ * kZoomStep * kZoomStep);
    }
  }
}

void ViewControl::Press(int key) {
  const Eigen::Vector2d step_W = kPanShare * view_.area_W.sizes();
  if (key == '+' || key == '=')
    ZoomTo(zoom_ * kZoomStep);
  else if (key == '-')
    ZoomTo(zoom_ / kZoomStep);
  else if (key == 'a' || key == 'd')
    Pan({key == 'a' ? -step_W.x() : step_W.x(), 0});
  else if (key == 'w' || key == 's')
    Pan({0, key == 's' ? -step_W.y() : step_W.y()});
  else if (key == '0')
    *this = ViewControl(whole_);
  else if (key >= '1' && key <= '9')
    followed_ = followed_ == key - '0' ? 0 : key - '0';
  else if (key == '?' || key == '/')
    whole_.help = !whole_.help;
  for (const Layer& layer : Layers()) {
    if (layer.key == 0 || layer.key != key) continue;
    if (const auto at = whole_.hidden.find(layer.key); at != std::string::npos)
      whole_.hidden.erase(at, 1);
    else
      whole_.hidden.push_back(layer.key);
  }
}

void ViewControl::Pan(const Eigen::Vector2d& by_W) {
  followed_ = 0;
  centre_W_ = (centre_W_ + by_W).cwiseMax(whole_.area_W.min()).cwiseMin(whole_.area_W.max());
}

void ViewControl::ZoomTo(double zoom) { zoom_ = std::clamp(zoom, 1.0, kZoomMax); }

View ViewControl::ViewOf(const Scene& scene) {
  for (const SceneUav& uav : scene.uavs)
    if (uav.id == followed_) centre_W_ = uav.state.X_WB.p.head<2>();
  const Eigen::Vector2d half_W = whole_.area_W.sizes() / 2 / zoom_;
  view_ = whole_;
  view_.area_W = {centre_W_ - half_W, centre_W_ + half_W};
  view_.pixels_per_m = whole_.pixels_per_m * zoom_;
  return view_;
}

}  // namespace citrine::viz
