#include "verify/explore/limits.h"

namespace proskill::verify {

double LimitWatch::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string LimitWatch::met(const Progress& now) {
  const auto moment = Clock::now();
  constexpr auto kPause = std::chrono::milliseconds(250);
  if (options.progress && moment - reported >= kPause) {
    reported = moment;
    options.progress(now);
  }
  const auto& limits = options.limits;
  if (options.cancelled && options.cancelled->load(std::memory_order_relaxed)) return "cancelled";
  if (limits.seconds && seconds() >= *limits.seconds) return "the time limit was met";
  if (limits.bytes && now.bytes >= *limits.bytes) return "the memory limit was met";
  if (limits.classes && now.classes >= *limits.classes) return "the limit of classes was met";
  return {};
}

} // namespace proskill::verify
