#include "runtime/control/wake_up.h"

#include <cstdint>
#include <sys/eventfd.h>
#include <tuple>
#include <unistd.h>

namespace proskill::runtime {

WakeUp::WakeUp() : file(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
WakeUp::~WakeUp() { ::close(file); }

// The flag comes last: if it came first, it could be taken back before the descriptor is written
// to, which would then stay readable.
void WakeUp::ring() {
  const std::uint64_t one = 1;
  std::ignore = ::write(file, &one, sizeof one);
  rang.store(true, std::memory_order_release);
}

void WakeUp::acknowledge() {
  if (!rang.load(std::memory_order_relaxed) || !rang.exchange(false)) return;
  std::uint64_t times = 0;
  std::ignore = ::read(file, &times, sizeof times);
}

} // namespace proskill::runtime
