#include "ide/features/hover.h"

#include "ide/description/describe.h"
#include "ide/names/word_at.h"
#include "ide/snapshot/flow_values.h"

namespace proskill::ide {

namespace {

using analysis::Role;
using analysis::SymbolKind;

void addValues(Markup& text, const View& view, const analysis::Occurrence& occurrence) {
  const auto& symbol = view.index().symbols()[occurrence.symbol];
  if (symbol.kind != SymbolKind::StateVariable) return;
  auto values = occurrence.role == Role::Definition ? valuesEver(view, symbol.name)
                                                    : valuesHere(view, occurrence.at, symbol.name);
  if (!values.empty()) text.prose(values);
}

/// How long a skill takes, if that was measured for exactly these texts.
void addDuration(Markup& text, const View& view, const analysis::Occurrence& occurrence,
                 const Verdicts& verdicts) {
  const auto& symbol = view.index().symbols()[occurrence.symbol];
  if (symbol.kind != SymbolKind::Skill) return;
  const auto known = currentVerdicts(verdicts, view);
  const auto* duration = known ? durationOf(*known, symbol.name) : nullptr;
  if (!duration) return;
  const auto sentence = durationSentence(*duration, mayTimeStop(*known));
  if (!sentence.empty()) text.prose(sentence);
}

/// Whether the cursor is on the second part of `takeoff.status`.
bool isMember(const Path& path, std::string_view text) {
  const auto dot = text.find('.');
  return dot != std::string_view::npos && path.prefix.size() > dot;
}

Hover ofMember(const View& view, const Word& word, syntax::Range range, std::string_view text) {
  Hover result;
  const auto dot = static_cast<syntax::Offset>(text.find('.'));
  result.range = {range.begin + dot + 1, range.end};
  result.text.code(text);
  result.text.prose(word.sentence);
  if (auto values = valuesHere(view, {view.file, range}, text); !values.empty())
    result.text.prose(values);
  return result;
}

} // namespace

std::optional<Hover> hover(const View& view, syntax::Offset at, const Verdicts& verdicts) {
  const Path path = pathTo(view.document(), at);
  const auto text = std::string_view(view.text()).substr(path.word.begin, path.word.length());
  const Word* word = wordAt(path, text);
  if (word && isMember(path, text)) return ofMember(view, *word, path.word, text);
  if (const auto* occurrence = view.index().at(view.file, at)) {
    Hover result{{}, occurrence->at.range};
    describe(result.text, view, occurrence->symbol);
    addValues(result.text, view, *occurrence);
    addDuration(result.text, view, *occurrence, verdicts);
    return result;
  }
  if (!word || word->kind == WordKind::Member) return std::nullopt;
  Hover result{{}, path.word};
  result.text.code(word->form);
  result.text.prose(word->sentence);
  return result;
}

} // namespace proskill::ide
