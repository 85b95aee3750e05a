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

/// How an occurrence uses its symbol.
enum class Role : std::uint8_t {
  Definition,
  Read,      ///< reads a state variable or a skill's status
  Write,     ///< sets a state variable
  Call,      ///< calls a skill
  Interrupt, ///< interrupts a skill
  Mention,   ///< any other use: a value, a tag, a label, a resource, an event, a type
};

struct Occurrence {
  SymbolId symbol = kNoSymbol;
  Location at;
  Role role = Role::Mention;
};

/// All definitions of a program and all places that name them. The index refers to the program's
/// texts and is valid as long as they are.
class Index {
public:
  /// \pre `occurrences` are of `symbols`. Definitions are added here.
  Index(SymbolTable symbols, std::vector<Occurrence> occurrences);
  /// Builds the index after an edit from parts of an earlier one.
  /// \param kept in order
  /// \param noted occurrences within the scope; definitions in the scope are added here
  Index(SymbolTable symbols, std::vector<Occurrence> kept, std::vector<Occurrence> noted,
        const Scope& scope);

  [[nodiscard]] const SymbolTable& symbols() const { return table; }
  /// All occurrences, by file and offset.
  [[nodiscard]] std::span<const Occurrence> occurrences() const { return places; }
  /// The occurrences that begin in a region of a file.
  [[nodiscard]] std::span<const Occurrence> occurrences(Location within) const;
  /// The name at an offset, or ending there; null if there is none.
  [[nodiscard]] const Occurrence* at(FileId file, syntax::Offset offset) const;
  /// The occurrences of a symbol, including its definition, by file and offset.
  [[nodiscard]] std::vector<Occurrence> occurrencesOf(SymbolId symbol) const;
  /// Their number.
  [[nodiscard]] std::size_t countOf(SymbolId symbol) const { return group(symbol).size(); }

private:
  /// Computed on demand, because after most edits nobody needs it.
  struct Groups {
    Once made;
    std::vector<std::uint32_t> bySymbol; ///< indices into `places`, grouped by symbol
    std::vector<std::uint32_t> starts;   ///< by symbol: its first index in `bySymbol`; then the end
  };

  [[nodiscard]] std::span<const std::uint32_t> group(SymbolId symbol) const;
  void makeGroups() const;

  SymbolTable table;
  std::vector<Occurrence> places;
  std::unique_ptr<Groups> groups = std::make_unique<Groups>();
};

/// A program's names and diagnostics.
struct Analysis {
  Index index;
  /// Including those of loading, in the order of the files.
  std::vector<syntax::Diagnostic> diagnostics;
  /// The findings of checks that look at one definition at a time, by check; `analyse` reuses them
  /// after an edit.
  std::vector<Found> ofDefinitions{};
};
[[nodiscard]] Analysis analyse(const Program& program);

/// A program before an edit, with its analysis.
struct Earlier {
  const Program& program;
  const Analysis& analysis;
};
/// The same as `analyse(program)`, usually at the cost of the definitions that the edit touched.
[[nodiscard]] Analysis analyse(const Program& program, const Earlier& earlier);

} // namespace proskill::analysis
