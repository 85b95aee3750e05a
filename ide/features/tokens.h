#pragma once

#include "ide/answers/token.h"
#include "ide/snapshot/snapshot.h"

#include <span>
#include <vector>

/// Semantic tokens: the kind of each word of a text.
namespace proskill::ide {

/// The tokens that touch `within`, in the order of the text.
[[nodiscard]] std::vector<Token> tokens(const View& view, syntax::Range within);
[[nodiscard]] std::vector<Token> tokens(const View& view);

/// The names that begin in a range, in order. The tokens of a region depend only on these and on
/// its own text.
[[nodiscard]] std::vector<Token> nameTokens(const View& view, syntax::Range within);
/// The tokens of a region of the view's document.
/// \param names of the region's range
[[nodiscard]] std::vector<Token> tokens(const View& view, const syntax::Region& region,
                                        std::span<const Token> names);

} // namespace proskill::ide
