#include "dap/player.h"

#include <algorithm>

namespace proskill::dap {

namespace {

/// A simulation may be endless, so it pauses after this many steps.
constexpr std::size_t kLongRun = 10'000;

} // namespace

Player::Player(std::unique_ptr<StepSource> from) : source(std::move(from)) {
  for (const auto& step : source->trace().steps)
    if (std::ranges::find(known, step.actor) == known.end()) known.push_back(step.actor);
  look();
}

/// Finds the possible next steps after the position has changed.
void Player::look() {
  next = source->choices();
  for (const auto& step : next)
    if (std::ranges::find(known, step.actor) == known.end()) known.push_back(step.actor);
}

std::string Player::actor() const {
  if (!next.empty()) return next.front().actor;
  return taken.empty() ? std::string() : taken.back().actor;
}

std::vector<std::pair<std::string, std::string>> Player::valuesAt(std::size_t at) const {
  std::vector<std::pair<std::string, std::string>> values;
  for (const auto& variable : source->trace().initial)
    values.emplace_back(variable.variable, variable.after);
  for (std::size_t i = 0; i < at && i < taken.size(); ++i)
    for (const auto& change : taken[i].changes) {
      auto found =
          std::ranges::find(values, change.variable, [](const auto& it) { return it.first; });
      if (found != values.end()) found->second = change.after;
    }
  return values;
}

void Player::setBreakpoints(const std::filesystem::path& path, std::set<unsigned> lines) {
  std::erase_if(breakpoints, [&](const auto& it) { return it.first == path; });
  for (auto line : lines) breakpoints.emplace(path, line);
}

bool Player::atBreakpoint() const {
  if (next.empty() || !next.front().place) return false;
  const auto& place = *next.front().place;
  return breakpoints.contains({place.path, place.line});
}

bool Player::changedWatched() const {
  return !taken.empty() && std::ranges::any_of(taken.back().changes, [&](const auto& change) {
    return watched.contains(change.variable);
  });
}

Stop Player::step(std::size_t choice) {
  if (next.empty()) return Stop::End;
  taken.push_back(next.at(choice));
  source->take(choice);
  look();
  return Stop::Step;
}

Stop Player::stepBack() {
  if (taken.empty()) return Stop::Start;
  source->undo();
  taken.pop_back();
  look();
  return Stop::Step;
}

Stop Player::run() {
  for (std::size_t i = 0; i < kLongRun || !isSimulation(); ++i) {
    if (step() == Stop::End) return Stop::End;
    if (changedWatched()) return Stop::Variable;
    if (atBreakpoint()) return Stop::Breakpoint;
    if (next.empty()) return Stop::End;
  }
  return Stop::TooLong;
}

Stop Player::runBack() {
  while (true) {
    if (stepBack() == Stop::Start) return Stop::Start;
    if (atBreakpoint()) return Stop::Breakpoint;
    if (taken.empty()) return Stop::Start;
    if (changedWatched()) return Stop::Variable;
  }
}

Stop Player::runUntil(const std::string& wanted) {
  for (std::size_t i = 0; i < kLongRun || !isSimulation(); ++i) {
    if (step() == Stop::End || next.empty()) return Stop::End;
    if (next.front().actor == wanted) return Stop::Step;
    if (changedWatched()) return Stop::Variable;
    if (atBreakpoint()) return Stop::Breakpoint;
  }
  return Stop::TooLong;
}

void Player::goTo(std::size_t wanted) {
  while (taken.size() > wanted) stepBack();
  while (taken.size() < wanted && step() != Stop::End) {
  }
}

} // namespace proskill::dap
