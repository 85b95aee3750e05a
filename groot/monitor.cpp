#include "groot/monitor.h"

#include <chrono>

namespace proskill::groot {

namespace {

using std::chrono::steady_clock;
using std::chrono::system_clock;

constexpr std::size_t kQueued = std::size_t{1} << 20; ///< bytes
/// More states than the queue has room for: whoever asks gets those that were in it.
constexpr int kMostAtOnce = 1 << 15;
constexpr std::chrono::milliseconds kMoment{4};

template <class Clock> std::uint64_t now() {
  using std::chrono::microseconds;
  const auto time = Clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<microseconds>(time).count());
}

class Steps final : public runtime::Observer {
public:
  explicit Steps(Monitor& of) : monitor(of) {}
  void onStep(const runtime::Machine& machine, verify::TransitionId, runtime::Nanoseconds,
              runtime::Nanoseconds) override {
    monitor.follow(machine);
  }
  void onRemark(const runtime::Remark&) override {}

private:
  Monitor& monitor;
};

} // namespace

Monitor::Monitor(Tree of, const runtime::Executable& executable, std::unique_ptr<Sockets> at,
                 bool mayWait, Influence influence)
    : tree(std::move(of)),
      waits(mayWait),
      sockets(std::move(at)),
      breakpoints(tree, executable, influence.pause),
      hooks(tree.size(), breakpoints, std::move(influence.whyNot),
            [this](Uid uid) { sockets->publish(Protocol::stopMessage(uid, ++stops)); }),
      protocol(tree, executable, hooks, randomTreeId()),
      queue(kQueued),
      thread([this] { serve(); }) {}

Monitor::~Monitor() {
  isOver = true;
  bell.ring();
  thread.join();
}

std::unique_ptr<runtime::Observer> Monitor::observer() { return std::make_unique<Steps>(*this); }

void Monitor::follow(const runtime::Machine& machine) {
  breakpoints.follow(machine);
  push(machine.state());
}

void Monitor::push(const std::vector<verify::Word>& state) {
  const std::string_view bytes(reinterpret_cast<const char*>(state.data()),
                               state.size() * sizeof(verify::Word));
  const auto add = [&] { return queue.push({now<steady_clock>(), isGap}, bytes); };
  auto isAdded = add();
  for (; !isAdded && waits; isAdded = add()) std::this_thread::sleep_for(kMoment);
  isGap = !isAdded;
  if (isAsleep.exchange(false)) bell.ring();
}

void Monitor::serve() {
  while (!isOver) {
    const bool isBehind = takeSome();
    hooks.followRun();
    hooks.notice(now<steady_clock>());
    isAsleep = !isBehind;
    const bool mustWait = !isBehind && queue.used() == 0 && !isOver;
    sockets->wait(bell.descriptor(), mustWait ? longestWait() : 0);
    isAsleep = false;
    bell.acknowledge();
    const auto request = sockets->receive();
    if (!request) continue;
    takeSome();
    sockets->reply(protocol.answer(*request, now<steady_clock>(), now<system_clock>()));
  }
}

/// In milliseconds; -1: without limit.
long Monitor::longestWait() const {
  const auto left = hooks.nextNotice(now<steady_clock>());
  return left ? static_cast<long>(*left / 1000 + 1) : -1;
}

/// \return whether there may be more
bool Monitor::takeSome() {
  std::vector<verify::Word> state;
  const auto take = [&](Moment moment, std::string_view bytes) {
    state.resize(bytes.size() / sizeof(verify::Word));
    bytes.copy(reinterpret_cast<char*>(state.data()), bytes.size());
    protocol.follow(state.data(), moment);
  };
  for (int i = 0; i < kMostAtOnce; ++i)
    if (!queue.pop(take)) return false;
  return true;
}

} // namespace proskill::groot
