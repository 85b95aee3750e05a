#pragma once

#include "tests/meaning/steps.h"

#include "verify/verify.h"

#include <map>
#include <set>
#include <string>

namespace proskill::meaning {

/// The visible part of a situation, with the names used in traces.
using Values = std::map<std::string, std::string>;

/// Replays traces of the engine as runs of the interpreter. Refers to the script.
class Replays {
public:
  /// \param unit seconds per unit of the model
  Replays(const Script& of, const syntax::Rational& unit) : script(of), unit(unit) {}

  /// Why a trace is not a run of the program; empty if it is one. A trace is a run if some run of
  /// the interpreter has the same values of state variables, outcomes and resources in the same
  /// order, each change at the date of the trace, and no changes at other dates.
  [[nodiscard]] std::optional<std::string> whyNoRun(const verify::Trace& trace) const;

private:
  using Situations = std::set<Situation>;

  /// The possible situations after some time, in `parts` of a unit.
  [[nodiscard]] static Situations later(const Script& script, const Situations& now,
                                        std::int64_t time, std::int64_t parts);
  /// After a step to the values.
  [[nodiscard]] Situations changed(const Situations& now, const Values& to) const;
  /// Including what may follow unseen at the same date.
  [[nodiscard]] Situations closed(Situations now) const;

  const Script& script;
  syntax::Rational unit;
};

} // namespace proskill::meaning
