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
  std::string detail;  ///< one line; empty where the label says all
  std::string insert;  ///< what is written, plain
  std::string snippet; ///< the same with places to fill in, in LSP's syntax; empty: there are none
  std::string filter;  ///< what the typed word is compared with
  unsigned rank = 0;   ///< less is better
  bool isDeprecated = false;
  std::optional<SymbolKey> symbol;
  const Word* word = nullptr; ///< of the language
};

struct Completions {
  std::vector<Completion> items; ///< best first
  syntax::Range insert;          ///< the word up to the cursor
  syntax::Range replace;         ///< the whole word that the cursor stands in
  bool isComplete = true;        ///< nothing was left out that further typing could bring in
};

/// What asked for completions.
struct CompletionTrigger {
  /// A character that was typed; else a person asked. After a space nothing is offered where nearly
  /// everything could stand.
  std::optional<char> typed;
};

/// What can be written at a place, told from what stands before it. Nothing in comments, in
/// strings that are no paths, and where a new name is due.
[[nodiscard]] Completions complete(const Snapshot& snapshot, const View& view, syntax::Offset at,
                                   CompletionTrigger trigger = {});

/// What is told of an item when it is looked at; empty where there is nothing.
[[nodiscard]] Markup documentation(const View& view, const Completion& item);

} // namespace proskill::ide
