#pragma once

#include "ide/features/tokens.h"
#include "lsp/protocol/kept_parts.h"
#include "rpc/json_writer.h"
#include "syntax/text/position.h"

/// Tokens as the protocol has them: five numbers each, lines and columns as differences from the
/// token before. LSP 3.17, "Semantic Tokens".
namespace proskill::lsp {

using Numbers = std::vector<std::uint32_t>;
inline constexpr std::size_t kNumbersPerToken = 5;

[[nodiscard]] Numbers encoded(const ide::View& view, const std::vector<ide::Token>& tokens,
                              syntax::Encoding encoding);

/// The tokens of a region, independent of its position.
struct TokenPart {
  std::shared_ptr<const syntax::Tree> tree; ///< null: of a text without regions
  std::vector<ide::Token> names; ///< that the tokens were made with; ranges count from the region
  Numbers numbers;               ///< the first line counts from the region's first
  std::uint32_t lastLine = 0;    ///< of the last token, counted from the region's first
};

struct PlacedTokens {
  std::shared_ptr<const TokenPart> part;
  std::uint32_t line = 0; ///< of the first token, counted from the token before it

  friend bool operator==(const PlacedTokens&, const PlacedTokens&) = default;
};

/// The tokens of a text.
using TokenAnswer = std::vector<PlacedTokens>;

/// \param earlier an answer about the text before some edits: what they did not touch, and what
///        means the same, is taken from it
[[nodiscard]] TokenAnswer tokenAnswer(const ide::View& view, syntax::Encoding encoding,
                                      const TokenAnswer& earlier);
/// All numbers, as an array.
[[nodiscard]] std::string allTokens(const TokenAnswer& answer);
/// The protocol's edits that make one answer of another, as an array in the order of the numbers.
/// Each part that differs has an edit of its own, as long as none was added or removed.
[[nodiscard]] std::string tokenEdits(const TokenAnswer& before, const TokenAnswer& after);

} // namespace proskill::lsp
