#include "groot/breakpoints.h"

namespace proskill::groot {

namespace {

/// The run stays stopped until viewers have taken its stops, unless a page has it take single
/// steps.
constexpr std::size_t kFewAtOnce = 4;

constexpr std::uint8_t bitOf(Position position) {
  return static_cast<std::uint8_t>(1U << static_cast<unsigned>(position));
}

} // namespace

Breakpoints::Breakpoints(const Tree& tree, const runtime::Executable& executable,
                         runtime::Pause* mayStop)
    : pause(mayStop),
      on(std::make_unique<std::atomic<std::uint8_t>[]>(tree.size() + 1)),
      stops(kFewAtOnce * tree.size()),
      statuses(tree, executable, [this](Uid uid, Status status) { noticeChange(uid, status); }) {}

void Breakpoints::set(Uid uid, Position position, bool isOn) {
  const auto bit = bitOf(position);
  const auto before =
      isOn ? on[uid].fetch_or(bit) : on[uid].fetch_and(static_cast<std::uint8_t>(~bit));
  const bool was = (before & bit) != 0;
  if (isOn && !was) ++count;
  if (!isOn && was) --count;
}

bool Breakpoints::takeStop(Stop& stop) {
  return stops.pop([&](const Stop& next) { stop = next; });
}

void Breakpoints::release() {
  wentOn = true;
  pause->resume();
}

void Breakpoints::follow(const runtime::Machine& machine) {
  if (count.load(std::memory_order_relaxed) == 0) {
    isFollowing = false;
    return;
  }
  if (!pause->isHeld()) wentOn = true;
  if (!isFollowing) statuses.jump(machine.stateBefore().data());
  isFollowing = isLooking = true;
  statuses.follow(machine.state().data());
  isLooking = false;
}

void Breakpoints::noticeChange(Uid uid, Status status) {
  if (!isLooking) return;
  switch (status) {
  case Status::Idle: return;
  case Status::Running: return stopAt(uid, Position::Pre, status);
  case Status::Success:
  case Status::Failure:
  case Status::Skipped: return stopAt(uid, Position::Post, status);
  }
}

void Breakpoints::stopAt(Uid uid, Position position, Status status) {
  if ((on[uid].load(std::memory_order_relaxed) & bitOf(position)) == 0) return;
  // In this order: whoever takes the stop finds the run held.
  const bool isFirst = wentOn.exchange(false);
  pause->hold();
  stops.push([&](Stop& to) { to = {uid, position, status, isFirst}; });
}

} // namespace proskill::groot
