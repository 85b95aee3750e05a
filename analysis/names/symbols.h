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
  // Inside of a state variable.
  Value,
  // Inside of a skill; labels inside of an environment too.
  Parameter,
  PreconditionTag,
  InvariantTag,
  SuccessTag,
  FailureTag,
  Label,
};

/// "state variable", "tag": what a user calls it.
[[nodiscard]] std::string_view words(SymbolKind kind);

/// `$height` as `height`: a parameter has its `$` where it is used, and none where it is given.
[[nodiscard]] syntax::Name withoutDollar(syntax::Name name);

/// An index into `SymbolTable::all`.
using SymbolId = std::uint32_t;
constexpr SymbolId kNoSymbol = ~SymbolId{0};

/// Something that a program defines and that has a name.
struct Symbol {
  SymbolKind kind = SymbolKind::Skill;
  std::string_view name;
  Location at;                ///< of the name
  syntax::Range extent;       ///< of the whole definition
  SymbolId owner = kNoSymbol; ///< the state variable of a value, the skill of a tag
  std::size_t definition = 0; ///< top level: its index in the program's table
};

/// A name that its owner has already.
struct Duplicate {
  SymbolId first = kNoSymbol;
  SymbolId second = kNoSymbol;
};

/// Every definition of a program. A name belongs to a kind and an owner: two variables may share
/// the value `Valid`, a skill and an event the name `land`. The first definition of a name has it.
class SymbolTable {
public:
  /// Those that follow each other.
  using Ids = std::ranges::iota_view<SymbolId, SymbolId>;

  explicit SymbolTable(const Program& program);
  /// The same after an edit, sooner where definitions are as they were.
  /// \param symbolsBefore  of `before`
  SymbolTable(const Program& program, const Program& before, const SymbolTable& symbolsBefore);

  [[nodiscard]] const std::vector<Symbol>& all() const { return symbols; }
  [[nodiscard]] const Symbol& operator[](SymbolId id) const { return symbols[id]; }
  [[nodiscard]] SymbolId find(SymbolKind kind, std::string_view name,
                              SymbolId owner = kNoSymbol) const;
  /// All of a kind and an owner, in the order of the program, second ones of a name included.
  [[nodiscard]] Ids members(SymbolKind kind, SymbolId owner) const;
  /// All whose owner it is, kind by kind.
  [[nodiscard]] Ids parts(SymbolId owner) const {
    return owner < ofDefinitions.size() ? ofDefinitions[owner] : Ids();
  }
  /// What may follow `skill.res`: an outcome's tag, or that of an invariant that failed.
  [[nodiscard]] SymbolId findResult(std::string_view tag, SymbolId skill) const;
  /// All labels of a name, whatever the skill that they stand in.
  [[nodiscard]] std::span<const SymbolId> labels(std::string_view name) const;
  /// The symbol of a definition at the top level, second ones of a name included.
  [[nodiscard]] SymbolId topLevel(SymbolKind kind, std::size_t definition) const {
    return ofKinds[static_cast<std::size_t>(kind)][static_cast<SymbolId>(definition)];
  }
  [[nodiscard]] const std::vector<Duplicate>& duplicates() const { return twice; }

private:
  /// What has parts, by its form.
  struct Owner {
    SymbolId id;
    const syntax::Form& form;
  };

  void define(Symbol symbol) { symbols.push_back(symbol); }
  [[nodiscard]] SymbolId next() const { return static_cast<SymbolId>(symbols.size()); }
  void sortParts(SymbolId owner);
  void noteDuplicates(SymbolId owner);
  /// Those that another table has of the same form.
  void copyParts(const SymbolTable& table, SymbolId ownerThere, Owner owner, syntax::Offset by);
  /// \param name, extent  as they were read
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

  static constexpr std::size_t kTopLevelKinds = 6;

  std::vector<Symbol> symbols; ///< the top level, kind by kind, then the parts of each of it
  Ids ofKinds[kTopLevelKinds];
  std::vector<Ids> ofDefinitions; ///< the parts of each at the top level, kind by kind
  std::unordered_map<std::string_view, SymbolId> names[kTopLevelKinds]; ///< the first of each
  std::vector<SymbolId> byName; ///< the parts of each owner, at their own ids, by kind and name
  std::unordered_map<std::string_view, std::vector<SymbolId>> labelsByName;
  std::vector<Duplicate> twice;
};

} // namespace proskill::analysis
