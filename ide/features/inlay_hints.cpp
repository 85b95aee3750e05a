#include "ide/features/inlay_hints.h"

#include "analysis/flow/result/durations.h"
#include "analysis/flow/values_at.h"
#include "analysis/names/walk.h"
#include "ide/snapshot/before_errors.h"
#include "ide/snapshot/flow_values.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <ranges>
#include <tuple>

namespace proskill::ide {

namespace {

namespace flow = analysis::flow;
using syntax::ExprKind;

constexpr unsigned kMostValues = 3; ///< listed in a hint

bool isLiteral(const syntax::Expr& expr) {
  return expr.kind == ExprKind::Number || expr.kind == ExprKind::String ||
         expr.kind == ExprKind::True || expr.kind == ExprKind::False;
}

/// A variable of the flow in a condition.
struct VariableMention {
  std::string name;
  syntax::Range at;
};

class Hints {
public:
  Hints(const View& view, syntax::Range range, const Verdicts& verdicts)
      : view(view),
        range(range),
        flow(quickFlow(view)),
        measured(currentVerdicts(verdicts, view)) {}

  std::vector<InlayHint> gather() && {
    for (const auto& skill : view.program().skills.all)
      if (skill.file == view.file && skill.form->range.touches(range)) ofSkill(skill.node());
    if (flow) values();
    std::ranges::stable_sort(hints, {}, &InlayHint::at);
    return std::move(hints);
  }

private:
  void add(InlayHint hint) {
    if (range.begin <= hint.at && hint.at <= range.end) hints.push_back(std::move(hint));
  }

  void ofSkill(const syntax::Skill& skill) {
    if (!skill.body) return;
    analysis::forEachStatement(*skill.body, [&](const syntax::Statement& statement) {
      const bool isCall = statement.kind == syntax::StatementKind::Call;
      if (isCall && statement.range.touches(range)) ofCall(statement);
    });
    if (flow) duration(skill);
  }

  void ofCall(const syntax::Statement& call) {
    const auto* callee = view.program().skills.find(call.head.text);
    if (!callee) return;
    for (const auto& argument : call.arguments) {
      if (!isLiteral(argument.value)) continue;
      for (const auto& input : (*callee)->inputs)
        if (analysis::withoutDollar(input.name).text == argument.name.text && input.type)
          add({HintKind::ArgumentType, argument.name.range.end,
               fmt::format(": {}", input.type.text),
               fmt::format("The type of the input `{}` of `{}`.", input.name.text, callee->name()),
               callee->at(input.name.range)});
    }
  }

  /// Adds the duration of a skill that some run starts.
  void duration(const syntax::Skill& skill) {
    const auto& skills = view.program().skills;
    const auto* definition = skills.find(skill.name.text);
    if (!definition || &definition->node() != &skill) return;
    const auto id =
        flow->system().ofSkill(static_cast<std::size_t>(definition - skills.all.data()));
    if (!flow->solver().started(id) || addMeasured(skill)) return;
    if (!durations) durations.emplace(flow->solver());
    const auto taken = durations->of(id);
    if (taken && !taken->most && taken->least == syntax::Rational{})
      return; // any duration: not worth a hint
    const auto text = taken ? flow::words(*taken) : std::string("never ends");
    add({HintKind::Duration, skill.name.range.end, text,
         "From the start of the skill to its end, in runs that nobody stops; computed from its "
         "parts.",
         std::nullopt});
  }

  /// Adds the duration that lenses show. \return whether there is no need of another
  bool addMeasured(const syntax::Skill& skill) {
    const auto* known = measured ? durationOf(*measured, skill.name.text) : nullptr;
    if (!known) return false;
    if (isAnyTime(*known)) return known->shortest && known->longest;
    add({HintKind::Duration, skill.name.range.end, durationText(*known),
         durationSentence(*known, mayTimeStop(*measured)), std::nullopt});
    return true;
  }

  /// Adds values; one place in the text may be several steps.
  void values() {
    std::map<std::pair<syntax::Offset, syntax::Offset>, std::vector<flow::Point>> byText;
    const auto then = flow->then({view.file, range});
    for (const auto& point : flow::pointsTouching(flow->flow(), then))
      byText[{point.at.range.begin, point.at.range.end}].push_back(point);
    for (const auto& [text, points] : byText) {
      const auto& first = points.front();
      const auto& node = (*flow->system()[first.process].graph)[first.node];
      if (node.invariant) continue; // reached only after the guard has failed
      for (const auto* condition : node.conditions) ofCondition(*condition, points);
    }
  }

  /// Whether the word is a variable: a word beside it may be one of its values.
  [[nodiscard]] bool isVariable(syntax::Range now) const {
    const auto* occurrence = view.index().at(view.file, now.begin);
    return occurrence &&
           view.index().symbols()[occurrence->symbol].kind == analysis::SymbolKind::StateVariable;
  }

