#pragma once

#include "analysis/names/call_graph.h"
#include "analysis/names/findings.h"
#include "analysis/names/index.h"
#include "analysis/names/scope.h"
#include "analysis/names/types.h"
#include "analysis/names/walk.h"

#include <vector>

namespace proskill::analysis {

/// The input of all checks: the program, its names, and where to report findings.
struct Context {
  const Program& program;
  const SymbolTable& symbols;
  const CallGraph& calls;
  Findings& findings;
  std::vector<Occurrence>& occurrences;
  Scope scope{};

  /// Calls `visit(definition)` for the definitions of a table that are in the scope.
  template <class Node, class Visit> void each(const Table<Node>& table, Visit&& visit) const {
    for (const Definition<Node>& it : table.all)
      if (scope.holds(it.file, it.form->range.begin)) visit(it);
  }
  /// The same with the definition's symbol: `visit(definition, symbol)`.
  template <class Node, class Visit>
  void each(SymbolKind kind, const Table<Node>& table, Visit&& visit) const {
    for (std::size_t i = 0; i < table.all.size(); ++i)
      if (scope.holds(table.all[i].file, table.all[i].form->range.begin))
        visit(table.all[i], symbols.topLevel(kind, i));
  }
  /// Calls `visit(body)` for each body of these.
  template <class Visit> void eachBody(Visit&& visit) const {
    each(SymbolKind::Skill, program.skills, [&](const auto& skill, SymbolId symbol) {
      if (skill->body) visit(Body{*skill->body, skill.file, symbol});
    });
    each(SymbolKind::Environment, program.environments, [&](const auto& it, SymbolId symbol) {
      visit(Body{it->body, it.file, symbol});
    });
  }

  [[nodiscard]] const std::string& text(FileId file) const {
    return program.files[file].document.text();
  }
  [[nodiscard]] Type typeOfVariable(SymbolId variable) const {
    return analysis::typeOfVariable(program, symbols, variable);
  }
};

/// The words that begin statements.
[[nodiscard]] std::span<const std::string_view> statementWords();

/// Resolves names, records them in the index, and reports unknown names. The meaning of a name
/// depends on its place:
///
/// | place | meaning |
/// | --- | --- |
/// | `(NAME value)` in a condition, in effects | a state variable |
/// | a word next to it, in `:init`, in `:transitions` | one of its values, otherwise a state
/// variable | | `(NAME …)` as a statement, `NAME.status`, `NAME.res`, `NAME.interrupt` | a skill |
/// | a word next to `skill.status`, in `(ended skill NAME)` | a status |
/// | a word next to `skill.res` | a tag of that skill's outcomes or invariants, or `no_result` |
/// | `(success NAME)`, `(failure NAME)` | a tag of the skill's own `:success` or `:failure` |
/// | `NAME value` in a call | an input of the called skill |
/// | `$NAME` | an input of the enclosing skill |
/// | after an input | a basic type or a state variable |
/// | `(goto NAME)`, `(at NAME)` | a label of the same body, of any body |
/// | `(emit NAME)`, `(occurs NAME)` | an event |
/// | in `:resources` | a resource |
/// | where a number may be | a constant; the program has its number already |
class Names {
public:
  Names(Context& context, FileId file) : context(context), file(file) {}

  /// The symbol of this kind and owner; kNoSymbol, with a diagnostic, if it does not exist. A
  /// missing name gives kNoSymbol without a diagnostic, because the parser has reported it.
  SymbolId use(SymbolKind kind, const syntax::Name& name, Role role, SymbolId owner = kNoSymbol);
  /// Resolves the state variable that a word of a comparison or a sum is; it may have been meant as
  /// a constant. The words that are constants have their numbers already.
  SymbolId useOperand(const syntax::Name& name);
  /// Resolves the tag of an outcome or an invariant, after `skill.res`.
  void useResult(const syntax::Name& tag, SymbolId skill);
  /// Resolves the word of a status, one of `allowed`.
  void useStatus(const syntax::Name& word, std::span<const std::string_view> allowed);
  /// Resolves a label of any skill, for a property.
  void useLabelAnywhere(const syntax::Name& label);
  /// Resolves the type of an input.
  Type useType(const syntax::Name& name);
  /// Resolves a parameter, with or without its `$`.
  SymbolId useParameter(const syntax::Name& name, Role role, SymbolId skill);
  /// Reports a number outside of the state variable's range, if `type` belongs to one.
  void checkDomain(const syntax::Expr& number, Type type);
  /// Records in the index that this name refers to the symbol.
  void note(SymbolId symbol, const syntax::Name& name, Role role);

private:
  void unknown(SymbolKind kind, const syntax::Name& name, SymbolId owner);

  Context& context;
  FileId file;
};

} // namespace proskill::analysis
