#pragma once

#include "syntax/tree/ast.h"

#include <cstddef>
#include <memory>
#include <type_traits>

namespace proskill::syntax {

/// The content of a form with absolute ranges, computed on demand.
class PlacedNode;

/// A form of a document at the top level. An edit moves everything after it, and the next edit
/// often comes before these forms are read. So the content of a form is moved only on first access.
/// Access is thread-safe.
class Form {
public:
  /// The form at the place where it was parsed.
  explicit Form(std::shared_ptr<const ReadForm> form);
  /// The form `further` bytes towards the end of the text; `further` may wrap around.
  [[nodiscard]] Form moved(Offset further) const;

  Range range;  ///< from its opening to its closing parenthesis
  Name keyword; ///< `defskill`, …
  Name name;    ///< of what it defines; empty if it has none
  /// A parenthesis or quote was inserted or removed, so the form is a guess.
  bool recovered = false;
  Range comment; ///< the comment lines directly above; empty if there are none

  template <class Node> [[nodiscard]] bool is() const { return kind == kindOf<Node>(); }
  [[nodiscard]] bool isAs(const Form& other) const { return kind == other.kind; }
  /// The content if the form is of this kind, otherwise null.
  template <class Node> [[nodiscard]] const Node* as() const {
    return is<Node>() ? &std::get<Node>(node()) : nullptr;
  }
  [[nodiscard]] const FormNode& node() const;

  /// The same without moved ranges, for reading all forms after each edit: add `offset()` to its
  /// ranges; the sum may wrap around.
  template <class Node> [[nodiscard]] const Node* asRead() const {
    return is<Node>() ? &std::get<Node>(nodeAsRead()) : nullptr;
  }
  [[nodiscard]] const FormNode& nodeAsRead() const { return read->node; }
  [[nodiscard]] const BodyIndex& bodyIndexAsRead() const { return read->bodyIndex; }
  [[nodiscard]] const LastFilled& lastFilled() const { return read->lastFilled; }
  [[nodiscard]] Offset offset() const { return by; }
  /// Whether both come from the same parse, possibly moved by edits elsewhere.
  [[nodiscard]] bool isSameRead(const Form& other) const { return read == other.read; }

private:
  template <class Node> static constexpr std::size_t kindOf() {
    return []<class... Nodes>(std::type_identity<std::variant<Nodes...>>) {
      std::size_t index = 0;
      (void)((!std::is_same_v<Node, Nodes> && ++index) && ...);
      return index;
    }(std::type_identity<FormNode>());
  }

  std::uint8_t kind = 0;
  Offset by = 0;                            ///< distance from where it was parsed; may wrap around
  const ReadForm* read;                     ///< owned by `placed`
  std::shared_ptr<const PlacedNode> placed; ///< shared by forms at the same place
};

/// \pre the node stays where it is as long as the index is used
[[nodiscard]] BodyIndex bodyIndexOf(const FormNode& node);

} // namespace proskill::syntax
