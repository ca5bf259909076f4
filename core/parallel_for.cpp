#include "core/parallel_for.h"

#include <exception>
#include <vector>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>

namespace citrine {

void RunParts(int parts, const std::function<void(int part)>& run) {
  std::vector<std::exception_ptr> errors(static_cast<std::size_t>(parts));
  const auto run_or_note = [&](int part) {
    try {
      run(part);
    } catch (...) {
      errors[static_cast<std::size_t>(part)] = std::current_exception();
    }
  };
  tbb::parallel_for(0, parts, run_or_note, tbb::simple_partitioner());
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace citrine
