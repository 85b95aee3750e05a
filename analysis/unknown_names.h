#pragma once

#include "analysis/index.h"
#include "syntax/suggest.h"

#include <map>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

namespace proskill::analysis {

struct Context;

/// A name that means nothing where it stands.
struct UnknownName {
  syntax::Code code;
  std::string_view text;
  Location at;
  SymbolId owner = kNoSymbol;              ///< of whose names it is none; none: of the program's
  std::vector<SymbolKind> kinds;           ///< what it might be
  bool anywhere = false;                   ///< whoever the owner is
  std::span<const std::string_view> words; ///< of the language, that may stand there
};

/// Collects the names that mean nothing, and tells each mistake once.
///
/// Where a name is near to one that others use, each use is misspelt by itself and has an edit of
/// its own. Else the definition is missing or misspelt: that is one mistake, however often the name
/// is used. It is told at the first use, with the others as related places; where a definition that
/// nobody mentions is near, the edit is there. What a definition or a file would have defined that
/// was not read, which has been told, is no mistake of its own.
class UnknownNames {
public:
  void add(UnknownName name);
  [[nodiscard]] bool empty() const { return uses.empty(); }
  void report(Context& context) const;

private:
  /// The code, the owner and the name.
  using Key = std::tuple<syntax::Code, SymbolId, std::string_view>;

  std::map<Key, std::vector<UnknownName>> uses;
};

} // namespace proskill::analysis
