#include "modules/topdown_renderer/topdown_renderer_module.h"

#include "modules/runtime/cpu_stopwatch.h"
#include "viz/display.h"

namespace citrine {

namespace {

constexpr double kPicturePeriod_s = 10;  ///< of the wall: who looks at pictures lives there
constexpr double kLockstepPace = 8;      ///< that lockstep may reach
constexpr double kOfScreen = 0.92;       ///< that a window fills; the rest is for the desktop's bars

double PicturePeriod_s(const MissionConfig& config) {
  return kPicturePeriod_s * (config.lockstep() ? kLockstepPace : config.launch.pace);
}

/// All of the mission, as large as a window on this screen can show it.
viz::View FirstView(const viz::TopdownRenderer& renderer) {
  const std::optional<Eigen::Vector2d> screen_px = viz::ScreenSize_px();
  return screen_px ? renderer.WholeWithin(kOfScreen * *screen_px) : renderer.whole();
}

}  // namespace

TopdownRendererModule::TopdownRendererModule(const ModuleContext& context)
    : health_(context.health),
      out_(context.config.launch.out),
      frame_hz_(context.config.viz.frame_hz),
      wants_video_(context.config.launch.video && !out_.empty()),
      scene_(context),
      renderer_(context.config.volume_W(), context.config.viz.pixels_per_m),
      picture_due_(PicturePeriod_s(context.config), FromSeconds(PicturePeriod_s(context.config))),
      frame_due_(1 / frame_hz_),
      control_(context.config.launch.view ? FirstView(renderer_) : renderer_.whole()) {
  if (context.config.launch.view) window_.emplace("citrine: " + context.config.mission.name);
}

void TopdownRendererModule::Tick(const Step& step) {
  scene_.Update(step);
  const bool picture = (picture_due_.Due(step.now) || step.last) && !out_.empty();
  const bool frame = frame_due_.Due(step.now) || step.last;
  if (window_) ShowInWindow(frame);
  if (!picture && !(frame && wants_video_)) return;

  const CpuStopwatch stopwatch;
  Write(renderer_.Draw(scene_.Finish()), picture, frame && wants_video_);
  if (step.last) video_.reset();
  health_.Sample("frame_ms", stopwatch.ms());
}

void TopdownRendererModule::ShowInWindow(bool due) {
  const std::vector<viz::WindowEvent> events = window_->TakeEvents();
  for (const viz::WindowEvent& event : events) control_.Handle(event);
  if (!due && events.empty()) return;
  const viz::Scene& scene = scene_.Finish();
  window_->Show(renderer_.Draw(scene, control_.ViewOf(scene)));
}

void TopdownRendererModule::Write(const viz::Image& frame, bool picture, bool video) {
  try {
    if (picture) viz::WritePng(out_ + "/topdown.png", frame);
    if (video && !video_) video_.emplace(out_ + "/topdown.mp4", frame.width, frame.height, frame_hz_);
    if (video) video_->Add(frame);
  } catch (const viz::FrameError& error) {
    health_.Error(error.what());
    if (video && !video_) wants_video_ = false;
  }
}

}  // namespace citrine
