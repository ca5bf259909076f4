#pragma once

#include <optional>
#include <string>

#include "modules/runtime/module.h"
#include "modules/topdown_renderer/scene_hearer.h"
#include "viz/frame_writer.h"
#include "viz/topdown_renderer.h"
#include "viz/view_control.h"
#include "viz/window.h"

namespace citrine {

/// The mission seen from above: hears everything and says nothing. Writes topdown.png into the result folder
/// every ten seconds of mission time and at the end, topdown.mp4 with launch.video, and shows a
/// window with launch.view, in which keys and mouse pan, zoom, follow a UAV and choose layers.
class TopdownRendererModule : public Module {
 public:
  static constexpr const char* kName = "topdown_renderer";
  static constexpr const char* kSummary = "draws the mission from above: picture, video, window";
  static constexpr bool kHearsMap = true;
  static constexpr bool kPerUav = false;

  /// @throws viz::FrameError with launch.view where there is no display
  explicit TopdownRendererModule(const ModuleContext& context);

  void Tick(const Step& step) override;

 private:
  void Write(const viz::Image& frame, bool picture, bool video);
  /// Redraws the window when that is due or its viewer asks for another view.
  void ShowInWindow(bool due);

  Health& health_;
  std::string out_;
  double frame_hz_;
  bool wants_video_;
  SceneHearer scene_;
  viz::TopdownRenderer renderer_;
  Every picture_due_, frame_due_;
  std::optional<viz::VideoWriter> video_;
  viz::ViewControl control_;
  std::optional<viz::Window> window_;
};

}  // namespace citrine
