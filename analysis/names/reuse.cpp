#include "analysis/names/reuse.h"

#include "analysis/program/constants.h"
#include "analysis/program/outcomes.h"
#include "syntax/diagnostics/codes.h"
#include "syntax/text/characters.h"

#include <algorithm>
#include <array>
#include <set>

namespace proskill::analysis {

namespace {

using syntax::Code;
using syntax::Diagnostic;
using syntax::Form;
using syntax::Range;
using syntax::Replacement;

/// Moves locations in a file that was edited.
struct Move {
  FileId file;
  Replacement edit;

  /// \return whether the place has changed
  bool operator()(Location& at) const {
    if (at.file != file) return true;
    const auto range = edit.moved(at.range);
    if (range) at.range = *range;
    return range.has_value();
  }
  bool operator()(Diagnostic& diagnostic) const {
    auto move = [this](auto& it) { return (*this)(it.location); };
    return (*this)(diagnostic.location) && std::ranges::all_of(diagnostic.related, move) &&
           std::ranges::all_of(diagnostic.fixes, move);
  }
};

bool touches(Location at, FileId file, Range range) {
  return at.file == file && at.range.begin <= range.end && range.begin <= at.range.end;
}

/// Whether a fix of such a finding may depend on the surrounding white space and comments. Findings
/// about moves, which may be numerous, do not: their fixes write words, and quote what they
/// replace.
bool looksAround(Code code) {
  constexpr std::array kOfMoves{Code::ForbiddenMove,       Code::MayBeForbiddenMove,
                                Code::EventMayBeForbidden, Code::LeavesRange,
                                Code::MayLeaveRange,       Code::EventMayLeaveRange};
  return std::ranges::find(kOfMoves, code) == kOfMoves.end();
}

/// Whether its text, or a fix, may quote edited white space or comments.
bool quotes(const Diagnostic& diagnostic, const FileChange& edit) {
  const auto edited = edit.change.layout->before();
  const auto around = looksAround(diagnostic.code) ? edit.change.regions.before() : edited;
  return touches(diagnostic.location, edit.file, edited) ||
         std::ranges::any_of(diagnostic.fixes, [&](const syntax::Fix& fix) {
           return touches(fix.location, edit.file, around);
         });
}

bool anyQuotes(const std::vector<Diagnostic>& diagnostics, const FileChange& edit) {
  return std::ranges::any_of(diagnostics, [&](const Diagnostic& it) { return quotes(it, edit); });
}

/// Whether it ends at or before the start of the other.
bool isBefore(Location it, Location other) {
  return it.file < other.file || (it.file == other.file && it.range.end <= other.range.begin);
}

/// The forms that are definitions or includes.
std::vector<const Form*> definitionsIn(const syntax::Document& document, Range range) {
  std::vector<const Form*> result;
  for (const Form& form : document.formsIn(range))
    if (!form.is<syntax::UnknownForm>()) result.push_back(&form);
  return result;
}

bool isSameNumber(const std::optional<syntax::Expr>& a, const std::optional<syntax::Expr>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->kind == b->kind && a->number == b->number && a->name.text == b->name.text;
}

/// Whether the two have the same type; names are compared elsewhere.
bool looksSame(const syntax::StateVariable& a, const syntax::StateVariable& b) {
  return a.states.empty() == b.states.empty() && isSameNumber(a.min, b.min) &&
         isSameNumber(a.max, b.max);
}

/// Whether both occur by themselves, or neither does; names are compared elsewhere.
bool looksSame(const syntax::Event& a, const syntax::Event& b) {
  return a.every.has_value() == b.every.has_value();
}

bool isSameInput(const syntax::Input& a, const syntax::Input& b) {
  return a.name.text == b.name.text && a.type.text == b.type.text;
}

/// Compares what others see of a skill, apart from the names of it and its parts.
bool looksSame(const syntax::Skill& a, const syntax::Skill& b) {
  return a.monitor == b.monitor && a.interrupt.has_value() == b.interrupt.has_value() &&
         a.unstoppable == b.unstoppable && outcomesOf(a) == outcomesOf(b) &&
         std::ranges::equal(a.inputs, b.inputs, isSameInput);
}

/// Compares what others see of a definition, apart from names.
bool looksSame(const Form* a, const Form* b) {
  if (!a->isAs(*b)) return false;
  if (const auto* skill = a->as<syntax::Skill>()) return looksSame(*skill, *b->as<syntax::Skill>());
  if (const auto* variable = a->as<syntax::StateVariable>())
    return looksSame(*variable, *b->as<syntax::StateVariable>());
  if (const auto* event = a->as<syntax::Event>()) return looksSame(*event, *b->as<syntax::Event>());
  return !a->is<syntax::Include>();
}

using Names = std::set<std::string_view>;

/// Adds the definitions whose visible parts have changed, apart from symbols.
/// \return false if an include has changed, which may matter anywhere
bool addThoseSeen(const std::vector<const Form*>& before, const std::vector<const Form*>& now,
                  Names& names) {
  const auto isInclude = [](const Form* form) { return form->is<syntax::Include>(); };
  if (std::ranges::any_of(before, isInclude) || std::ranges::any_of(now, isInclude)) return false;
  for (const Form* form : now) {
    const auto same = std::ranges::find_if(before, [&](const Form* it) {
      return it->isAs(*form) && it->name.text == form->name.text;
    });
    if (same != before.end() && !looksSame(*same, form)) names.insert(form->name.text);
  }
  return true;
}

/// Adds the skills with inputs of these types, transitively, since their callers pass values.
void addThoseTyped(const Program& program, Names& names) {
  const auto isOne = [&](const syntax::Input& input) { return names.contains(input.type.text); };
  for (auto before = names.size() + 1; before != names.size();) {
    before = names.size();
    for (const auto& skill : program.skills.all)
      if (std::ranges::any_of(skill.nodeAsRead().inputs, isOne)) names.insert(skill.name());
  }
}

/// Calls `visit` for each occurrence of the word.
template <class Visit>
void forEachPlace(std::string_view text, std::string_view word, Visit visit) {
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const auto end = at + word.size();
    const bool begins = at == 0 || !syntax::isWordCharacter(text[at - 1]);
    if (begins && (end == text.size() || !syntax::isWordCharacter(text[end])))
      visit(static_cast<syntax::Offset>(at));
  }
}

/// The regions of a text that contain one of the words.
std::set<std::size_t> regionsWith(const syntax::Document& document,
                                  std::span<const syntax::Region> regions, const Names& words) {
  std::set<std::size_t> result;
  for (const auto word : words)
    forEachPlace(document.text(), word, [&](syntax::Offset at) {
      const auto after = std::ranges::upper_bound(
          regions, at, {}, [](const auto& region) { return region.range.begin; });
      result.insert(static_cast<std::size_t>(after - regions.begin()) - 1);
    });
  return result;
}

/// The places that contain one of the words, and the edited ones.
Scope scopeOf(const Program& program, const Names& words, FileId file, Range edited) {
  Scope scope{false, {{file, edited}}};
  const auto isEdited = [&](FileId each, Range range) {
    return each == file && edited.begin <= range.begin && range.end <= edited.end;
  };
  for (FileId each = 0; !words.empty() && each < program.files.size(); ++each) {
    const auto& document = program.files[each].document;
    const auto regions = document.regions();
    for (const auto at : regionsWith(document, regions, words))
      if (!isEdited(each, regions[at].range)) scope.within.push_back({each, regions[at].range});
  }
  std::ranges::sort(scope.within, {}, [](const Location& it) {
    return std::tuple(it.file, it.range.begin, it.range.end);
  });
  return scope;
}

} // namespace

