#pragma once

#include "verify/explore/walker.h"

#include <cstddef>
#include <vector>

namespace proskill::verify {

/// Steps of a run that lead back to a state where it has been, by their first and last index
/// plus 1.
struct Detour {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] std::size_t length() const { return end - begin; }
};

/// The longest detours, one after the other. States are compared by their hashes, and clocks not at
/// all, so the caller must check that the other steps are possible.
/// \param state before the first step
/// \param last whether the last step may belong to a detour
[[nodiscard]] std::vector<Detour> detoursOf(const System& system, std::vector<Word> state,
                                            const Steps& steps, bool last);

/// The steps without some of them. \param some in order
[[nodiscard]] Steps without(const std::vector<Detour>& some, const Steps& steps);

} // namespace proskill::verify
