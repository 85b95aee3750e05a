#pragma once

#include "tests/support/random/form.h"

#include "codegen/model.h"
#include "verify/verify.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::meaning {

/// The result of a comparison.
struct Comparison {
  bool tooLarge = false;
  std::size_t questions = 0; ///< decided by both
  std::size_t limited = 0;   ///< left open by the engine at a limit
  std::size_t scopes = 0;    ///< among the decided: patterns with a scope or a time
  std::size_t traces = 0;    ///< of the engine, each of which is a run of the interpreter
  std::size_t situations = 0;
  std::optional<std::string> refusal; ///< the engine does not support it
  std::optional<std::string> disagreement;
  std::string kind; ///< the disagreement: the question, and the engine's answer
};

/// Asks the engine and the interpreter of programs the same questions.
/// \param edition of the model that the engine reads
[[nodiscard]] Comparison compare(const std::vector<test::Form>& program, std::size_t limit,
                                 const verify::Options& options = {},
                                 codegen::Edition edition = codegen::Edition::Compact);

/// Reduces the program to the smallest one with a disagreement, and describes it.
[[nodiscard]] std::string smallest(std::vector<test::Form> program, std::size_t limit,
                                   const verify::Options& options = {},
                                   codegen::Edition edition = codegen::Edition::Compact);

} // namespace proskill::meaning
