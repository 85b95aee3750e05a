#pragma once

#include "analysis/program/program.h"

#include <cstdint>
#include <optional>
#include <ranges>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace proskill::analysis {

enum class SymbolKind : std::uint8_t {
  StateVariable,
  Event,
  Skill,
  Resource,
  Property,
  Environment,
  Constant,
  // Parts of a state variable.
  Value,
  // Parts of a skill; labels also of an environment.
  Parameter,
  PreconditionTag,
  InvariantTag,
  SuccessTag,
  FailureTag,
  Label,
};

/// The name of the kind for users: "state variable", "tag".
[[nodiscard]] std::string_view words(SymbolKind kind);

/// `$height` becomes `height`: a parameter has its `$` where it is used, but not where it is given.
[[nodiscard]] syntax::Name withoutDollar(syntax::Name name);

/// An index into `SymbolTable::all`.
using SymbolId = std::uint32_t;
constexpr SymbolId kNoSymbol = ~SymbolId{0};

/// A named definition of a program.
struct Symbol {
  SymbolKind kind = SymbolKind::Skill;
  std::string_view name;
  Location at;                ///< of the name
  syntax::Range extent;       ///< of the whole definition
  SymbolId owner = kNoSymbol; ///< the state variable of a value, the skill of a tag, and so on
  std::size_t definition = 0; ///< top level: index in the program's table
};

/// A name that its owner already has.
struct Duplicate {
  SymbolId first = kNoSymbol;
  SymbolId second = kNoSymbol;
};

/// All definitions of a program. A name belongs to a kind and an owner: two variables may share the
/// value `Valid`, a skill and an event the name `land`. If a name is defined several times, it
/// refers to the first definition.
class SymbolTable {
public:
  /// Symbols with consecutive ids.
  using Ids = std::ranges::iota_view<SymbolId, SymbolId>;

  explicit SymbolTable(const Program& program);
  /// The table after an edit; faster if definitions have not changed.
  /// \param symbolsBefore the table of `before`
  SymbolTable(const Program& program, const Program& before, const SymbolTable& symbolsBefore);

  [[nodiscard]] const std::vector<Symbol>& all() const { return symbols; }
  [[nodiscard]] const Symbol& operator[](SymbolId id) const { return symbols[id]; }
  [[nodiscard]] SymbolId find(SymbolKind kind, std::string_view name,
                              SymbolId owner = kNoSymbol) const;
  /// All symbols of a kind and an owner, in the order of the program, including duplicates.
  [[nodiscard]] Ids members(SymbolKind kind, SymbolId owner) const;
  /// All symbols of an owner, by kind.
  [[nodiscard]] Ids parts(SymbolId owner) const {
    return owner < ofDefinitions.size() ? ofDefinitions[owner] : Ids();
  }
  /// The tag after `skill.res`: of an outcome, or of an invariant that failed.
  [[nodiscard]] SymbolId findResult(std::string_view tag, SymbolId skill) const;
  /// All labels with a name, in any skill.
  [[nodiscard]] std::span<const SymbolId> labels(std::string_view name) const;
  /// The symbol of a top-level definition, including duplicates.
  [[nodiscard]] SymbolId topLevel(SymbolKind kind, std::size_t definition) const {
    return ofKinds[static_cast<std::size_t>(kind)][static_cast<SymbolId>(definition)];
  }
  [[nodiscard]] const std::vector<Duplicate>& duplicates() const { return twice; }

private:
  /// A definition with parts.
  struct Owner {
    SymbolId id;
    const syntax::Form& form;
  };

  void define(Symbol symbol) { symbols.push_back(symbol); }
  [[nodiscard]] SymbolId next() const { return static_cast<SymbolId>(symbols.size()); }
  void sortParts(SymbolId owner);
  void noteDuplicates(SymbolId owner);
  /// Copies the parts of the same definition from another table.
  void copyParts(const SymbolTable& table, SymbolId ownerThere, Owner owner, syntax::Offset by);
  /// \param name, extent with ranges as parsed
  void defineInside(SymbolKind kind, const syntax::Name& name, syntax::Range extent, Owner owner);
  struct Before {
    const Program& program;
    const SymbolTable& symbols;
  };
  SymbolTable(const Program& program, const std::optional<Before>& before);
  template <class Node> void defineAll(SymbolKind kind, const Table<Node>& table);
  template <class Node>
  void defineAllParts(SymbolKind kind, Table<Node> Program::*table, const Program& program,
                      const std::optional<Before>& before);
  void defineParts(const syntax::StateVariable& variable, Owner owner);
  void defineParts(const syntax::Skill& skill, Owner owner);
  void defineParts(const syntax::Environment&, Owner owner);
  void defineLabels(Owner owner);
  [[nodiscard]] std::pair<SymbolKind, std::string_view> keyOf(SymbolId id) const {
    return {symbols[id].kind, symbols[id].name};
  }
  [[nodiscard]] std::span<const SymbolId> partsByName(SymbolId owner) const;

  static constexpr std::size_t kTopLevelKinds = 7;

  std::vector<Symbol> symbols; ///< the top level by kind, then the parts of each definition
  Ids ofKinds[kTopLevelKinds];
  std::vector<Ids> ofDefinitions; ///< by top-level definition: its parts, by kind
  /// The first symbol of each name.
  std::unordered_map<std::string_view, SymbolId> names[kTopLevelKinds];
  /// The parts of each owner, at their own ids, sorted by kind and name.
  std::vector<SymbolId> byName;
  std::unordered_map<std::string_view, std::vector<SymbolId>> labelsByName;
  std::vector<Duplicate> twice;
};

} // namespace proskill::analysis