std::optional<FileChange> changeBetween(const Program& before, const Program& now) {
  const bool sameFiles = before.extent == now.extent &&
                         std::ranges::equal(before.files, now.files, {}, &File::path, &File::path);
  if (!sameFiles) return std::nullopt;
  std::optional<FileId> changed;
  for (FileId file = 0; file < now.files.size(); ++file) {
    if (before.files[file].document.isSameAs(now.files[file].document)) continue;
    if (changed) return std::nullopt;
    changed = file;
  }
  const FileId file = changed.value_or(0);
  return FileChange{file, now.files[file].document.changeFrom(before.files[file].document)};
}

std::optional<std::vector<Diagnostic>> movedByLayout(const std::vector<Diagnostic>& diagnostics,
                                                     const FileChange& edit) {
  if (!edit.change.layout || anyQuotes(diagnostics, edit)) return std::nullopt;
  auto result = diagnostics;
  if (!std::ranges::all_of(result, Move{edit.file, *edit.change.layout})) return std::nullopt;
  return result;
}

std::optional<Reuse> Reuse::find(const Earlier& earlier, const Program& now,
                                 const SymbolTable& symbols) {
  const auto edit = changeBetween(earlier.program, now);
  if (!edit || !haveSameConstants(earlier.program, now)) return std::nullopt;
  const auto& [file, change] = *edit;
  const auto& index = earlier.analysis.index;
  const auto& found = earlier.analysis.ofDefinitions;
  auto symbolChange = changeBetween(index.symbols(), symbols);
  const auto quotesLayout = [&](const Found& it) { return anyQuotes(it.diagnostics, *edit); };
  if (change.layout && std::ranges::none_of(found, quotesLayout)) {
    Reuse reuse(file, *change.layout, {false, {}}, symbolChange);
    if (reuse.keep(found) && reuse.keep(index.occurrences())) return reuse;
  }
  const auto& replaced = change.regions;
  auto& names = symbolChange.names;
  const bool isHere =
      addThoseSeen(definitionsIn(earlier.program.files[file].document, replaced.before()),
                   definitionsIn(now.files[file].document, replaced.after()), names);
  if (!isHere) return std::nullopt;
  addThoseTyped(now, names);
  Scope scope = scopeOf(now, names, file, replaced.after());
  Reuse reuse(file, replaced, std::move(scope), std::move(symbolChange));
  if (reuse.keep(found) && reuse.keep(index.occurrences())) return reuse;
  return std::nullopt;
}

