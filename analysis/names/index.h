#pragma once

#include "analysis/names/findings.h"
#include "analysis/names/scope.h"
#include "analysis/names/symbols.h"
#include "analysis/program/once.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace proskill::analysis {

/// What a place in the text does with the symbol that it names.
enum class Role : std::uint8_t {
  Definition,
  Read,      ///< a state variable or a skill's status is looked at
  Write,     ///< a state variable is set
  Call,      ///< a skill is called
  Interrupt, ///< a skill is interrupted
  Mention,   ///< all else: a value, a tag, a label, a resource, an event, a type
};

struct Occurrence {
  SymbolId symbol = kNoSymbol;
  Location at;
  Role role = Role::Mention;
};

/// Every definition of a program and every place that names it. It looks into the program's texts
/// and is valid as long as these.
class Index {
public:
  /// \pre `occurrences` are of `symbols`; definitions are added here.
  Index(SymbolTable symbols, std::vector<Occurrence> occurrences);
  /// After an edit: with what is kept of an earlier one.
  /// \param kept     in their order
  /// \param noted    in the scope, which definitions are added to here
  Index(SymbolTable symbols, std::vector<Occurrence> kept, std::vector<Occurrence> noted,
        const Scope& scope);

  [[nodiscard]] const SymbolTable& symbols() const { return table; }
  /// All of them, by file and place.
  [[nodiscard]] std::span<const Occurrence> occurrences() const { return places; }
  /// Those that begin in a region of a file.
  [[nodiscard]] std::span<const Occurrence> occurrences(Location within) const;
  /// What stands at a place, or ends there; null where no name does.
  [[nodiscard]] const Occurrence* at(FileId file, syntax::Offset offset) const;
  /// The places that name a symbol, its definition among them, by file and place.
  [[nodiscard]] std::vector<Occurrence> occurrencesOf(SymbolId symbol) const;
  /// How many these are.
  [[nodiscard]] std::size_t countOf(SymbolId symbol) const { return group(symbol).size(); }

private:
  /// Made when somebody first asks: after most edits nobody does.
  struct Groups {
    Once made;
    std::vector<std::uint32_t> bySymbol; ///< indices into `places`, grouped by symbol
    std::vector<std::uint32_t> starts;   ///< of each symbol in `bySymbol`, and the end
  };

  [[nodiscard]] std::span<const std::uint32_t> group(SymbolId symbol) const;
  void makeGroups() const;

  SymbolTable table;
  std::vector<Occurrence> places;
  std::unique_ptr<Groups> groups = std::make_unique<Groups>();
};

/// A program's names and all that is wrong with it.
struct Analysis {
  Index index;
  std::vector<syntax::Diagnostic> diagnostics; ///< those of loading included, in the files' order
  /// What was found by looking at one definition after the other, a check each: what `analyse`
  /// takes over after an edit.
  std::vector<Found> ofDefinitions{};
};
[[nodiscard]] Analysis analyse(const Program& program);

/// A program before an edit.
struct Earlier {
  const Program& program;
  const Analysis& analysis;
};
/// Gives what `analyse(program)` gives, mostly at the cost of the definitions that the edit
/// touched.
[[nodiscard]] Analysis analyse(const Program& program, const Earlier& earlier);

} // namespace proskill::analysis
