#pragma once

#include "tests/support/random/form.h"

#include "verify/verify.h"

#include <optional>
#include <string>
#include <vector>

namespace proskill::meaning {

/// What came of a comparison.
struct Comparison {
  bool tooLarge = false;
  std::size_t questions = 0; ///< that were decided by both
  std::size_t scopes = 0;    ///< of these, patterns with a scope or a time
  std::size_t traces = 0;    ///< of the engine, each a run of the interpreter
  std::size_t situations = 0;
  std::optional<std::string> refusal; ///< the engine cannot run it
  std::optional<std::string> disagreement;
  std::string kind; ///< of the disagreement: which question, and what the engine says
};

/// Asks the engine and the interpreter of programs the same questions.
[[nodiscard]] Comparison compare(const std::vector<test::Form>& program, std::size_t limit,
                                 const verify::Options& options = {});

/// The smallest program that still shows that they disagree, and on what.
[[nodiscard]] std::string smallest(std::vector<test::Form> program, std::size_t limit,
                                   const verify::Options& options = {});

} // namespace proskill::meaning
