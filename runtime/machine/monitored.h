#pragma once

#include "codegen/model.h"
#include "verify/model/goals.h"
#include "verify/verify.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::runtime {

/// What is known of a property during a run.
enum class Verdict : std::uint8_t { NotYet, True, False };

/// `not yet`
[[nodiscard]] std::string_view toString(Verdict verdict);

/// One of the program's own properties, as a run decides it.
struct Monitored {
  std::size_t check = 0; ///< index into codegen::Model::checks
  /// What violates the property. Another kind than Events, Condition and Run is not monitored.
  verify::Goal goal;
  std::optional<verify::Goal> negated; ///< LTL: what violates the negation of the formula
  bool isGood = false;                 ///< `reachable`: the goal is what the property asks for
};

/// Adds the negation of each formula of LTL among the checks to the model's properties.
/// \return the questions to compile, for `monitored`
std::vector<verify::Question> addNegations(codegen::Model& model);

/// \param goals of the questions that `addNegations` returned
[[nodiscard]] std::vector<Monitored> monitored(const codegen::Model& model,
                                               const std::vector<verify::Goal>& goals);

/// Why a run never decides a property; empty if it may.
[[nodiscard]] std::string whyNotMonitored(const Monitored& property);

} // namespace proskill::runtime
