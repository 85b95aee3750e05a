#include "viz/builder.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace proskill::viz {
namespace {

using VariableDefinition = analysis::Definition<syntax::StateVariable>;
using Move = std::pair<std::string_view, std::string_view>;

class StateVariablePicture {
public:
  StateVariablePicture(const analysis::Program& program, const VariableDefinition& shown)
      : variable(shown), builder(program, shown.file) {
    for (const auto& listed : variable->transitions)
      allowed.insert({listed.from.text, listed.to.text});
  }

  Graph draw(bool forbidden) {
    builder.graph.title = "state variable " + std::string(variable.name());
    if (variable->isNatural())
      drawNatural(forbidden);
    else
      drawStates(forbidden);
    return std::move(builder.graph);
  }

private:
  /// All moves within the bounds are allowed, so one node is enough.
  void drawNatural(bool forbidden) {
    const auto bound = [&](const std::optional<syntax::Expr>& expr) {
      return expr ? builder.text(expr->range) : std::string("…");
    };
    const auto range = variable.form->range;
    const auto within =
        builder.node(NodeRole::State, bound(variable->min) + " … " + bound(variable->max), range,
                     {"every move is allowed"});
    begin({within});
    if (!forbidden) return;
    const auto outside = builder.node(NodeRole::Error, "outside", range, {"stays at the bound"});
    builder.edge({within, outside, EdgeRole::Forbidden, {}, {}});
  }

  void begin(const std::vector<std::size_t>& firsts) {
    const auto start = builder.node(NodeRole::Start, {}, initRange());
    const auto label = variable->isNatural() ? builder.text(initRange()) : std::string();
    for (const auto first : firsts)
      builder.edge({start, first, EdgeRole::Next, label, builder.source(initRange())});
  }

  [[nodiscard]] syntax::Range initRange() const {
    const auto init = variable->initRange();
    return init.empty() ? variable->name.range : init;
  }

  void drawStates(bool forbidden) {
    const auto& states = variable->states;
    for (const auto& state : states)
      builder.node(NodeRole::State, std::string(state.text), state.range);
    std::vector<std::size_t> firsts;
    const auto add = [&](const syntax::Expr& init) {
      const auto initial = std::ranges::find(states, init.name.text, &syntax::Name::text);
      if (initial != states.end())
        firsts.push_back(static_cast<std::size_t>(initial - states.begin()));
    };
    add(variable->init);
    for (const auto& other : variable->otherInits) add(other);
    if (!firsts.empty()) begin(firsts);
    if (variable->transitionsKind != syntax::Transitions::Listed)
      builder.graph.note = "every move is allowed";
    for (std::size_t from = 0; from < states.size(); ++from)
      for (std::size_t to = from + 1; to < states.size(); ++to) drawMoves(from, to, forbidden);
    // a circle shows dense moves best, unless the values form a line
    if (states.size() > 2 && builder.graph.edges.size() > states.size())
      builder.graph.layout = Layout::Circular;
  }

  [[nodiscard]] bool isAllowed(std::size_t from, std::size_t to) const {
    const auto& states = variable->states;
    return variable->transitionsKind != syntax::Transitions::Listed ||
           allowed.contains({states[from].text, states[to].text});
  }

  /// Draws the moves between two states, as one edge with two heads if both moves are alike.
  void drawMoves(std::size_t a, std::size_t b, bool forbidden) {
    const bool there = isAllowed(a, b);
    const bool back = isAllowed(b, a);
    if (there == back) {
      if (there || forbidden) drawMove(a, b, there, true);
      return;
    }
    if (there || forbidden) drawMove(a, b, there, false);
    if (back || forbidden) drawMove(b, a, back, false);
  }

  void drawMove(std::size_t from, std::size_t to, bool allows, bool twoWay) {
    const auto role = allows ? EdgeRole::Next : EdgeRole::Forbidden;
    builder.edge({from, to, role, {}, moveSource(from, to), twoWay});
  }

  /// The source range of a declared move.
  [[nodiscard]] std::optional<Source> moveSource(std::size_t from, std::size_t to) const {
    for (const auto& listed : variable->transitions)
      if (listed.from.text == variable->states[from].text &&
          listed.to.text == variable->states[to].text)
        return builder.source(listed.range);
    return std::nullopt;
  }

  const VariableDefinition& variable;
  Builder builder;
  std::set<Move> allowed;
};

} // namespace

Graph drawStateVariable(const analysis::Program& program, const VariableDefinition& variable,
                        bool forbidden) {
  return StateVariablePicture(program, variable).draw(forbidden);
}

} // namespace proskill::viz
