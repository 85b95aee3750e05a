#pragma once

#include "ide/snapshot/snapshot.h"
#include "ide/verdicts/verification.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What was last decided about programs, for all that shows it: lenses, hints, diagnostics.
namespace proskill::ide {

/// A place that a trace passes, and what happens there: "2 s: takeoff starts".
struct Waypoint {
  analysis::Location location;
  std::string description;

  bool operator==(const Waypoint&) const = default;
};

/// The verdict on one property, without the model that it was reached on.
struct PropertyVerdict {
  std::string name;        ///< `takeoff.can_succeed.at_altitude`
  std::string kind;        ///< `can_succeed`; `property` for the program's own
  std::string subject;     ///< `takeoff`
  std::string description; ///< "`takeoff` can succeed with `at_altitude`"
  Verdict verdict = Verdict::Inconclusive;
  codegen::Weight weight = codegen::Weight::Error;
  std::optional<analysis::Location> location; ///< in the program that was verified
  std::string reason;                         ///< where inconclusive
  std::string summary;                        ///< what its trace shows; empty where it has none
  bool pending = false;                       ///< it is being verified, and not decided yet
  std::optional<std::size_t> steps;           ///< of its trace; nothing: it has none
  std::vector<Waypoint> way;                  ///< of its trace, where it is bad; the first of them

  [[nodiscard]] bool good() const {
    return verdict == Verdict::Holds || verdict == Verdict::Reachable;
  }
  [[nodiscard]] bool bad() const { return verdict != Verdict::Inconclusive && !good(); }

  bool operator==(const PropertyVerdict&) const = default;
};

/// What was decided about a program, and the texts that it was decided for.
struct ProgramVerdicts {
  std::shared_ptr<const AnalysedProgram> program;
  std::map<std::filesystem::path, std::int64_t> versions; ///< of those of its texts that were open
  std::vector<PropertyVerdict> properties;
  verify::Exploration exploration;

  [[nodiscard]] bool anyPending() const {
    return std::ranges::any_of(properties, &PropertyVerdict::pending);
  }
};

/// By the path of the root file; both maps and entries never change.
using Verdicts = std::map<std::filesystem::path, std::shared_ptr<const ProgramVerdicts>>;

/// Whether the verdicts are for just these texts. What is false of them may be shown as stale, and
/// never as current; places in it may have moved.
[[nodiscard]] bool areCurrent(const ProgramVerdicts& verdicts, const analysis::Program& now);

/// The verdicts on a program, where they are for its texts as they are now; else null.
[[nodiscard]] std::shared_ptr<const ProgramVerdicts> currentVerdicts(const Verdicts& all,
                                                                     const View& view);

/// Those about a skill, state variable or property of the program's own, in the model's order.
[[nodiscard]] std::vector<const PropertyVerdict*> verdictsOn(const ProgramVerdicts& verdicts,
                                                             std::string_view subject);

} // namespace proskill::ide
