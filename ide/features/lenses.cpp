#include "ide/features/lenses.h"

#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"
#include "ide/snapshot/symbol_key.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace proskill::ide {

namespace {

using analysis::SymbolId;
using analysis::SymbolKind;

bool hasReferences(SymbolKind kind) {
  return kind != SymbolKind::Property && kind != SymbolKind::Environment;
}

bool hasAutomaton(SymbolKind kind) {
  return kind == SymbolKind::StateVariable || kind == SymbolKind::Skill;
}

bool isVerified(SymbolKind kind) {
  return kind == SymbolKind::Skill || kind == SymbolKind::Property;
}

/// Which definitions of a large file have lenses first.
enum Rank : std::size_t { Missions, Skills, Others, kRanks };

Rank rankOf(const View& view, const analysis::Symbol& symbol) {
  if (symbol.kind == SymbolKind::Property) return Missions;
  if (symbol.kind != SymbolKind::Skill) return Others;
  const auto& skill = view.program().skills.all[symbol.definition].node();
  return skill.isComposite() ? Missions : Skills;
}

/// Counts of verdicts on a subject, as on the command line.
struct Summary {
  std::size_t good = 0;
  std::size_t bad = 0;
  std::size_t warnings = 0; ///< violated, but not errors
  std::size_t open = 0;
  std::size_t pending = 0;
  /// The verdict to open, with a trace if possible: the first violated one, else the first warning.
  const PropertyVerdict* worst = nullptr;

  explicit Summary(const std::vector<const PropertyVerdict*>& verdicts) {
    for (const auto* verdict : verdicts) {
      if (verdict->good())
        ++good;
      else if (!verdict->bad())
        ++(verdict->pending ? pending : open);
      else
        ++(isError(*verdict) ? bad : warnings);
      if (verdict->bad() && (!worst || isWorse(*verdict, *worst))) worst = verdict;
    }
  }

  static bool isError(const PropertyVerdict& verdict) {
    return verdict.weight == codegen::Weight::Error;
  }

  static bool isWorse(const PropertyVerdict& one, const PropertyVerdict& other) {
    return std::pair(one.steps.has_value(), isError(one)) >
           std::pair(other.steps.has_value(), isError(other));
  }

  [[nodiscard]] std::string words() const {
    std::string text;
    auto add = [&](std::size_t count, std::string_view what) {
      if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    };
    add(bad, "bad");
    add(warnings, warnings == 1 ? "warning" : "warnings");
    add(open, "inconclusive");
    add(good, "good");
    add(pending, "to be decided");
    return (bad > 0 ? "✗ " : open > 0 ? "? " : pending > 0 ? "… " : "✓ ") + text;
  }
};

class Lenses {
public:
  Lenses(const View& view, const Verdicts& all) : view(view) {
    auto found = all.find(view.program().files.front().path);
    if (found == all.end()) return;
    verdicts = found->second;
    isStale = !areCurrent(*verdicts, view.program());
    for (const auto& verdict : verdicts->properties) bySubject[verdict.subject].push_back(&verdict);
  }

  std::vector<Lens> gather() && {
    if (isFiacre(view))
      ofFiacre();
    else
      ofProgram();
    return std::move(result);
  }

private:
  void ofProgram() {
    const auto& symbols = view.index().symbols();
    std::vector<std::pair<SymbolId, Rank>> defined;
    std::array<std::size_t, kRanks> counts{};
    for (const auto& form : view.document().forms()) {
      const auto id = symbolOf(view, view.file, form);
      if (id == analysis::kNoSymbol || symbols[id].name.empty()) continue;
      defined.emplace_back(id, rankOf(view, symbols[id]));
      ++counts[defined.back().second];
    }
    const auto last = lastRank(counts);
    for (const auto& [id, rank] : defined)
      if (rank <= last) ofSymbol(id);
  }

  /// Independent of verdicts: otherwise lines would move after each verification.
  static std::size_t lastRank(const std::array<std::size_t, kRanks>& counts) {
    std::size_t last = Missions;
    auto sum = counts[Missions];
    while (last + 1 < kRanks && (sum += counts[last + 1]) <= kMostWithLenses) ++last;
    return last;
  }

  /// Adds a lens for each property, and one for all at the model's name.
  void ofFiacre() {
    const FiacreText text(view.text());
    const auto model = text.model();
    if (!model) return;
    std::vector<const PropertyVerdict*> all;
    for (const auto& [_, known] : bySubject) all.insert(all.end(), known.begin(), known.end());
    ofFiacre(*model, {}, all);
    for (const auto& at : text.asserted()) {
      std::string name(view.text().substr(at.begin, at.end - at.begin));
      all.clear();
      for (const auto& [_, known] : bySubject)
        for (const auto* verdict : known)
          if (verdict->name == name) all.push_back(verdict);
      ofFiacre(at, std::move(name), all);
    }
    std::ranges::stable_sort(result, {}, [](const Lens& lens) { return lens.at.begin; });
  }

  void ofFiacre(syntax::Range at, std::string name, const std::vector<const PropertyVerdict*>& of) {
    if (!of.empty()) addVerdicts({LensKind::Verdicts, analysis::kNoSymbol, at, {}, {}, name}, of);
    result.push_back({LensKind::Verify, analysis::kNoSymbol, at, "verify", {}, std::move(name)});
  }

  void ofSymbol(SymbolId id) {
    const auto& symbol = view.index().symbols()[id];
    auto add = [&](LensKind kind, std::string title) {
      result.push_back({kind, id, symbol.at.range, std::move(title), {}, {}});
    };
    if (verdicts) ofVerdicts(id, symbol);
    if (hasReferences(symbol.kind)) add(LensKind::References, {});
    if (hasAutomaton(symbol.kind)) add(LensKind::Automaton, "show automaton");
    if (isVerified(symbol.kind)) add(LensKind::Verify, "verify");
  }

  void ofVerdicts(SymbolId id, const analysis::Symbol& symbol) {
    auto found = bySubject.find(symbol.name);
    if (found == bySubject.end()) return;
    addVerdicts({LensKind::Verdicts, id, symbol.at.range, {}, {}, {}}, found->second);
  }

  void addVerdicts(Lens lens, const std::vector<const PropertyVerdict*>& of) {
    const Summary summary(of);
    lens.title = summary.words();
    if (isStale)
      lens.title += " (outdated)";
    else if (const auto* duration = durationOf(*verdicts, of.front()->subject);
             duration && !isAnyTime(*duration))
      lens.title += " · " + durationText(*duration);
    if (summary.worst && summary.worst->steps) lens.property = summary.worst->name;
    result.push_back(std::move(lens));
  }

  const View& view;
  std::shared_ptr<const ProgramVerdicts> verdicts;
  bool isStale = false;
  std::map<std::string_view, std::vector<const PropertyVerdict*>> bySubject;
  std::vector<Lens> result;
};

} // namespace

std::vector<Lens> lenses(const View& view, const Verdicts& verdicts) {
  return Lenses(view, verdicts).gather();
}

std::string referencesTitle(std::size_t count) {
  return count == 1 ? "1 reference" : fmt::format("{} references", count);
}

} // namespace proskill::ide
