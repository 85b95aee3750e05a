#pragma once

#include "ide/features/tokens.h"
#include "lsp/protocol/kept_parts.h"
#include "rpc/json_writer.h"
#include "syntax/text/position.h"

/// Tokens in the protocol's format: five numbers each, with lines and columns relative to the
/// previous token. LSP 3.17, "Semantic Tokens".
namespace proskill::lsp {

using Numbers = std::vector<std::uint32_t>;
inline constexpr std::size_t kNumbersPerToken = 5;

[[nodiscard]] Numbers encoded(const ide::View& view, const std::vector<ide::Token>& tokens,
                              syntax::Encoding encoding);

/// The tokens of a region, independent of its position.
struct TokenPart {
  std::shared_ptr<const syntax::Tree> tree; ///< null: for a text without regions
  /// The names from which the tokens were computed; ranges count from the region's begin.
  std::vector<ide::Token> names;
  Numbers numbers;            ///< the first line counts from the region's first line
  std::uint32_t lastLine = 0; ///< of the last token, counted from the region's first line
};

struct PlacedTokens {
  std::shared_ptr<const TokenPart> part;
  std::uint32_t line = 0; ///< of the first token, relative to the previous token

  friend bool operator==(const PlacedTokens&, const PlacedTokens&) = default;
};

/// The tokens of a text.
using TokenAnswer = std::vector<PlacedTokens>;

/// \param earlier an answer for the text before some edits; its unchanged parts are reused
[[nodiscard]] TokenAnswer tokenAnswer(const ide::View& view, syntax::Encoding encoding,
                                      const TokenAnswer& earlier);
/// All numbers, as an array.
[[nodiscard]] std::string allTokens(const TokenAnswer& answer);
/// The protocol's edits from one answer to another, as an array in the order of the numbers. Each
/// part that differs has its own edit if no part was added or removed.
[[nodiscard]] std::string tokenEdits(const TokenAnswer& before, const TokenAnswer& after);

} // namespace proskill::lsp
