#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct TSParser;

namespace proskill::syntax {

/// The kind of a node of the concrete tree; see grammar.js for the content of each.
enum class NodeKind : std::uint8_t {
  Token, // a word or sign of the grammar itself, such as `defskill`, `:init`, `[`
  Error, // something that the grammar does not accept
#define NODE(name, type) name,
#include "syntax/tree/node_kinds.def"
#undef NODE
};

/// The node's type in the grammar; "token" for tokens.
[[nodiscard]] std::string_view typeName(NodeKind kind);

/// A node, followed by its descendants: its first child is the next node, and its sibling follows
/// `size` nodes later.
struct Node {
  NodeKind kind = NodeKind::Token;
  std::uint32_t size = 1; ///< itself and all its descendants
  Range range;

  friend bool operator==(const Node&, const Node&) = default;
};

/// Iterates over the parts of a node except comments.
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
  /// The next part if it is of this kind, otherwise null.
  const Node* take(NodeKind kind) { return at != end && at->kind == kind ? take() : nullptr; }

private:
  void skipComments() {
    while (at != end && at->kind == NodeKind::Comment) ++at;
  }

  const Node* at;
  const Node* end;
};

/// A concrete tree in preorder, without parentheses and quotes; ranges include them.
using Tree = std::vector<Node>;

/// The tree as tree-sitter prints it, with all ranges moved by `shift`.
[[nodiscard]] std::string toString(const Tree& tree, Offset shift);

/// Parses texts with the grammar, one after the other.
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
