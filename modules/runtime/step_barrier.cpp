#include "modules/runtime/step_barrier.h"

#include <algorithm>

#include "modules/channels.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/step_done.h"

namespace citrine {

StepBarrier::StepBarrier(Bus& bus, std::vector<ModuleId> modules) : bus_(bus), modules_(std::move(modules)) {
  bus_.HearBytes(channels::kStepDone.name, [this](const std::string& channel, const void* bytes, int size) {
    citrine_lcm::step_done_t message{};
    try {
      Require(message.decode(bytes, 0, size) == size, "another type or cut short");
      const StepDone done = Decode(message);
      std::int64_t& newest = done_.try_emplace({done.module, done.uav}, -1).first->second;
      newest = std::max(newest, done.step);
      for (const auto& [spoken, seq] : done.last_seq)
        if (bus_.Misses(spoken, done.uav, seq)) missing_[{spoken, done.uav}] = seq;
    } catch (const std::exception& error) {
      bus_.Reject(channel, error.what());
    }
  });
}

std::vector<ModuleId> StepBarrier::NotDone(std::int64_t step) const {
  std::vector<ModuleId> late;
  for (const ModuleId& id : modules_)
    if (const auto done = done_.find(id); done == done_.end() || done->second < step) late.push_back(id);
  return late;
}

bool StepBarrier::Complete(std::int64_t step) {
  std::erase_if(missing_,
                [&](const auto& m) { return !bus_.Misses(m.first.first, m.first.second, m.second); });
  return missing_.empty() && NotDone(step).empty();
}

void StepBarrier::GiveUpWaiting() {
  for (const auto& [whose, seq] : missing_) bus_.GiveUp(whose.first, whose.second, seq);
  missing_.clear();
}

}  // namespace citrine
