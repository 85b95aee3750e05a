#include "analysis/reuse.h"
#include "syntax/codes.h"

#include <algorithm>
#include <array>

namespace proskill::analysis {

namespace {

using syntax::Code;
using syntax::Diagnostic;
using syntax::Form;
using syntax::Range;
using syntax::Replacement;

/// Moves what points into a file that was edited.
struct Move {
  FileId file;
  Replacement edit;

  /// \return it has a new place
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

/// Whether a fix of such a finding may look at the white space and the comments around it. Those of
/// moves, of which a program may have many, write words and quote what they replace.
bool looksAround(Code code) {
  constexpr std::array kOfMoves{Code::ForbiddenMove,       Code::MayBeForbiddenMove,
                                Code::EventMayBeForbidden, Code::LeavesRange,
                                Code::MayLeaveRange,       Code::EventMayLeaveRange};
  return std::ranges::find(kOfMoves, code) == kOfMoves.end();
}

/// Its text, or a fix, may quote what white space or comment was edited.
bool quotes(const Diagnostic& diagnostic, const FileChange& edit) {
  const auto edited = edit.change.layout->before();
  const auto around = looksAround(diagnostic.code) ? edit.change.stretches.before() : edited;
  return touches(diagnostic.location, edit.file, edited) ||
         std::ranges::any_of(diagnostic.fixes, [&](const syntax::Fix& fix) {
           return touches(fix.location, edit.file, around);
         });
}

bool anyQuotes(const std::vector<Diagnostic>& diagnostics, const FileChange& edit) {
  return std::ranges::any_of(diagnostics, [&](const Diagnostic& it) { return quotes(it, edit); });
}

/// Those that define something, or include it.
std::vector<const Form*> definitionsIn(const syntax::Document& document, Range range) {
  std::vector<const Form*> result;
  for (const Form& form : document.formsIn(range))
    if (!std::holds_alternative<syntax::UnknownForm>(form.node)) result.push_back(&form);
  return result;
}

bool isSameNumber(const std::optional<syntax::Expr>& a, const std::optional<syntax::Expr>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->kind == b->kind && a->number == b->number;
}

/// What others see of a state variable beside its name and those of its values: its type.
bool looksSame(const syntax::StateVariable& a, const syntax::StateVariable& b) {
  return a.states.empty() == b.states.empty() && isSameNumber(a.min, b.min) &&
         isSameNumber(a.max, b.max);
}

bool isSameInput(const syntax::Input& a, const syntax::Input& b) {
  return a.name.text == b.name.text && a.type.text == b.type.text;
}

/// What others see of a skill beside its name and those of its parts.
bool looksSame(const syntax::Skill& a, const syntax::Skill& b) {
  return a.monitor == b.monitor && a.interrupt.has_value() == b.interrupt.has_value() &&
         std::ranges::equal(a.inputs, b.inputs, isSameInput);
}

/// Whether nobody else sees a difference, the names aside.
bool looksSame(const Form* a, const Form* b) {
  if (a->node.index() != b->node.index()) return false;
  if (const auto* skill = std::get_if<syntax::Skill>(&a->node))
    return looksSame(*skill, std::get<syntax::Skill>(b->node));
  if (const auto* variable = std::get_if<syntax::StateVariable>(&a->node))
    return looksSame(*variable, std::get<syntax::StateVariable>(b->node));
  return !std::holds_alternative<syntax::Include>(a->node);
}

bool isSameSymbol(const Symbol& a, const Symbol& b) {
  return a.kind == b.kind && a.owner == b.owner && a.definition == b.definition && a.name == b.name;
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
  if (!edit ||
      !std::ranges::equal(earlier.analysis.index.symbols().all(), symbols.all(), isSameSymbol))
    return std::nullopt;
  const auto& [file, change] = *edit;
  auto keeping = [&](const Replacement& replaced, bool isLayout) -> std::optional<Reuse> {
    Reuse reuse(earlier.analysis.index, file, replaced, isLayout);
    for (const Found& found : earlier.analysis.ofDefinitions)
      if ((isLayout && anyQuotes(found.diagnostics, *edit)) || !reuse.keep(found))
        return std::nullopt;
    return reuse;
  };
  if (change.layout)
    if (auto reuse = keeping(*change.layout, true)) return reuse;
  const auto& replaced = change.stretches;
  const bool same =
      std::ranges::equal(definitionsIn(earlier.program.files[file].document, replaced.before()),
                         definitionsIn(now.files[file].document, replaced.after()),
                         [](const Form* a, const Form* b) { return looksSame(a, b); });
  return same ? keeping(replaced, false) : std::nullopt;
}

/// \return all that is kept has a new place
bool Reuse::keep(const Found& found) {
  const Move move{file, edit};
  const auto isGone = [&](const Location& at) {
    return !isLayout && at.file == file && edit.before().contains(at.range.begin);
  };
  Found& now = kept.emplace_back();
  for (const Diagnostic& each : found.diagnostics)
    if (!isGone(each.location) && !move(now.diagnostics.emplace_back(each))) return false;
  for (const Location& each : found.notCalls)
    if (!isGone(each) && !move(now.notCalls.emplace_back(each))) return false;
  for (const UnknownName& each : found.unknown)
    if (!isGone(each.at) && !move(now.unknown.emplace_back(each).at)) return false;
  return true;
}

Scope Reuse::scope() const { return {false, {file, isLayout ? Range{} : edit.after()}}; }

Index Reuse::index(SymbolTable symbols, std::vector<Occurrence> occurrences) const {
  return {std::move(symbols), std::move(occurrences), before, file, edit};
}

} // namespace proskill::analysis
