#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct TSParser;

namespace proskill::syntax {

/// What a node of the concrete tree is; see grammar.js for what stands in each.
enum class NodeKind : std::uint8_t {
  Token, // a word or sign of the grammar itself, such as `defskill`, `:init`, `[`
  Error, // what the grammar cannot take
#define NODE(name, type) name,
#include "syntax/tree/node_kinds.def"
#undef NODE
};

/// The node's type in the grammar; of a token, "token".
[[nodiscard]] std::string_view typeName(NodeKind kind);

/// A node with its descendants behind it: its first child is the next node, its sibling is `size`
/// on.
struct Node {
  NodeKind kind = NodeKind::Token;
  std::uint32_t size = 1; ///< itself and all its descendants
  Range range;

  friend bool operator==(const Node&, const Node&) = default;
};

/// The parts of a node that mean something, comments aside, to be taken one by one.
class Parts {
public:
  explicit Parts(const Node& node) : at(&node + 1), end(&node + node.size) { skipComments(); }

  [[nodiscard]] const Node* peek() const { return at == end ? nullptr : at; }
  /// The next part, null at the end.
  const Node* take() {
    const Node* taken = peek();
    if (taken) {
      at += taken->size;
      skipComments();
    }
    return taken;
  }
  /// The next part where it is of that kind.
  const Node* take(NodeKind kind) { return at != end && at->kind == kind ? take() : nullptr; }

private:
  void skipComments() {
    while (at != end && at->kind == NodeKind::Comment) ++at;
  }

  const Node* at;
  const Node* end;
};

/// A concrete tree in preorder; parentheses and quotes are left out, ranges tell where they are.
using Tree = std::vector<Node>;

/// As tree-sitter prints trees, with the range of each node moved by `shift`.
[[nodiscard]] std::string toString(const Tree& tree, Offset shift);

/// Reads texts with the grammar, one after the other.
class Parser {
public:
  Parser();
  [[nodiscard]] Tree parse(std::string_view text);

private:
  struct Delete {
    void operator()(TSParser* parser) const;
  };
  std::unique_ptr<TSParser, Delete> parser;
};

} // namespace proskill::syntax
