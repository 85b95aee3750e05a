#include "runtime/control/pause.h"

#include <algorithm>
#include <poll.h>

namespace proskill::runtime {

namespace {

/// More steps are not allowed in advance.
constexpr int kMostPermits = 1000;

class PausableClock final : public Clock {
public:
  PausableClock(std::unique_ptr<Clock> of, Pause& by) : inner(std::move(of)), pause(by) {}

  void start() override {
    inner->start();
    pause.tell(0, true);
    follow();
  }

  Nanoseconds now() override {
    follow();
    return isFrozen ? frozen : inner->now() + offset;
  }

  void wait(std::optional<Nanoseconds> date, const std::vector<int>& descriptors) override {
    follow();
    if (!isFrozen)
      waitOutside(date, descriptors);
    else if (date && pause.admits())
      jump(*date);
    else
      waitHere(descriptors);
    pause.wakeUp.acknowledge();
  }

  [[nodiscard]] bool isReal() const override { return inner->isReal(); }

private:
  void follow() {
    if (pause.isHeld() == isFrozen) return;
    isFrozen = !isFrozen;
    if (isFrozen)
      frozen = inner->now() + offset;
    else
      offset = frozen - inner->now();
    pause.tell(frozen, !isFrozen);
  }

  void jump(Nanoseconds date) {
    frozen = std::max(frozen, date);
    pause.tell(frozen, false);
  }

  void waitOutside(std::optional<Nanoseconds> date, const std::vector<int>& descriptors) {
    all = descriptors;
    all.push_back(pause.wakeUp.descriptor());
    inner->wait(date ? std::optional(*date - offset) : std::nullopt, all);
  }

  void waitHere(const std::vector<int>& descriptors) {
    watched.clear();
    for (const int descriptor : descriptors) watched.push_back({descriptor, POLLIN, 0});
    watched.push_back({pause.wakeUp.descriptor(), POLLIN, 0});
    ::poll(watched.data(), watched.size(), -1);
  }

  std::unique_ptr<Clock> inner;
  Pause& pause;
  bool isFrozen = false;
  Nanoseconds frozen = 0; ///< the date while it stands still
  Nanoseconds offset = 0; ///< of the inner clock
  std::vector<int> all;   ///< members, to avoid allocations
  std::vector<pollfd> watched;
};

} // namespace

void Pause::hold() {
  held = true;
  wakeUp.ring();
}

void Pause::resume() {
  permits = 0;
  held = false;
  wakeUp.ring();
}

void Pause::step() {
  if (permits < kMostPermits) ++permits;
  wakeUp.ring();
}

void Pause::passed() {
  int left = permits.load(std::memory_order_relaxed);
  while (left > 0 && !permits.compare_exchange_weak(left, left - 1)) {
  }
}

Nanoseconds Pause::date(double speed) const {
  const std::lock_guard lock(mutex);
  if (!isRunning) return told;
  const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - toldAt;
  return told + static_cast<Nanoseconds>(passed.count() * speed);
}

void Pause::tell(Nanoseconds date, bool runs) {
  const std::lock_guard lock(mutex);
  told = date;
  isRunning = runs;
  toldAt = std::chrono::steady_clock::now();
}

std::unique_ptr<Clock> pausableClock(std::unique_ptr<Clock> inner, Pause& pause) {
  return std::make_unique<PausableClock>(std::move(inner), pause);
}

} // namespace proskill::runtime
