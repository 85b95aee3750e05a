#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// Why runs pass an origin, for traces that say so. Each returns the origin.

/// A condition came to `expected`.
/// \param text of the condition; empty where the words of the origin have it
OriginId decidedBy(Context& context, OriginId origin, const fiacre::Expr& condition, bool expected,
                   std::string text = {});
/// A condition was false when the step had been taken.
OriginId falseAfterwards(Context& context, OriginId origin, const fiacre::Expr& condition,
                         std::string text);
/// Other processes made this true, or false.
OriginId causedBy(Context& context, OriginId origin, const fiacre::Expr& told);
/// A natural would get a value that may be out of its bounds.
OriginId triesValue(Context& context, OriginId origin, const syntax::Effect& effect);
/// An enumeration would move to a value that its own does not allow.
OriginId triesMove(Context& context, OriginId origin, const syntax::Effect& effect);

} // namespace proskill::codegen
