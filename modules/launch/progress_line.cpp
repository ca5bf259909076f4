#include "modules/launch/progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace citrine {
namespace {

constexpr std::chrono::milliseconds kRedraw{100}, kLine{5000};
constexpr int kNarrowestTerminal = 20;

template <class... Values>
std::string Format(const char* format, Values... values) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::size_t Columns(std::FILE* out) {
  winsize size{};
  const bool known = ioctl(fileno(out), TIOCGWINSZ, &size) == 0 && size.ws_col >= kNarrowestTerminal;
  return known ? size.ws_col : 120;
}

}  // namespace

std::string ProgressText(const MissionView& view, double real_time_factor) {
  if (!view.clock) return "waiting for the first CLOCK";
  const MissionProgress& progress = view.progress;
  const int seconds = static_cast<int>(Seconds(view.clock->utime));
  const double at_goal_pct = 100.0 * progress.voxels_at_goal / std::max(progress.surface_voxels, 1);
  std::string text = Format("t %02d:%02d  %.1fx  at goal %.1f%%  known %.1f%%  Z %.4f/%.4f  ASE %d",
                            seconds / 60, seconds % 60, real_time_factor, at_goal_pct, progress.known_pct,
                            progress.z_sat, progress.z_goal, progress.elements_ise + progress.elements_lqse);
  for (std::size_t i = 0; i < view.uavs.size(); ++i) {
    const MissionView::Uav& uav = view.uavs[i];
    text +=
        Format(" | %zu:%s %.1f m/s %.0f m", i + 1, uav.has_goal ? "" : " idle", uav.speed_mps, uav.path_m);
  }
  return text;
}

ProgressLine::ProgressLine(std::FILE* out) : out_(out), terminal_(isatty(fileno(out)) == 1) {}

void ProgressLine::Show(const MissionView& view) {
  if (const std::optional<std::string> stall = stall_.Look(view)) {
    Finish();
    std::fprintf(out_, "citrine: %s\n", stall->c_str());
  }
  const Clock::time_point now = Clock::now();
  if (now < next_ || (!terminal_ && !view.clock)) return;
  next_ = now + (terminal_ ? kRedraw : kLine);
  const double wall_s = std::chrono::duration<double>(now - begun_).count();
  const double mission_s = view.clock ? Seconds(view.clock->utime) : 0;
  const std::string text = ProgressText(view, mission_s / std::max(wall_s, 1e-3));
  if (terminal_)
    std::fprintf(out_, "\r\033[K%s", text.substr(0, Columns(out_) - 1).c_str());
  else
    std::fprintf(out_, "%s\n", text.c_str());
  line_open_ = terminal_;
  std::fflush(out_);
}

void ProgressLine::Finish() {
  if (line_open_) std::fputc('\n', out_);
  line_open_ = false;
}

}  // namespace citrine
