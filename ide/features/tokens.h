#pragma once

#include "ide/answers/token.h"
#include "ide/snapshot/snapshot.h"

#include <span>
#include <vector>

/// What each word of a text is, for an editor that colours by meaning.
namespace proskill::ide {

/// In the order of the text; those that touch `within`.
[[nodiscard]] std::vector<Token> tokens(const View& view, syntax::Range within);
[[nodiscard]] std::vector<Token> tokens(const View& view);

/// The names that begin in a range, in their order: all that the tokens of a region of a program
/// depend on beside its own text.
[[nodiscard]] std::vector<Token> nameTokens(const View& view, syntax::Range within);
/// The tokens of a region of the view's document.
/// \param names of the region's range
[[nodiscard]] std::vector<Token> tokens(const View& view, const syntax::Region& region,
                                        std::span<const Token> names);

} // namespace proskill::ide
