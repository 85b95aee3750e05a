#pragma once

#include "syntax/diagnostics/codes.h"
#include "syntax/text/quote.h"
#include "syntax/tree/ast.h"
#include "syntax/tree/tree.h"

/// Translation of a region's concrete tree to its typed tree, with diagnostics about its structure.
/// words.h reports what the grammar cannot parse at all (a bad name, a stray character); the
/// functions here do not report such nodes again.
namespace proskill::syntax {

/// The text being translated, and where diagnostics go. Ranges are those of the text.
struct Builder {
  std::string_view text;
  std::vector<Diagnostic>& diagnostics;

  [[nodiscard]] std::string_view textOf(Range range) const {
    return text.substr(range.begin, range.length());
  }
  [[nodiscard]] std::string_view textOf(const Node& node) const { return textOf(node.range); }
  /// The text of a node for use within another text. As an argument of `report`, a text needs no
  /// shortening.
  [[nodiscard]] std::string quoted(const Node& node) const { return shortened(textOf(node)); }
  [[nodiscard]] Name nameOf(const Node& node) const { return {textOf(node), node.range}; }

  template <class... Arguments>
  Diagnostic& report(CodeFor<sizeof...(Arguments)> code, Range range,
                     const Arguments&... arguments) {
    diagnostics.push_back(makeDiagnostic(code, {0, range}, arguments...));
    return diagnostics.back();
  }

  /// Reports the remaining `parts` as one surplus after `what`.
  void reportSurplus(Parts& parts, std::string_view what);
};

/// Whether the node itself has been reported already.
[[nodiscard]] bool isDamaged(const Node& node);
/// Whether the node can be a name, well-formed or not.
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
/// The only value of a field. `needs` describes it. Null, with a diagnostic, if there is none.
const Node* onlyValue(Builder& builder, Field& field, std::string_view needs);
void reportMalformed(Builder& builder, const Field& field, const Node& value,
                     std::string_view needs);

/// The keywords that something has.
using Keywords = std::vector<std::string_view>;
void reportUnknownField(Builder& builder, const Field& field, std::string_view owner,
                        const Keywords& known);

/// The next name. If there is none, reports this and returns an empty name after `head`.
Name takeName(Builder& builder, Parts& parts, const Name& head);
/// The names of a list in parentheses; anything else is reported.
List<Name> namesOf(Builder& builder, const Node& list);

/// Literals: numbers, strings, intervals.
Rational numberOf(const Builder& builder, const Node& number);
/// A string without its quotes.
Name contentOf(const Builder& builder, const Node& string);
/// The next node, an interval. Nothing, with a diagnostic, if it is malformed.
std::optional<Interval> takeInterval(Builder& builder, Parts& parts);
/// The interval that is the only value of a field. Nothing, with a diagnostic, otherwise.
std::optional<Interval> intervalOf(Builder& builder, Field& field);

/// Temporal operators are allowed in formulas, not in conditions and propositions.
enum class Context : std::uint8_t { Condition, Proposition, Formula };
Expr expressionOf(Builder& builder, const Node& node, Context context = Context::Condition);
/// The condition that is the only value of a field. Missing, with a diagnostic, otherwise.
Expr conditionOf(Builder& builder, Field& field);
/// The next condition. Missing, with a diagnostic, if there is none.
Expr takeCondition(Builder& builder, Parts& parts, const Name& head);
/// All remaining parts as effects. None, with a diagnostic, if nothing remains.
Effects takeEffects(Builder& builder, Parts& parts, const Name& head);

Block blockOf(Builder& builder, const Node& list);
/// The next statements, up to a clause of the enclosing statement. Empty at `at` if there are none.
Block takeBlock(Builder& builder, Parts& parts, Offset at);
void readCase(Builder& builder, Parts& parts, Statement& statement);
Statement statementOf(Builder& builder, const Node& node);

List<Precondition> preconditionsOf(Builder& builder, const Node& list);
List<Invariant> invariantsOf(Builder& builder, const Node& list);
/// The value of `:success` or `:failure`.
List<Outcome> outcomesOf(Builder& builder, Field& field);
std::optional<Interrupt> interruptOf(Builder& builder, Field& field);
void readSkill(Builder& builder, std::vector<Field>& fields, Skill& skill);
Property propertyOf(Builder& builder, const Node& node);

/// The forms of a whole text, without their comments.
std::vector<ReadForm> formsOf(Builder& builder, const Tree& tree);

} // namespace proskill::syntax
