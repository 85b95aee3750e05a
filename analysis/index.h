#pragma once

#include "analysis/symbols.h"

#include <cstdint>
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

  [[nodiscard]] const SymbolTable& symbols() const { return table; }
  /// All of them, by file and place.
  [[nodiscard]] std::span<const Occurrence> occurrences() const { return places; }
  /// What stands at a place, or ends there; null where no name does.
  [[nodiscard]] const Occurrence* at(FileId file, syntax::Offset offset) const;
  /// The places that name a symbol, its definition among them, by file and place.
  [[nodiscard]] std::vector<Occurrence> occurrencesOf(SymbolId symbol) const;

private:
  SymbolTable table;
  std::vector<Occurrence> places;
  std::vector<std::uint32_t> bySymbol;   ///< indices into `places`, grouped by symbol
  std::vector<std::uint32_t> groupStart; ///< of each symbol in `bySymbol`, and the end
};

/// A program's names and all that is wrong with it.
struct Analysis {
  Index index;
  std::vector<syntax::Diagnostic> diagnostics; ///< those of loading included, in the files' order
};
[[nodiscard]] Analysis analyse(const Program& program);

} // namespace proskill::analysis
