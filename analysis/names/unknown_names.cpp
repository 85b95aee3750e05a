#include "analysis/names/unknown_names.h"

#include "syntax/diagnostics/codes.h"
#include "syntax/diagnostics/suggest.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace proskill::analysis {

namespace {

using syntax::Code;
using syntax::Diagnostic;

constexpr std::size_t kMostRelated = 10;

/// Limit of comparisons for suggestions. Thousands of unknown names, as with a missing library, are
/// not spelling errors.
constexpr std::size_t kMostComparisons = 2'000'000;

/// Errors because of which some definitions are unknown.
bool hidesDefinitions(Code code) {
  return code == Code::UnreadableFile || code == Code::TextTooLong || code == Code::FormTooLarge ||
         code == Code::NestedTooDeep || code == Code::MissingPath;
}

/// Errors because of which parts of a definition are unknown.
bool hidesParts(Code code) {
  return code == Code::UnknownField || code == Code::MalformedValue ||
         code == Code::MalformedName || code == Code::MalformedOutcome ||
         code == Code::MissingValue || code == Code::MissingTag;
}

/// A candidate for a suggestion.
struct Near {
  std::string_view word;
  SymbolId symbol = kNoSymbol; ///< none: a keyword
};

class Reporter {
public:
  Reporter(const Program& program, const Index& index, Findings& findings)
      : program(program),
        symbols(index.symbols()),
        findings(findings),
        mentioned(symbols.all().size()) {
    for (const Occurrence& it : index.occurrences())
      if (it.role != Role::Definition) mentioned[it.symbol] = true;
    for (SymbolId id = 0; id < symbols.all().size(); ++id)
      if (symbols[id].name.empty()) unnamed.push_back(id);
    for (const Diagnostic& it : program.diagnostics) {
      definitionsHidden |= hidesDefinitions(it.code);
      if (hidesParts(it.code)) hidden.push_back(it.location);
    }
    for (const File& file : program.files)
      for (const syntax::Form& form : file.document.forms())
        if (form.is<syntax::UnknownForm>()) unreadNames.insert(form.name.text);
  }

  void report(const std::vector<UnknownName>& uses) {
    const Near near = nearest(uses.front(), false);
    if (near.word.empty() && isConsequence(uses.front())) return;
    if (uses.size() > 1) {
      const Near definition = nearest(uses.front(), true);
      if (definition.symbol != kNoSymbol && !isNearer(near, definition, uses.front()))
        return reportDefinition(uses, definition.symbol);
      if (near.word.empty()) return reportMissing(uses);
    }
    for (const UnknownName& use : uses) reportUse(use).suggest(near.word);
  }

private:
  Finding reportUse(const UnknownName& use) {
    const bool global = use.owner == kNoSymbol;
    Finding finding = findings.report(use.code, use.at, use.text,
                                      global ? std::string_view() : symbols[use.owner].name);
    if (global && isFragment()) finding.severity(syntax::Severity::Hint);
    return finding;
  }

  void reportMissing(const std::vector<UnknownName>& uses) {
    Finding finding = reportUse(uses.front());
    addUses(finding, uses);
  }

  void reportDefinition(const std::vector<UnknownName>& uses, SymbolId definition) {
    const Symbol& symbol = symbols[definition];
    Finding finding = reportUse(uses.front());
    finding.related(symbol.at,
                    fmt::format("`{}` is defined here, and nobody uses it", symbol.name));
    addUses(finding, uses);
    if (!isFragment())
      finding.fix(fmt::format("call it `{}` where it is defined", uses.front().text), symbol.at,
                  uses.front().text);
  }

  static void addUses(Finding& finding, const std::vector<UnknownName>& uses) {
    const std::size_t more = uses.size() - std::min(uses.size(), kMostRelated + 1);
    const std::size_t end = uses.size() - more;
    for (std::size_t i = 1; i < end; ++i)
      finding.related(uses[i].at, more > 0 && i + 1 == end
                                      ? fmt::format("used here too, and {} more times", more)
                                      : "used here too");
  }

  [[nodiscard]] bool isFragment() const { return program.extent == Extent::Fragment; }

  template <class Visit> void forEachCandidate(const UnknownName& use, Visit visit) const {
    for (SymbolKind kind : use.kinds) {
      for (SymbolId id : symbols.members(kind, use.owner)) visit(id);
      if (!use.anywhere) continue;
      for (SymbolId id = 0; id < symbols.all().size(); ++id)
        if (symbols[id].kind == kind) visit(id);
    }
  }

  /// The nearest word, if any is near: among all, or among those without uses.
  [[nodiscard]] Near nearest(const UnknownName& use, bool unmentioned) {
    syntax::Suggestion suggestion(use.text);
    Near found;
    forEachCandidate(use, [&](SymbolId id) {
      if (comparisons == kMostComparisons || (unmentioned && mentioned[id])) return;
      ++comparisons;
      const std::string_view name = symbols[id].name;
      if (suggestion.offer(name)) found = {name, id};
    });
    if (unmentioned) return found;
    for (std::string_view word : use.words)
      if (suggestion.offer(word)) found = {word};
    return found;
  }

  static bool isNearer(const Near& a, const Near& b, const UnknownName& use) {
    const std::size_t limit = use.text.size();
    return syntax::editDistance(use.text, a.word, limit) <
           syntax::editDistance(use.text, b.word, limit);
  }

  /// Whether an error that was reported hides the meaning of the name.
  [[nodiscard]] bool isConsequence(const UnknownName& use) const {
    if (use.owner == kNoSymbol)
      return definitionsHidden || unreadNames.contains(use.text) || isUnnamed(use);
    const Symbol& owner = symbols[use.owner];
    return std::ranges::any_of(hidden, [&](const Location& at) {
      return at.file == owner.at.file && owner.extent.begin <= at.range.begin &&
             at.range.end <= owner.extent.end;
    });
  }

  /// Whether a definition of this kind lacks a name.
  [[nodiscard]] bool isUnnamed(const UnknownName& use) const {
    return std::ranges::any_of(unnamed, [&](SymbolId id) {
      const Symbol& symbol = symbols[id];
      return std::ranges::count(use.kinds, symbol.kind) > 0 &&
             (use.anywhere || symbol.owner == use.owner);
    });
  }

  const Program& program;
  const SymbolTable& symbols;
  Findings& findings;
  std::vector<bool> mentioned; ///< by symbol
  std::vector<SymbolId> unnamed;
  std::size_t comparisons = 0;
  bool definitionsHidden = false;
  std::vector<Location> hidden;           ///< places where parts of definitions could not be parsed
  std::set<std::string_view> unreadNames; ///< of definitions that could not be parsed
};

/// A type may be a state variable, so both codes are about the same name.
Code codeOfKey(Code code) { return code == Code::UnknownType ? Code::UnknownStateVariable : code; }

} // namespace

void reportUnknownNames(const Program& program, const Index& index,
                        const std::vector<UnknownName>& names, Findings& findings) {
  if (names.empty()) return;
  std::map<std::tuple<Code, SymbolId, std::string_view>, std::vector<UnknownName>> uses;
  for (const UnknownName& it : names)
    uses[{codeOfKey(it.code.code), it.owner, it.text}].push_back(it);
  Reporter reporter(program, index, findings);
  for (auto& [key, same] : uses) {
    std::ranges::stable_sort(same, {}, [](const UnknownName& use) {
      return std::pair(use.at.file, use.at.range.begin);
    });
    reporter.report(same);
  }
}

} // namespace proskill::analysis
