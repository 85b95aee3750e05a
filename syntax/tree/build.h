#pragma once

#include "syntax/diagnostics/codes.h"
#include "syntax/text/quote.h"
#include "syntax/tree/ast.h"
#include "syntax/tree/tree.h"

/// From the concrete tree of a region of text to its typed tree, and what is wrong with its shape.
/// What the grammar cannot read at all (a bad name, a stray character) is reported by words.h,
/// once; everything here is silent about such nodes.
namespace proskill::syntax {

/// The text at hand and where to report. Ranges are those of the text.
struct Builder {
  std::string_view text;
  std::vector<Diagnostic>& diagnostics;

  [[nodiscard]] std::string_view textOf(Range range) const {
    return text.substr(range.begin, range.length());
  }
  [[nodiscard]] std::string_view textOf(const Node& node) const { return textOf(node.range); }
  /// For what is put together with other words; as an argument of `report` a text needs nothing.
  [[nodiscard]] std::string quoted(const Node& node) const { return shortened(textOf(node)); }
  [[nodiscard]] Name nameOf(const Node& node) const { return {textOf(node), node.range}; }

  template <class... Arguments>
  Diagnostic& report(CodeFor<sizeof...(Arguments)> code, Range range,
                     const Arguments&... arguments) {
    diagnostics.push_back(makeDiagnostic(code, {0, range}, arguments...));
    return diagnostics.back();
  }

  /// Reports all that is left of `parts` as one thing too many after `what`.
  void reportSurplus(Parts& parts, std::string_view what);
};

/// Whether the node is reported already, as what it is.
[[nodiscard]] bool isDamaged(const Node& node);
/// Whether it serves as a name, well-formed or not.
[[nodiscard]] bool isWord(const Node& node);

/// Whether the node is a keyword with its values.
[[nodiscard]] inline bool isField(const Node& node) {
  return node.kind >= NodeKind::UnknownField && node.kind <= NodeKind::LastingField;
}

/// A keyword with its values.
struct Field {
  NodeKind kind;
  FieldUse use;
  Parts values;
};
[[nodiscard]] Field fieldOf(const Builder& builder, const Node& node);
/// The only value of a field, which `needs` something; null, and reported, where there is none.
const Node* onlyValue(Builder& builder, Field& field, std::string_view needs);
void reportMalformed(Builder& builder, const Field& field, const Node& value,
                     std::string_view needs);

/// The keywords of the fields that something has.
using Keywords = std::vector<std::string_view>;
void reportUnknownField(Builder& builder, const Field& field, std::string_view owner,
                        const Keywords& known);

/// The name that comes next; where there is none, an empty one after `head`, reported.
Name takeName(Builder& builder, Parts& parts, const Name& head);
/// The names of a list in parentheses; what is no name is reported.
List<Name> namesOf(Builder& builder, const Node& list);

/// Words that stand for themselves: numbers, strings, intervals.
Rational numberOf(const Builder& builder, const Node& number);
/// A string without its quotes.
Name contentOf(const Builder& builder, const Node& string);
/// The interval that comes next, a node of that kind; nothing, and reported, where it is malformed.
std::optional<Interval> takeInterval(Builder& builder, Parts& parts);
/// The interval that a field has and nothing else; nothing, and reported, where it has none.
std::optional<Interval> intervalOf(Builder& builder, Field& field);

/// Formulas may be temporal; conditions and propositions may not.
enum class Context : std::uint8_t { Condition, Proposition, Formula };
Expr expressionOf(Builder& builder, const Node& node, Context context = Context::Condition);
/// The condition that comes next; Missing, and reported, where there is none.
Expr takeCondition(Builder& builder, Parts& parts, const Name& head);
/// All that is left, which is to be effects; none, and reported, where nothing is.
Effects takeEffects(Builder& builder, Parts& parts, const Name& head);

Block blockOf(Builder& builder, const Node& list);
/// The statements that come next, up to a clause of the statement around them; `at` where none
/// does.
Block takeBlock(Builder& builder, Parts& parts, Offset at);
void readCase(Builder& builder, Parts& parts, Statement& statement);
Statement statementOf(Builder& builder, const Node& node);

void readSkill(Builder& builder, std::vector<Field>& fields, Skill& skill);
Property propertyOf(Builder& builder, const Node& node);

/// The forms of a whole text, without their comments.
std::vector<ReadForm> formsOf(Builder& builder, const Tree& tree);

} // namespace proskill::syntax
