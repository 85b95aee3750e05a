#pragma once

#include "fiacre/provenance.h"
#include "verify/verify.h"

#include <functional>

namespace proskill::verify {

/// A variable, or the location of a process instance, by which states differ.
struct SizeCell {
  std::string name;             ///< `skill[drive].status`; of an instance: `skill_drive_1`
  fiacre::OriginId process = 0; ///< of an instance
  bool isLocation = false;
};

/// Some variables, locations and clocks of a model, and how much they multiply its classes.
struct SizePart {
  std::string name;         ///< as `partOf` has it
  std::uint64_t values = 0; ///< combinations of values of its variables and locations
  std::uint32_t clocks = 0; ///< that run in some class
  /// Classes by the number of classes that are left if those are one that differ only in this part:
  /// at least 1. Of a part that is independent of all others it is the number of its own classes.
  double factor = 1;
};

/// Where the classes of a model come from. If a limit ended the exploration, it is about the
/// classes found by then.
struct SizeReport {
  std::uint64_t found = 0;   ///< classes that were explored
  std::uint64_t classes = 0; ///< the first of them, which are counted: without included ones
  std::uint64_t states = 0;  ///< discrete ones
  bool complete = false;
  std::string stopped;            ///< the limit that was met
  std::vector<SizePart> parts;    ///< the greatest factor first; without those of factor 1
  std::vector<SizePart> kinds;    ///< several parts together, likewise
  std::vector<std::size_t> apart; ///< questions that need an exploration of their own, by index
};

/// Explores a model as for these questions, without those that need an exploration of their own,
/// and counts how much each part multiplies the classes.
/// \param partOf the name of the part to which a cell belongs
/// \param kindOf the name of the parts of its kind together, for the name of a part
/// \param options its limits are those of this exploration
[[nodiscard]] std::expected<SizeReport, Unsupported>
explainSize(const fiacre::Program& program, const fiacre::Provenance& provenance,
            const std::vector<Question>& questions,
            const std::function<std::string(const SizeCell&)>& partOf,
            const std::function<std::string(const std::string&)>& kindOf, const Options& options);

} // namespace proskill::verify
