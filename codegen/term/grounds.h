#pragma once

#include "codegen/term/context.h"

namespace proskill::codegen {

/// Grounds: the reasons why a run passes an origin, for traces that explain them. Each function
/// returns the origin.

/// The condition had the value `expected`.
/// \param text of the condition; empty if the origin's description contains it
OriginId decidedBy(Context& context, OriginId origin, const fiacre::Expr& condition, bool expected,
                   std::string text = {});
/// The condition was false after the step.
OriginId falseAfterwards(Context& context, OriginId origin, const fiacre::Expr& condition,
                         std::string text);
/// Other processes made `told` true or false.
OriginId causedBy(Context& context, OriginId origin, const fiacre::Expr& told);
/// The step waits until the condition is true.
/// \param text what it waits for \param resource its name, if it is one
OriginId waitsFor(Context& context, OriginId origin, const fiacre::Expr& condition,
                  std::string text, std::string_view resource = {});
/// While the condition is true, a skill has a resource that a step waits for.
OriginId heldBy(Context& context, OriginId origin, const fiacre::Expr& condition,
                std::string_view skill, std::string_view resource);
/// A natural would get a value that may be out of its bounds.
OriginId triesValue(Context& context, OriginId origin, const syntax::Effect& effect);
/// An enumeration would move to a value that its current value does not allow.
OriginId triesMove(Context& context, OriginId origin, const syntax::Effect& effect);

} // namespace proskill::codegen
