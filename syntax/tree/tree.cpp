#include "syntax/tree/tree.h"

#include <array>
#include <cassert>
#include <optional>

#include <fmt/format.h>
#include <tree_sitter/api.h>
#include <tree_sitter/tree-sitter-proskill.h>

namespace proskill::syntax {
namespace {

constexpr std::array kTypeNames = {
    "token",
    "ERROR",
#define NODE(name, type) type,
#include "syntax/tree/node_kinds.def"
#undef NODE
};

NodeKind kindNamed(std::string_view type) {
  for (std::size_t i = 0; i < kTypeNames.size(); ++i)
    if (type == kTypeNames[i]) return static_cast<NodeKind>(i);
  assert(false && "node_kinds.def lacks a node of the grammar");
  return NodeKind::Error;
}

/// By symbol of the grammar.
const std::vector<NodeKind>& kindsOfSymbols() {
  static const auto kKinds = [] {
    const TSLanguage* language = tree_sitter_proskill();
    std::vector<NodeKind> kinds;
    for (std::uint32_t i = 0; i < ts_language_symbol_count(language); ++i) {
      auto symbol = static_cast<TSSymbol>(i);
      bool named = ts_language_symbol_type(language, symbol) == TSSymbolTypeRegular;
      kinds.push_back(named ? kindNamed(ts_language_symbol_name(language, symbol))
                            : NodeKind::Token);
    }
    return kinds;
  }();
  return kKinds;
}

/// Copies a tree-sitter tree in preorder, without recursion.
class Flattening {
public:
  Flattening(std::string_view source, TSNode root)
      : text(source), cursor(ts_tree_cursor_new(root)) {}
  Flattening(const Flattening&) = delete;
  Flattening& operator=(const Flattening&) = delete;
  ~Flattening() { ts_tree_cursor_delete(&cursor); }

  Tree run() {
    enter();
    while (true) {
      if (ts_tree_cursor_goto_first_child(&cursor)) {
        enter();
        continue;
      }
      while (true) {
        leave();
        if (open.empty()) return std::move(tree);
        if (ts_tree_cursor_goto_next_sibling(&cursor)) break;
        ts_tree_cursor_goto_parent(&cursor);
      }
      enter();
    }
  }

private:
  void enter() {
    auto node = ts_tree_cursor_current_node(&cursor);
    Range range{ts_node_start_byte(node), ts_node_end_byte(node)};
    TSSymbol symbol = ts_node_symbol(node);
    NodeKind kind = symbol < kinds.size() ? kinds[symbol] : NodeKind::Error;
    if (kind == NodeKind::Token && isBracketing(range)) {
      open.push_back(std::nullopt);
      return;
    }
    open.push_back(tree.size());
    tree.push_back({kind, 1, range});
  }

  void leave() {
    if (open.back()) {
      auto start = *open.back();
      tree[start].size = static_cast<std::uint32_t>(tree.size() - start);
    }
    open.pop_back();
  }

  [[nodiscard]] bool isBracketing(Range range) const {
    if (range.empty()) return true;
    char c = text[range.begin];
    return range.length() == 1 && (c == '(' || c == ')' || c == '"');
  }

  const std::vector<NodeKind>& kinds = kindsOfSymbols();
  std::string_view text;
  TSTreeCursor cursor;
  Tree tree;
  std::vector<std::optional<std::size_t>> open;
};

/// A tree with a single error. The grammar accepts any text without control characters, so this
/// covers the unforeseen: other code relies on parts that every node has.
Tree unreadable(std::string_view text) {
  Range all{0, static_cast<Offset>(text.size())};
  return {{NodeKind::SourceFile, 2, all}, {NodeKind::Error, 1, all}};
}

struct DeleteTree {
  void operator()(TSTree* tree) const { ts_tree_delete(tree); }
};

} // namespace

std::string_view typeName(NodeKind kind) { return kTypeNames.at(static_cast<std::size_t>(kind)); }

std::string toString(const Tree& tree, Offset shift) {
  std::string out;
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Node& node = tree[i];
    out += fmt::format("{}({} {}-{}", ends.empty() ? "" : " ", typeName(node.kind),
                       node.range.begin + shift, node.range.end + shift);
    ends.push_back(i + node.size);
    while (!ends.empty() && ends.back() == i + 1) {
      out += ')';
      ends.pop_back();
    }
  }
  return out;
}

void Parser::Delete::operator()(TSParser* parser) const { ts_parser_delete(parser); }

Parser::Parser() : parser(ts_parser_new()) {
  [[maybe_unused]] bool fits = ts_parser_set_language(parser.get(), tree_sitter_proskill());
  assert(fits && "the runtime is older than the generated parser");
}

Tree Parser::parse(std::string_view text) {
  std::unique_ptr<TSTree, DeleteTree> tree(ts_parser_parse_string(
      parser.get(), nullptr, text.data(), static_cast<std::uint32_t>(text.size())));
  TSNode root = ts_tree_root_node(tree.get());
  if (ts_node_has_error(root)) return unreadable(text);
  return Flattening(text, root).run();
}

} // namespace proskill::syntax