Reuse::Reuse(FileId file, Replacement edit, Scope scope, SymbolChange change)
    : file(file),
      edit(edit),
      looked(std::move(scope)),
      gone{false, {}},
      symbols(std::move(change)) {
  for (Location at : looked.within) {
    if (at.file == file)
      at.range = at.range == edit.after() ? edit.before() : *edit.inverse().moved(at.range);
    gone.within.push_back(at);
  }
}

bool Reuse::isGone(const Location& at) const { return gone.holds(at.file, at.range.begin); }

/// \return whether it still exists
bool Reuse::moveSymbol(SymbolId& symbol) const {
  if (symbol == kNoSymbol) return true;
  symbol = symbols.now[symbol];
  return symbol != kNoSymbol;
}

bool Reuse::keep(const std::vector<Found>& found) {
  return std::ranges::all_of(found, [this](const Found& each) { return keep(each); });
}

bool Reuse::keep(const Found& found) {
  const Move move{file, edit};
  Found& now = kept.emplace_back();
  for (const Diagnostic& each : found.diagnostics)
    if (!isGone(each.location) && !move(now.diagnostics.emplace_back(each))) return false;
  for (const Location& each : found.notCalls)
    if (!isGone(each) && !move(now.notCalls.emplace_back(each))) return false;
  for (const UnknownName& each : found.unknown) {
    if (isGone(each.at)) continue;
    UnknownName& it = now.unknown.emplace_back(each);
    if (!move(it.at) || !moveSymbol(it.owner)) return false;
  }
  return true;
}

bool Reuse::keep(std::span<const Occurrence> occurrences) {
  const Move move{file, edit};
  places.reserve(occurrences.size());
  auto hole = gone.within.begin();
  for (const Occurrence& each : occurrences) {
    while (hole != gone.within.end() && isBefore(*hole, each.at)) ++hole;
    if (hole != gone.within.end() && hole->file == each.at.file &&
        hole->range.begin <= each.at.range.begin)
      continue;
    Occurrence& it = places.emplace_back(each);
    if (!move(it.at) || !moveSymbol(it.symbol)) return false;
  }
  return true;
}

Index Reuse::index(SymbolTable table, std::vector<Occurrence> noted) && {
  return {std::move(table), std::move(places), std::move(noted), looked};
}

} // namespace proskill::analysis
