#pragma once

#include "tests/support/random/form.h"

#include <cstdint>
#include <string>
#include <vector>

namespace proskill::test {

/// How large a random program is. Counts are upper bounds of what is drawn.
struct ProgramSize {
  std::size_t stateVariables = 2;
  std::size_t naturals = 1;
  std::size_t events = 2;
  std::size_t resources = 1;
  std::size_t basicSkills = 2;
  std::size_t composites = 1; ///< beside the main skill
  std::size_t monitors = 1;
  std::size_t statements = 3; ///< in a block
  std::size_t depth = 2;      ///< of blocks in blocks
  std::size_t branches = 2;   ///< of `//` and `choose`
  std::size_t properties = 2;
  std::int64_t seconds = 3;  ///< the largest constant of time
  unsigned halves = 5;       ///< per cent of bounds that are no whole number
  unsigned environment = 20; ///< per cent of programs with a defenvironment
  unsigned library = 10;     ///< per cent of programs without a main skill
  unsigned scopes = 0;       ///< per cent of properties that have a scope or a time
  unsigned open = 15;        ///< per cent of state variables that begin with one of several values
  unsigned every = 30;       ///< per cent of events that come by themselves
  unsigned forks = 25;       ///< per cent of compound statements
  unsigned races = 40;       ///< per cent of forks that are races
  unsigned labels = 0;       ///< per cent of tests, waits and interrupts with a label before them
};

/// A well-formed program: `analysis::check` finds no error in it, warnings it may well. Over many
/// seeds every statement and every field of the language comes up, with names that Fiacre reserves
/// and names that generated code uses. The same seed and size give the same program everywhere.
[[nodiscard]] std::vector<Form> randomProgram(std::uint64_t seed, const ProgramSize& size = {});

} // namespace proskill::test
