#pragma once

#include "tests/support/random/form.h"

#include <cstdint>
#include <string>
#include <vector>

namespace proskill::test {

/// Size of a random program. Counts are upper bounds.
struct ProgramSize {
  std::size_t stateVariables = 2;
  std::size_t naturals = 1;
  std::size_t events = 2;
  std::size_t resources = 1;
  std::size_t basicSkills = 2;
  std::size_t composites = 1; ///< besides the main skill
  std::size_t monitors = 1;
  std::size_t statements = 3; ///< in a block
  std::size_t depth = 2;      ///< nesting depth of blocks
  std::size_t branches = 2;   ///< of `//` and `choose`
  std::size_t properties = 2;
  std::int64_t seconds = 3;  ///< the largest constant of time
  unsigned halves = 5;       ///< per cent of bounds that are not integers
  unsigned environment = 20; ///< per cent of programs with a defenvironment
  unsigned library = 10;     ///< per cent of programs without a main skill
  unsigned scopes = 0;       ///< per cent of properties with a scope or a time
  unsigned open = 15;        ///< per cent of state variables with several initial values
  unsigned every = 30;       ///< per cent of events with `:every`
  unsigned guarded = 35;     ///< per cent of the other events with `:guard`
  unsigned forks = 25;       ///< per cent of compound statements
  unsigned races = 40;       ///< per cent of forks that are races
  unsigned inputs = 0;       ///< per cent of uses of values that are inputs of the skill
  unsigned next = 0;         ///< per cent of formulas that begin with `()`
  unsigned labels = 0;       ///< per cent of tests, waits and interrupts with a label before them
};

/// The same size; every third program reads inputs of its skills.
[[nodiscard]] inline ProgramSize varied(std::uint64_t seed, ProgramSize size = {}) {
  if (seed % 3 == 0) size.inputs = 60;
  return size;
}

/// A well-formed program: `analysis::check` finds no errors, possibly warnings. Many seeds cover
/// every statement and field of the language, and names that Fiacre reserves or generated code
/// uses. The same seed and size give the same program everywhere.
[[nodiscard]] std::vector<Form> randomProgram(std::uint64_t seed, const ProgramSize& size = {});

} // namespace proskill::test
