#pragma once

#include "verify/verify.h"

#include <string>
#include <utility>

namespace proskill::verify {

/// Thrown while a model is compiled, and caught at the door of verify/: something of Fiacre that
/// the engine does not run, or that is not Fiacre.
struct CompileError {
  Unsupported why;
};

[[noreturn]] inline void unsupported(std::string message, fiacre::OriginId origin = 0) {
  throw CompileError{{std::move(message), origin}};
}

} // namespace proskill::verify
