#pragma once

#include "syntax/tree/ast.h"

#include <cstddef>
#include <memory>
#include <type_traits>

namespace proskill::syntax {

/// What a form says, where it was read and, once somebody has asked, where it stands now.
class PlacedNode;

/// A form of a document at the top level. An edit moves whatever stands behind it, and the next one
/// comes before much of that was looked at: so what stands inside of a form is moved when somebody
/// first looks. Any thread may look.
class Form {
public:
  /// Where it was read.
  explicit Form(std::shared_ptr<const ReadForm> form);
  /// The same so many bytes further towards the end of the text; may wrap around.
  [[nodiscard]] Form moved(Offset further) const;

  Range range;            ///< from its parenthesis to its parenthesis
  Name keyword;           ///< `defskill`, …
  Name name;              ///< of what it defines; empty where it has none
  bool recovered = false; ///< a parenthesis or quote was put in or left out: a guess
  Range comment;          ///< the lines of comment directly above, empty where there are none

  template <class Node> [[nodiscard]] bool is() const { return kind == kindOf<Node>(); }
  [[nodiscard]] bool isAs(const Form& other) const { return kind == other.kind; }
  /// What it says where it is such a form, else null.
  template <class Node> [[nodiscard]] const Node* as() const {
    return is<Node>() ? &std::get<Node>(node()) : nullptr;
  }
  [[nodiscard]] const FormNode& node() const;

  /// The same for who asks all forms after each edit: its words are right, its ranges want
  /// `offset()` more, which may wrap around.
  template <class Node> [[nodiscard]] const Node* asRead() const {
    return is<Node>() ? &std::get<Node>(nodeAsRead()) : nullptr;
  }
  [[nodiscard]] const FormNode& nodeAsRead() const { return read->node; }
  [[nodiscard]] const BodyIndex& bodyIndexAsRead() const { return read->bodyIndex; }
  [[nodiscard]] Offset offset() const { return by; }
  /// Whether both were read once, and stand where they do by edits elsewhere.
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
  Offset by = 0;                            ///< from where it was read; may wrap around
  const ReadForm* read;                     ///< kept alive by the next
  std::shared_ptr<const PlacedNode> placed; ///< forms that stand at one place share it
};

} // namespace proskill::syntax
