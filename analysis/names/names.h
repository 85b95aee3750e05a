#pragma once

#include "analysis/names/call_graph.h"
#include "analysis/names/findings.h"
#include "analysis/names/index.h"
#include "analysis/names/scope.h"
#include "analysis/names/types.h"
#include "analysis/names/walk.h"

#include <vector>

namespace proskill::analysis {

/// What every check sees: the program, its names, and where to put what it finds.
struct Context {
  const Program& program;
  const SymbolTable& symbols;
  const CallGraph& calls;
  Findings& findings;
  std::vector<Occurrence>& occurrences;
  Scope scope{};

  /// Calls `visit(definition)` for those of a table that are to be looked at.
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
  /// Calls `visit(body)` for each body of theirs.
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

/// Finds what names mean, notes it in the index, and says so where they mean nothing. What a name
/// may be depends on where it stands:
///
/// | place | what it is |
/// | --- | --- |
/// | `(NAME value)` in a condition, in effects | a state variable |
/// | a word beside it, in `:init`, in `:transitions` | a value of that one, else a state variable |
/// | `(NAME …)` as a statement, `NAME.status`, `NAME.res`, `NAME.interrupt` | a skill |
/// | a word beside `skill.status`, in `(ended skill NAME)` | a status |
/// | a word beside `skill.res` | a tag of that skill's outcomes or invariants, or `no_result` |
/// | `(success NAME)`, `(failure NAME)` | a tag of the own `:success`, of the own `:failure` |
/// | `NAME value` in a call | an input of the skill that is called |
/// | `$NAME` | an input of the skill that it stands in |
/// | after an input | a basic type or a state variable |
/// | `(goto NAME)`, `(at NAME)` | a label of the same body, of any body |
/// | `(emit NAME)`, `(occurs NAME)` | an event |
/// | in `:resources` | a resource |
class Names {
public:
  Names(Context& context, FileId file) : context(context), file(file) {}

  /// The symbol of that kind and owner; none, with a diagnostic, where there is none. A missing
  /// name is none without a diagnostic: the parser has said so.
  SymbolId use(SymbolKind kind, const syntax::Name& name, Role role, SymbolId owner = kNoSymbol);
  /// The tag of an outcome or of an invariant, after `skill.res`.
  void useResult(const syntax::Name& tag, SymbolId skill);
  /// The word of a status; `found` of those allowed.
  void useStatus(const syntax::Name& word, std::span<const std::string_view> allowed);
  /// The label in any skill, for a property.
  void useLabelAnywhere(const syntax::Name& label);
  /// The type of an input.
  Type useType(const syntax::Name& name);
  /// A parameter, with or without its `$`.
  SymbolId useParameter(const syntax::Name& name, Role role, SymbolId skill);
  /// Says so where a number lies outside of the state variable that `type` is of.
  void checkDomain(const syntax::Expr& number, Type type);
  /// For the index: the symbol is named here.
  void note(SymbolId symbol, const syntax::Name& name, Role role);

private:
  void unknown(SymbolKind kind, const syntax::Name& name, SymbolId owner);

  Context& context;
  FileId file;
};

} // namespace proskill::analysis
