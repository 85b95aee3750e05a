#pragma once

#include "tests/meaning/runs.h"

#include "verify/verify.h"

#include <string>

namespace proskill::meaning {

/// What a user sees of a situation, called as in traces.
using Values = std::map<std::string, std::string>;

/// Traces of the engine, as runs of the interpreter. Looks into both.
class Replays {
public:
  Replays(const Script& script, const Runs& runs);

  /// Why a trace is no run of the program; nothing where it is one: some run of the interpreter has
  /// the same values of state variables, outcomes and resources in the same order, and time passes
  /// between two changes where it does in the trace, and nowhere else.
  [[nodiscard]] std::optional<std::string> whyNoRun(const verify::Trace& trace) const;

private:
  using Nodes = std::set<std::size_t>;

  /// From one of the nodes, some time later; and after a step to the values.
  [[nodiscard]] Nodes later(const Nodes& nodes) const;
  [[nodiscard]] Nodes changed(const Nodes& nodes, const Values& to) const;
  /// With what may follow unseen.
  [[nodiscard]] Nodes closed(Nodes nodes, bool time) const;
  void addLater(std::size_t at, Nodes& to) const;

  const Script& script;
  const Runs& runs;
  std::map<Values, std::size_t> numbers;
  std::vector<std::size_t> seen; ///< by node: the number of its values
};

} // namespace proskill::meaning
