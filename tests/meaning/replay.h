#pragma once

#include "tests/meaning/steps.h"

#include "verify/verify.h"

#include <map>
#include <set>
#include <string>

namespace proskill::meaning {

/// What a user sees of a situation, called as in traces.
using Values = std::map<std::string, std::string>;

/// Traces of the engine, as runs of the interpreter. Looks into the script.
class Replays {
public:
  /// \param unit seconds of a unit of the model
  Replays(const Script& of, const syntax::Rational& unit) : script(of), unit(unit) {}

  /// Why a trace is no run of the program; nothing where it is one: some run of the interpreter has
  /// the same values of state variables, outcomes and resources in the same order, with each change
  /// at the very date of the trace, and does nothing at other dates than those of the trace's
  /// steps.
  [[nodiscard]] std::optional<std::string> whyNoRun(const verify::Trace& trace) const;

private:
  using Situations = std::set<Situation>;

  /// Where the situations can be after some time, in `parts` of a unit.
  [[nodiscard]] static Situations later(const Script& script, const Situations& now,
                                        std::int64_t time, std::int64_t parts);
  /// After a step to the values.
  [[nodiscard]] Situations changed(const Situations& now, const Values& to) const;
  /// With what may follow at the same date unseen.
  [[nodiscard]] Situations closed(Situations now) const;

  const Script& script;
  syntax::Rational unit;
};

} // namespace proskill::meaning
