#pragma once

#include "ide/completion/completion.h"

#include <set>
#include <span>

namespace proskill::ide {

/// The type of inputs that are conditions.
constexpr std::string_view kTruthValue = "bool";

/// Collects the completions at a place, best first. Only `complete` uses it.
class Completer {
public:
  Completer(const Snapshot& snapshot, const View& view, const Path& path, const Place& place);

  /// \pre the place is not in a comment
  [[nodiscard]] std::vector<Completion> gather() &&;

private:
  using SymbolId = analysis::SymbolId;
  using SymbolKind = analysis::SymbolKind;

  void fill();
  void fillNames();

  /// Adds a completion with only a label. The reference is valid until the next call.
  Completion& add(std::string label, CompletionKind kind);

  // Adds a word of the language.
  void word(const Word& word);
  void words(WordKind kind);
  /// Adds a form. \param isList whether it is a list, which gets parentheses unless they exist
  void form(const Word& word, bool isList);
  void forms(WordKind kind, bool areLists = true);
  void fields(WordKind kind);
  void skeleton(std::string_view label, std::string_view insert, std::string_view snippet);
  void conditions();
  void statements();

  // Adds a name.
  Completion& name(SymbolId symbol, CompletionKind kind);
  void members(SymbolKind kind, SymbolId owner, CompletionKind as);
  void values(std::string_view variable);
  void test(SymbolId variable);
  void variables(bool numbersOnly);
  void operands();
  void truthValues();
  void numbers();
  void constants();
  void results(std::string_view skill);
  void accesses();
  void access();
  [[nodiscard]] std::string argument(const syntax::Input& input, unsigned number) const;
  void call(SymbolId skill);
  void calls();
  void caseTags();
  void interrupts();
  void argumentNames();
  void argumentValues();
  void parameters();
  void parameter(SymbolId symbol);
  void inputs(std::string_view type);
  [[nodiscard]] std::string_view typeOf(std::string_view operand) const;
  void command();
  void anyLabels();
  void types();
  void resources();
  void files();
  void addFile(const std::filesystem::path& relative);
  void platformFiles();

  [[nodiscard]] SymbolId find(SymbolKind kind, std::string_view name) const;
  /// The skill or environment that contains the place.
  [[nodiscard]] SymbolId owner() const;
  [[nodiscard]] const syntax::Skill& skill(SymbolId symbol) const;
  [[nodiscard]] const syntax::StateVariable& variable(SymbolId symbol) const;
  [[nodiscard]] bool isInList(std::string_view word) const;
  [[nodiscard]] bool inEnvironment() const { return place.definition == "defenvironment"; }

  const Snapshot& snapshot;
  const View& view;
  const Path& path;
  const Place& place;
  const analysis::SymbolTable& symbols;
  std::set<SymbolId> deprecated;
  std::vector<Completion> items;
  unsigned rank = 0; ///< of the completions added next
};

} // namespace proskill::ide
