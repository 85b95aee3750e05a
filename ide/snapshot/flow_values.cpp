#include "ide/snapshot/flow_values.h"

#include "analysis/flow/values_at.h"

#include <fmt/format.h>

namespace proskill::ide {

namespace {

using analysis::SymbolKind;
namespace flow = analysis::flow;

/// Total size of a program's texts. For smaller ones the flow analysis takes some milliseconds.
constexpr std::size_t kQuick = 100'000;

std::size_t sizeOf(const analysis::Program& program) {
  std::size_t size = 0;
  for (const auto& file : program.files) size += file.document.text().size();
  return size;
}

} // namespace

std::shared_ptr<const KnownFlow> quickFlow(const View& view) {
  if (auto known = view.owner->flowIfKnown()) return known;
  if (sizeOf(view.program()) <= kQuick) return view.owner->flow();
  view.owner->missFlow();
  return view.owner->flowIfKnown(); // another thread may have computed it meanwhile
}

std::optional<flow::VariableId> flowVariable(const View& view, const KnownFlow& flow,
                                             std::string_view text) {
  const auto& symbols = view.index().symbols();
  const auto dot = text.find('.');
  const auto isAccess = dot != std::string_view::npos;
  const auto symbol =
      symbols.find(isAccess ? SymbolKind::Skill : SymbolKind::StateVariable, text.substr(0, dot));
  if (symbol == analysis::kNoSymbol) return std::nullopt;
  auto kind = flow::VariableKind::StateVariable;
  if (isAccess) {
    const auto member = text.substr(dot + 1);
    if (member != "status" && member != "res") return std::nullopt;
    kind = member == "res" ? flow::VariableKind::Result : flow::VariableKind::Status;
  }
  return flow.system().variables().of(kind, symbols[symbol].definition);
}

std::string valuesHere(const View& view, analysis::Location place, std::string_view text) {
  const auto flow = quickFlow(view);
  if (!flow) return {};
  const auto variable = flowVariable(view, *flow, text);
  const auto points = flow::pointsAround(flow->flow(), flow->then(place));
  if (!variable || points.empty()) return {};
  if (!flow::isReached(flow->flow(), points)) return "This place is never reached.";
  const auto values = flow::valuesAt(flow->flow(), points, *variable);
  if (!values) return {};
  const auto& variables = flow->system().variables();
  if (*values == variables[*variable].domain.all()) return "Here it can be any of its values.";
  return fmt::format("Here it is {}.", variables.words(*variable, *values));
}

std::string valuesEver(const View& view, std::string_view text) {
  const auto flow = quickFlow(view);
  if (!flow) return {};
  const auto variable = flowVariable(view, *flow, text);
  if (!variable) return {};
  const auto values = flow->solver().ever(*variable);
  const auto& variables = flow->system().variables();
  if (values.empty() || values == variables[*variable].domain.all()) return {};
  return fmt::format("In all runs it is {}.", variables.words(*variable, values));
}

} // namespace proskill::ide
