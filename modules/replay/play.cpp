#include "modules/replay/play.h"

#include <cmath>

#include "modules/runtime/stopwatch.h"

namespace citrine {

void Play(const std::vector<LogEvent>& events, Transport& transport, double speed,
          const std::function<bool(const LogEvent& event)>& on_event) {
  const Stopwatch since;
  for (const LogEvent& event : events) {
    const double due_ms = Seconds(event.utime() - events.front().utime()) / speed * 1e3;
    for (double left_ms; (left_ms = due_ms - since.ms()) > 0;)
      transport.Handle(static_cast<int>(std::ceil(left_ms)));
    transport.Send(event.channel, event.bytes);
    if (!on_event(event)) return;
  }
}

}  // namespace citrine
