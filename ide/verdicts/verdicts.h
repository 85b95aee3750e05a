#pragma once

#include "ide/snapshot/snapshot.h"
#include "ide/verdicts/durations.h"
#include "ide/verdicts/verification.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The latest verdicts on programs, for lenses, hints and diagnostics.
namespace proskill::ide {

/// A place of a trace, with what happens there: "2 s: takeoff starts".
struct Waypoint {
  analysis::Location location;
  std::string description;

  bool operator==(const Waypoint&) const = default;
};

/// The verdict on one property, independent of the model.
struct PropertyVerdict {
  std::string name;        ///< `takeoff.can_succeed.at_altitude`
  std::string kind;        ///< `can_succeed`; `property` for a property of the program
  std::string subject;     ///< `takeoff`
  std::string description; ///< "`takeoff` can succeed with `at_altitude`"
  Verdict verdict = Verdict::Inconclusive;
  codegen::Weight weight = codegen::Weight::Error;
  std::optional<analysis::Location> location; ///< in the program that was verified
  std::string reason;                         ///< if inconclusive
  std::string summary;                        ///< what its trace shows; empty without a trace
  bool pending = false; ///< verification is running, and the property is not decided yet
  std::optional<std::size_t> steps; ///< number of steps of its trace; nullopt: no trace
  std::vector<Waypoint> way;        ///< first places of its trace, if the verdict is bad

  [[nodiscard]] bool good() const {
    return verdict == Verdict::Holds || verdict == Verdict::Reachable;
  }
  [[nodiscard]] bool bad() const { return verdict != Verdict::Inconclusive && !good(); }

  bool operator==(const PropertyVerdict&) const = default;
};

/// The verdicts on a program, and the texts for which they were reached.
struct ProgramVerdicts {
  std::shared_ptr<const AnalysedProgram> program;
  std::map<std::filesystem::path, std::int64_t> versions; ///< versions of the open texts
  std::vector<PropertyVerdict> properties;
  verify::Exploration exploration;
  std::vector<SkillDuration> durations; ///< empty: not measured yet, or not asked for
  bool isWhole = false;                 ///< about all properties, not only those of a request

  [[nodiscard]] bool anyPending() const {
    return std::ranges::any_of(properties, &PropertyVerdict::pending);
  }
  /// Whether there is nothing left to verify.
  [[nodiscard]] bool isComplete() const { return isWhole && !anyPending(); }
};

/// By path of the root file. Entries are immutable.
using Verdicts = std::map<std::filesystem::path, std::shared_ptr<const ProgramVerdicts>>;

/// Whether the verdicts are for exactly these texts. Otherwise they may be shown only as stale, and
/// their locations may have moved.
[[nodiscard]] bool areCurrent(const ProgramVerdicts& verdicts, const analysis::Program& now);

/// The verdicts on a program if they are current; otherwise null.
[[nodiscard]] std::shared_ptr<const ProgramVerdicts> currentVerdicts(const Verdicts& all,
                                                                     const View& view);

/// The duration of a skill; null if it is not known.
[[nodiscard]] const SkillDuration* durationOf(const ProgramVerdicts& verdicts,
                                              std::string_view skill);

/// Whether it is known that time cannot always go on.
[[nodiscard]] bool mayTimeStop(const ProgramVerdicts& verdicts);

/// The verdicts about a skill, a state variable or a property of the program, in the order of the
/// model.
[[nodiscard]] std::vector<const PropertyVerdict*> verdictsOn(const ProgramVerdicts& verdicts,
                                                             std::string_view subject);

} // namespace proskill::ide
