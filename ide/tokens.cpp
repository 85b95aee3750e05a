#include "ide/tokens.h"

#include "ide/fiacre_file.h"
#include "ide/fiacre_text.h"

#include <algorithm>
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

/// Whether a definition that nothing mentions is of no use; a property or a tag is of use alone.
bool isForOthers(SymbolKind kind) {
  switch (kind) {
  case SymbolKind::StateVariable:
  case SymbolKind::Event:
  case SymbolKind::Resource:
  case SymbolKind::Parameter:
  case SymbolKind::Label: return true;
  default: return false;
  }
}

/// The type of a token that names nothing; none where it has no colour of its own.
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

class Collector {
public:
  Collector(const View& view, syntax::Range within)
      : view(view), text(view.text()), within(within), names(view.index().occurrences()) {
    auto before = [&](const Occurrence& name) {
      return std::pair(name.at.file, name.at.range.end) < std::pair(view.file, within.begin);
    };
    name = std::ranges::partition_point(names, before);
  }

  std::vector<Token> run() {
    for (const auto& stretch : view.document().stretches()) {
      if (stretch.range.end < within.begin || stretch.range.begin > within.end) continue;
      // What was put in or left out to read it makes no other tokens.
      const auto& tree = *stretch.tree;
      for (std::size_t at = 1; at < tree.size();) at += visit(tree[at], stretch.range.begin);
    }
    return std::move(result);
  }

private:
  /// How many nodes are dealt with.
  std::size_t visit(const syntax::Node& node, syntax::Offset shift) {
    bool isString = node.kind == NodeKind::String;
    if (node.size > 1 && !isString) return 1;
    syntax::Range range{node.range.begin + shift, node.range.end + shift};
    if (!range.empty() && range.end >= within.begin && range.begin <= within.end)
      add(node.kind, range);
    return node.size;
  }

  void add(NodeKind kind, syntax::Range range) {
    if (const auto* occurrence = nameAt(range)) return addName(*occurrence, range);
    auto type = typeOf(kind, text.substr(range.begin, range.length()));
    if (kind == NodeKind::Symbol) type = typeOfPlainSymbol(range);
    if (type) result.push_back({range, *type, 0});
  }

  const Occurrence* nameAt(syntax::Range range) {
    while (name != names.end() && name->at.file == view.file && name->at.range.end <= range.begin)
      ++name;
    bool here = name != names.end() && name->at.file == view.file &&
                name->at.range.begin < range.end && range.begin <= name->at.range.begin;
    return here ? &*name : nullptr;
  }

  void addName(const Occurrence& occurrence, syntax::Range range) {
    const auto& symbol = view.index().symbols()[occurrence.symbol];
    std::uint8_t modifiers = 0;
    if (occurrence.role == Role::Definition) modifiers |= kDefinition;
    if (occurrence.role == Role::Write) modifiers |= kWritten;
    if (occurrence.role == Role::Definition && isForOthers(symbol.kind) &&
        view.index().occurrencesOf(occurrence.symbol).size() == 1)
      modifiers |= kUnused;
    result.push_back({range, typeOf(symbol.kind), modifiers});
  }

  /// A type behind a `$parameter`.
  std::optional<TokenType> typeOfPlainSymbol(syntax::Range range) const {
    auto word = text.substr(range.begin, range.length());
    bool isType = !result.empty() && result.back().type == TokenType::Parameter &&
                  std::ranges::find(kTypes, word) != std::end(kTypes);
    return isType ? std::optional(TokenType::Type) : std::nullopt;
  }

  static constexpr std::string_view kTypes[] = {"int", "nat", "float", "bool", "string"};

  const View& view;
  std::string_view text;
  syntax::Range within;
  std::span<const Occurrence> names;
  std::span<const Occurrence>::iterator name;
  std::vector<Token> result;
};

} // namespace

std::vector<Token> tokens(const View& view, syntax::Range within) {
  if (!isFiacre(view)) return Collector(view, within).run();
  auto all = FiacreText(view.text()).tokens();
  std::erase_if(all, [&](const Token& token) {
    return token.range.end < within.begin || within.end < token.range.begin;
  });
  return all;
}

std::vector<Token> tokens(const View& view) {
  return tokens(view, {0, static_cast<syntax::Offset>(view.text().size())});
}

} // namespace proskill::ide
