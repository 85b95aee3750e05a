#include "bridge/rl/reserved.h"

#include <algorithm>
#include <array>

namespace proskill::bridge::rl {
namespace {

/// The keywords of skillsets in both dialects, and of compositions of skills.
constexpr auto kReserved = std::to_array<std::string_view>(
    {"all",           "and",          "data",         "effect",    "elif",
     "else",          "end",          "event",        "failure",   "false",
     "guard",         "if",           "include",      "initial",   "input",
     "interrupt",     "message",      "interrupting", "invariant", "ms",
     "not",           "or",           "output",       "parameter", "period",
     "postcondition", "precondition", "progress",     "resource",  "sec",
     "skill",         "skillset",     "start",        "state",     "success",
     "then",          "transition",   "true",         "type"});

bool isReserved(std::string_view name) {
  return std::ranges::find(kReserved, name) != kReserved.end();
}

/// All names that a skillset of the program contains.
class Collector {
public:
  explicit Collector(const analysis::Program& program) {
    for (const auto& each : program.stateVariables.all) {
      add(each.name());
      for (const auto& state : each->states) add(state.text);
    }
    for (const auto& each : program.events.all) add(each.name());
    for (const auto& each : program.skills.all) {
      add(each.name());
      for (const auto& input : each->inputs) add(input.name.text.substr(1));
      for (const auto* outcomes : {&each->successes, &each->failures})
        for (const auto& outcome : *outcomes) add(outcome.tag.text);
      for (const auto& invariant : each->invariants) add(invariant.tag.text);
      for (const auto& precondition : each->preconditions) add(precondition.tag.text);
    }
  }

  std::set<std::string, std::less<>> all;

private:
  void add(std::string_view name) { all.emplace(name); }
};

} // namespace

Names::Names(const analysis::Program& program) {
  auto all = Collector(program).all;
  for (const auto name : kReserved) {
    if (!all.contains(name)) continue;
    auto made = std::string(name) + "_";
    while (!all.insert(made).second) made += '_';
    changed.emplace(name, std::move(made));
  }
}

std::string Names::operator()(std::string_view name) const {
  const auto found = isReserved(name) ? changed.find(name) : changed.end();
  return found == changed.end() ? std::string(name) : found->second;
}

} // namespace proskill::bridge::rl
