#pragma once

#include "verify/model/system.h"

#include <vector>

namespace proskill::verify {

/// A test in the code of a path that decides nothing but which events happen, as whether a move is
/// forbidden. Nothing depends on it if nobody asks for these events.
struct IdleTest {
  std::size_t first = 0; ///< the test
  std::size_t last = 0;  ///< where all ways from it have met again; what is between belongs to it
  Bits events;           ///< that it decides about
};

/// The tests of this kind, in the order of the code; a test may contain later ones.
[[nodiscard]] std::vector<IdleTest> idleTests(const System& system, const Path& path);

/// The path without those of these tests that decide about none of the events.
[[nodiscard]] Path withoutIdleTests(const System& system, Path path, const Bits& events);
/// The system with such paths. \pre it has no observers
[[nodiscard]] System withoutIdleTests(System system, const Bits& events);

} // namespace proskill::verify
