#pragma once

#include "ide/description/markup.h"
#include "ide/names/place.h"
#include "ide/snapshot/symbol_key.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace proskill::ide {

enum class CompletionKind : std::uint8_t {
  Keyword,
  Field,
  Statement,
  Operator,
  Variable,
  Value,
  Parameter,
  Skill,
  Event,
  Resource,
  Tag,
  Label,
  Type,
  File,
};

struct Completion {
  std::string label;
  CompletionKind kind = CompletionKind::Keyword;
  std::string detail;  ///< one line; empty if the label says everything
  std::string insert;  ///< the inserted text
  std::string snippet; ///< the same with placeholders, in LSP's syntax; empty: none
  std::string filter;  ///< the text with which the typed word is compared
  unsigned rank = 0;   ///< smaller is better
  bool isDeprecated = false;
  std::optional<SymbolKey> symbol;
  const Word* word = nullptr; ///< for a word of the language
};

struct Completions {
  std::vector<Completion> items; ///< best first
  syntax::Range insert;          ///< the word up to the cursor
  syntax::Range replace;         ///< the whole word at the cursor
  bool isComplete = true;        ///< further typing cannot add completions
};

/// The reason why completions are requested.
struct CompletionTrigger {
  /// The typed character; nothing if the user requested completions. After a space there are no
  /// completions if nearly everything is allowed.
  std::optional<char> typed;
};

/// The completions at a place, computed from the text before it. None in comments, in strings that
/// are not paths, and where a new name is expected.
[[nodiscard]] Completions complete(const Snapshot& snapshot, const View& view, syntax::Offset at,
                                   CompletionTrigger trigger = {});

/// The documentation of an item; empty if there is none.
[[nodiscard]] Markup documentation(const View& view, const Completion& item);

} // namespace proskill::ide