  /// The definition of the name; for `takeoff.status`, that of the skill.
  [[nodiscard]] std::optional<analysis::Location> definitionAt(syntax::Range name) const {
    const auto* occurrence = view.index().at(view.file, name.begin);
    if (!occurrence) return std::nullopt;
    return view.index().symbols()[occurrence->symbol].at;
  }

  void collect(const syntax::Expr& expr, std::vector<VariableMention>& mentions) const {
    const auto now = [this](syntax::Range then) { return flow->now({view.file, then}).range; };
    const bool isName = expr.kind == ExprKind::Test || expr.kind == ExprKind::Symbol;
    if (isName && isVariable(now(expr.name.range)))
      mentions.push_back({std::string(expr.name.text), now(expr.name.range)});
    if (expr.kind == ExprKind::Access)
      mentions.push_back({fmt::format("{}.{}", expr.name.text, expr.member.text), now(expr.range)});
    for (const auto& operand : expr.operands) collect(operand, mentions);
  }

  void ofCondition(const syntax::Expr& condition, const std::vector<flow::Point>& points) {
    std::vector<VariableMention> mentions;
    collect(condition, mentions);
    for (const auto& mention : mentions) {
      const auto variable = flowVariable(view, *flow, mention.name);
      if (!variable) continue;
      const auto values = flow::valuesAt(flow->flow(), points, *variable);
      auto label = values ? labelOf(*variable, *values) : std::string();
      if (label.empty()) continue;
      add({HintKind::Values, mention.at.end, std::move(label),
           fmt::format("What `{}` can be when the program comes here.", mention.name),
           definitionAt(mention.at)});
    }
  }

  /// "= Good or Low", or "≠ Empty" if that is shorter; empty if the values are unknown or
  /// unremarkable.
  [[nodiscard]] std::string labelOf(flow::VariableId variable, flow::ValueSet values) const {
    const auto excluded = flow->solver().ever(variable) - values;
    const auto& variables = flow->system().variables();
    if (excluded.empty() || values.empty()) return {};
    if (values.count() <= kMostValues)
      return fmt::format("= {}", variables.words(variable, values));
    if (excluded.count() > 1) return {};
    return fmt::format("≠ {}", variables.words(variable, excluded));
  }

  const View& view;
  syntax::Range range;
  std::shared_ptr<const KnownFlow> flow;
  std::shared_ptr<const ProgramVerdicts> measured;
  std::optional<flow::Durations> durations;
  std::vector<InlayHint> hints;
};

/// The hint at its place in the current text, if that is in the range and unchanged. What it is
/// about may have moved.
std::optional<InlayHint> kept(InlayHint hint, const SkillBeforeErrors& skill, syntax::Range range) {
  const auto now = skill.now(hint.at);
  if (!now || *now < range.begin || *now > range.end) return std::nullopt;
  hint.at = *now;
  hint.tooltip += " As of the last text without errors.";
  hint.about.reset();
  return hint;
}

/// Adds what was known from the flow before the program had errors, so that hints do not come and
/// go with each key.
void addKept(const View& view, syntax::Range range, const Verdicts& verdicts,
             std::vector<InlayHint>& hints) {
  for (const auto& skill : skillsBeforeErrors(view, range))
    for (auto& hint : Hints(skill.view, skill.range, verdicts).gather()) {
      if (hint.kind == HintKind::ArgumentType) continue; // needs no flow
      if (auto now = kept(std::move(hint), skill, range)) hints.push_back(std::move(*now));
    }
  std::ranges::stable_sort(hints, {}, &InlayHint::at);
}

} // namespace

std::vector<InlayHint> inlayHints(const View& view, syntax::Range range, const Verdicts& verdicts) {
  auto hints = Hints(view, range, verdicts).gather();
  addKept(view, range, verdicts, hints);
  return hints;
}

std::vector<InlineVariable> inlineVariables(const View& view, syntax::Range range) {
  std::vector<InlineVariable> result;
  const auto& symbols = view.index().symbols();
  const auto& lines = view.document().lines();
  auto lineOf = [&](syntax::Range at) { return lines.position(at.begin).line; };
  for (const auto& place : view.index().occurrences({view.file, range})) {
    const auto& symbol = symbols[place.symbol];
    if (symbol.kind != analysis::SymbolKind::StateVariable) continue;
    const auto line = lineOf(place.at.range);
    const bool isKnown = std::ranges::any_of(
        result | std::views::reverse |
            std::views::take_while([&](const auto& it) { return lineOf(it.range) == line; }),
        [&](const auto& it) { return it.name == symbol.name; });
    if (!isKnown) result.push_back({place.at.range, std::string(symbol.name)});
  }
  return result;
}

} // namespace proskill::ide
