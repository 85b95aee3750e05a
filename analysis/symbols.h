#pragma once

#include "analysis/program.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
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
  explicit SymbolTable(const Program& program);

  [[nodiscard]] const std::vector<Symbol>& all() const { return symbols; }
  [[nodiscard]] const Symbol& operator[](SymbolId id) const { return symbols[id]; }
  [[nodiscard]] SymbolId find(SymbolKind kind, std::string_view name,
                              SymbolId owner = kNoSymbol) const;
  /// All of a kind and an owner, in the order of the program, second ones of a name included.
  [[nodiscard]] std::span<const SymbolId> members(SymbolKind kind, SymbolId owner) const;
  /// All whose owner it is, kind by kind.
  [[nodiscard]] std::span<const SymbolId> parts(SymbolId owner) const;
  /// What may follow `skill.res`: an outcome's tag, or that of an invariant that failed.
  [[nodiscard]] SymbolId findResult(std::string_view tag, SymbolId skill) const;
  /// All labels of a name, whatever the skill that they stand in.
  [[nodiscard]] std::span<const SymbolId> labels(std::string_view name) const;
  /// The symbol of a definition at the top level, second ones of a name included.
  [[nodiscard]] SymbolId topLevel(SymbolKind kind, std::size_t definition) const {
    return definitions[static_cast<std::size_t>(kind)][definition];
  }
  [[nodiscard]] const std::vector<Duplicate>& duplicates() const { return twice; }

private:
  /// The symbols of an owner follow each other, kind by kind.
  struct Parts {
    SymbolId begin = 0;
    SymbolId end = 0;
  };

  SymbolId define(Symbol symbol);
  void sortParts(SymbolId owner);
  void defineInside(SymbolKind kind, const syntax::Name& name, syntax::Range extent,
                    SymbolId owner);
  template <class Node> void defineAll(SymbolKind kind, const Table<Node>& table);
  template <class Node> void defineAllParts(SymbolKind kind, const Table<Node>& table);
  void defineParts(const Definition<syntax::StateVariable>& variable, SymbolId owner);
  void defineParts(const Definition<syntax::Skill>& skill, SymbolId owner);
  void defineParts(const Definition<syntax::Environment>& environment, SymbolId owner);
  void defineLabels(const syntax::Block& block, SymbolId owner);

  static constexpr std::size_t kTopLevelKinds = 6;

  std::vector<Symbol> symbols;
  std::vector<SymbolId> ids; ///< of all symbols, in their order
  std::vector<SymbolId> definitions[kTopLevelKinds];
  std::vector<Parts> ofDefinitions; ///< of each at the top level
  std::unordered_map<std::string_view, SymbolId> names[kTopLevelKinds]; ///< the first of each
  std::vector<SymbolId> byName; ///< the parts of each owner, where `ids` has them, by kind and name
  std::unordered_map<std::string_view, std::vector<SymbolId>> labelsByName;
  std::vector<Duplicate> twice;
};

} // namespace proskill::analysis
