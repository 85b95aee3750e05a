#pragma once

#include "verify/verify.h"

#include <string>
#include <utility>

namespace proskill::verify {

/// Thrown by compilation and caught in compile(): the model uses a part of Fiacre that the engine
/// does not support, or is not Fiacre.
struct CompileError {
  Unsupported why;
};

[[noreturn]] inline void unsupported(std::string message, fiacre::OriginId origin = 0) {
  throw CompileError{{std::move(message), origin}};
}

} // namespace proskill::verify
