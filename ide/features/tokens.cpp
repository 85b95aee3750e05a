#include "ide/features/tokens.h"

#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"

#include <algorithm>
#include <iterator>
#include <optional>

namespace proskill::ide {

namespace {

using analysis::Occurrence;
using analysis::Role;
using analysis::SymbolKind;
using syntax::NodeKind;

TokenType typeOf(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::StateVariable: return TokenType::Variable;
  case SymbolKind::Event: return TokenType::Event;
  case SymbolKind::Skill: return TokenType::Skill;
  case SymbolKind::Resource: return TokenType::Resource;
  case SymbolKind::Property: return TokenType::Property;
  case SymbolKind::Environment: return TokenType::Environment;
  case SymbolKind::Constant:
  case SymbolKind::Value: return TokenType::Value;
  case SymbolKind::Parameter: return TokenType::Parameter;
  case SymbolKind::PreconditionTag:
  case SymbolKind::InvariantTag:
  case SymbolKind::SuccessTag:
  case SymbolKind::FailureTag: return TokenType::Tag;
  case SymbolKind::Label: return TokenType::Label;
  }
  return TokenType::Variable;
}

/// Whether a definition without uses is useless. Properties and tags are not.
bool isForOthers(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::StateVariable:
  case SymbolKind::Event:
  case SymbolKind::Resource:
  case SymbolKind::Constant:
  case SymbolKind::Parameter:
  case SymbolKind::Label: return true;
  default: return false;
  }
}

/// The type of a token that is not a name; nullopt if it has no colour of its own.
std::optional<TokenType> typeOf(NodeKind kind, std::string_view word) {
  switch (kind) {
  case NodeKind::Comment: return TokenType::Comment;
  case NodeKind::String: return TokenType::String;
  case NodeKind::Number:
  case NodeKind::Unbounded: return TokenType::Number;
  case NodeKind::Boolean:
  case NodeKind::All:
  case NodeKind::Break: return TokenType::Keyword;
  case NodeKind::Keyword: return TokenType::Field;
  case NodeKind::Operator: return TokenType::Operator;
  case NodeKind::Parameter: return TokenType::Parameter;
  case NodeKind::Token: break;
  default: return std::nullopt;
  }
  if (word.starts_with(':')) return TokenType::Field;
  if (word.front() >= 'a' && word.front() <= 'z') return TokenType::Keyword;
  bool isBracket = std::string_view("[],.").contains(word);
  return isBracket ? std::nullopt : std::optional(TokenType::Operator);
}

Token tokenOf(const analysis::Index& index, const Occurrence& occurrence) {
  const auto& symbol = index.symbols()[occurrence.symbol];
  std::uint8_t modifiers = 0;
  if (occurrence.role == Role::Definition) modifiers |= kDefinition;
  if (occurrence.role == Role::Write) modifiers |= kWritten;
  if (occurrence.role == Role::Definition && isForOthers(symbol.kind) &&
      index.countOf(occurrence.symbol) == 1)
    modifiers |= kUnused;
  return {occurrence.at.range, typeOf(symbol.kind), modifiers};
}

/// Whether a word is the type after a `$parameter`.
bool isType(const std::vector<Token>& before, std::string_view word) {
  static constexpr std::string_view kTypes[] = {"int", "nat", "float", "bool", "string"};
  return !before.empty() && before.back().type == TokenType::Parameter &&
         std::ranges::find(kTypes, word) != std::end(kTypes);
}

/// Iterates over the words and the names of a region in parallel.
class Collector {
public:
  Collector(std::string_view text, std::span<const Token> names) : text(text), name(names) {}

  std::vector<Token> run(const syntax::Region& region) {
    const auto& tree = *region.tree;
    for (std::size_t at = 1; at < tree.size();) at += visit(tree[at], region.range.begin);
    return std::move(result);
  }

private:
  /// \return the number of processed nodes. Nodes that recovery inserted produce no tokens.
  std::size_t visit(const syntax::Node& node, syntax::Offset shift) {
    if (node.size > 1 && node.kind != NodeKind::String) return 1;
    if (!node.range.empty()) add(node.kind, {node.range.begin + shift, node.range.end + shift});
    return node.size;
  }

  void add(NodeKind kind, syntax::Range range) {
    while (!name.empty() && name.front().range.end <= range.begin) name = name.subspan(1);
    if (!name.empty() && name.front().range.begin < range.end &&
        range.begin <= name.front().range.begin) {
      result.push_back({range, name.front().type, name.front().modifiers});
      return;
    }
    const auto word = text.substr(range.begin, range.length());
    auto type = typeOf(kind, word);
    if (kind == NodeKind::Symbol && isType(result, word)) type = TokenType::Type;
    if (type) result.push_back({range, *type, 0});
  }

  std::string_view text;
  std::span<const Token> name; ///< the names that remain
  std::vector<Token> result;
};

} // namespace

std::vector<Token> nameTokens(const View& view, syntax::Range within) {
  std::vector<Token> result;
  for (const auto& name : view.index().occurrences({view.file, within}))
    result.push_back(tokenOf(view.index(), name));
  return result;
}

std::vector<Token> tokens(const View& view, const syntax::Region& region,
                          std::span<const Token> names) {
  return Collector(view.text(), names).run(region);
}

std::vector<Token> tokens(const View& view, syntax::Range within) {
  std::vector<Token> result;
  if (isFiacre(view)) {
    result = FiacreText(view.text()).tokens();
  } else {
    for (const auto& region : view.document().regions())
      if (region.range.touches(within))
        std::ranges::copy(tokens(view, region, nameTokens(view, region.range)),
                          std::back_inserter(result));
  }
  std::erase_if(result, [&](const Token& token) { return !token.range.touches(within); });
  return result;
}

std::vector<Token> tokens(const View& view) {
  return tokens(view, {0, static_cast<syntax::Offset>(view.text().size())});
}

} // namespace proskill::ide
