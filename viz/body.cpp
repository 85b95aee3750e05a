#include "viz/builder.h"

#include "syntax/tree/statements.h"

#include <algorithm>
#include <map>
#include <utility>

namespace proskill::viz {
namespace {

using syntax::Statement;
using syntax::StatementKind;

void append(Exits& exits, Exits more) {
  exits.insert(exits.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

/// Draws the statements of a body as a flow chart.
class BodyPicture {
public:
  /// \param owner the skill whose outcomes may end the body; null for an environment
  BodyPicture(Builder& made, const syntax::Skill* owner) : builder(made), skill(owner) {}

  /// Draws a body or a branch with its own labels. \return the edges that leave its end
  Exits drawScope(const syntax::Block& block, Exits in) {
    scopes.emplace_back();
    auto out = drawBlock(block, std::move(in));
    for (auto& jump : scopes.back().jumps) {
      const auto target = scopes.back().labels.find(jump.label);
      if (target != scopes.back().labels.end())
        builder.connect({{jump.from, jump.role, "goto " + jump.label, jump.source}},
                        target->second);
    }
    scopes.pop_back();
    return out;
  }

private:
  struct Scope {
    std::map<std::string, std::size_t> labels;
    Exits jumps; ///< labelled with their destination
  };

  Exits drawBlock(const syntax::Block& block, Exits in) {
    for (const auto& statement : block.statements) in = draw(statement, in);
    return in;
  }

  Exits draw(const Statement& s, const Exits& in) {
    switch (s.kind) {
    case StatementKind::Unknown: return in;
    case StatementKind::Call: return drawCall(s, in);
    case StatementKind::Interrupt:
      return step(s, in, NodeRole::Interrupt, "interrupt " + name(s.name), {});
    case StatementKind::WaitCondition: return drawWait(s, in);
    case StatementKind::WaitTime:
      return step(s, in, NodeRole::Wait, "wait " + builder.seconds(s.duration), {});
    case StatementKind::If: return drawIf(s, in);
    case StatementKind::Case: return drawCase(s, in);
    case StatementKind::While: return drawWhile(s, in);
    case StatementKind::DoUntil: return drawDoUntil(s, in);
    case StatementKind::Break: return drawBreak(in);
    case StatementKind::Label: return drawLabel(s, in);
    case StatementKind::Goto: return drawGoto(s, in);
    case StatementKind::Parallel:
    case StatementKind::Race: return drawParallel(s, in);
    case StatementKind::Set: return step(s, in, NodeRole::Step, "set", builder.effects(s.effects));
    case StatementKind::Printf:
      return step(s, in, NodeRole::Message, "“" + name(s.format) + "”", {});
    case StatementKind::Success:
      return drawEnd(s, in, NodeRole::Success, skill ? &skill->successes : nullptr);
    case StatementKind::Failure:
      return drawEnd(s, in, NodeRole::Failure, skill ? &skill->failures : nullptr);
    case StatementKind::Emit: return step(s, in, NodeRole::Event, name(s.name), {});
    case StatementKind::Choose: return drawChoose(s, in);
    }
    return in;
  }

  static std::string name(const syntax::Name& word) { return std::string(word.text); }

  Exits step(const Statement& s, const Exits& in, NodeRole role, std::string label,
             std::vector<std::string> details) {
    return builder.then(in, builder.node(role, std::move(label), s.range, std::move(details)));
  }

  Exits drawWait(const Statement& s, const Exits& in) {
    auto out = step(s, in, NodeRole::Wait, "until " + builder.text(s.condition.range),
                    builder.effects(s.effects));
    if (!syntax::hasTimeout(s)) return out;
    const auto label = "after " + builder.seconds(s.duration);
    append(out, drawBlock(s.branches[0], {{out[0].from, EdgeRole::Next, label, {}}}));
    return out;
  }

  Exits drawCall(const Statement& s, const Exits& in) {
    std::string arguments;
    for (const auto& argument : s.arguments)
      arguments += (arguments.empty() ? "" : " ") + name(argument.name) + " " +
                   builder.text(argument.value.range);
    std::vector<std::string> details;
    if (!arguments.empty()) details.push_back(arguments);
    return step(s, in, NodeRole::Call, name(s.name), details);
  }

  std::size_t test(const syntax::Expr& condition, syntax::Range range) {
    return builder.node(NodeRole::Test, builder.text(condition.range), range);
  }

  static Exit yes(std::size_t node) { return {node, EdgeRole::Yes, "yes", {}}; }
  static Exit no(std::size_t node) { return {node, EdgeRole::No, "no", {}}; }

  Exits drawIf(const Statement& s, Exits in) {
    Exits out;
    for (const auto& arm : s.arms) {
      if (!arm.condition) {
        append(out, drawBlock(arm.body, in));
        return out;
      }
      const auto node = test(*arm.condition, arm.condition->range);
      builder.connect(in, node);
      append(out, drawBlock(arm.body, {yes(node)}));
      in = {no(node)};
    }
    append(out, in);
    return out;
  }

  /// Draws a call with an edge for each arm.
  Exits drawCase(const Statement& s, const Exits& in) {
    const auto* call = syntax::callOf(s);
    const auto called = call ? drawCall(*call, in) : in;
    Exits out;
    for (const auto& arm : s.arms) {
      Exits when;
      for (const auto& exit : called)
        when.push_back({exit.from, exit.role, builder.text(arm.pattern.range), {}});
      append(out, drawBlock(arm.body, when));
    }
    return out;
  }

  Exits drawWhile(const Statement& s, const Exits& in) {
    const auto node = test(s.condition, s.condition.range);
    builder.connect(in, node);
    auto [end, out] = drawLoop(s, {yes(node)});
    builder.connect(end, node);
    if (s.condition.kind != syntax::ExprKind::True) out.push_back(no(node));
    return std::move(out);
  }

  Exits drawDoUntil(const Statement& s, const Exits& in) {
    const auto head = builder.node(NodeRole::Junction, {}, s.head.range);
    builder.connect(in, head);
    auto [end, out] = drawLoop(s, {{.from = head}});
    const auto node = test(s.condition, s.condition.range);
    builder.connect(end, node);
    builder.connect({no(node)}, head);
    out.push_back(yes(node));
    return std::move(out);
  }

  /// Draws the body of a loop. \return the edges from its end, and those of its breaks
  std::pair<Exits, Exits> drawLoop(const Statement& s, const Exits& in) {
    breaks.emplace_back();
    auto end = s.branches.empty() ? in : drawBlock(s.branches[0], in);
    auto out = std::move(breaks.back());
    breaks.pop_back();
    return {std::move(end), std::move(out)};
  }

  Exits drawBreak(const Exits& in) {
    if (!breaks.empty()) append(breaks.back(), in);
    return {};
  }

  Exits drawLabel(const Statement& s, const Exits& in) {
    auto out = step(s, in, NodeRole::Label, name(s.name), {});
    scopes.back().labels.emplace(name(s.name), out[0].from);
    return out;
  }

  Exits drawGoto(const Statement& s, const Exits& in) {
    for (const auto& exit : in)
      scopes.back().jumps.push_back({exit.from, exit.role, name(s.name), builder.source(s.range)});
    return {};
  }

  Exits drawParallel(const Statement& s, const Exits& in) {
    const auto fork = builder.node(NodeRole::Fork, {}, s.head.range);
    builder.connect(in, fork);
    Exits out;
    for (std::size_t i = 0; i < s.branches.size(); ++i) {
      builder.enterCluster("branch " + std::to_string(i + 1), s.branches[i].range, i > 0);
      auto ends = drawScope(s.branches[i], {{.from = fork}});
      if (s.kind == StatementKind::Race)
        for (auto& end : ends) end.label += end.label.empty() ? "first" : ", first";
      append(out, std::move(ends));
      builder.leaveCluster();
    }
    return builder.then(out, builder.node(NodeRole::Join, {}, s.head.range));
  }

  Exits drawEnd(const Statement& s, const Exits& in, NodeRole role,
                const syntax::List<syntax::Outcome>* outcomes) {
    std::vector<std::string> details;
    if (outcomes) {
      const auto same = [&](const syntax::Outcome& o) { return o.tag.text == s.name.text; };
      const auto declared = std::ranges::find_if(*outcomes, same);
      if (declared != outcomes->end()) details = outcomeLines(*declared);
    }
    step(s, in, role, name(s.name), details);
    return {};
  }

  [[nodiscard]] std::vector<std::string> outcomeLines(const syntax::Outcome& outcome) const {
    auto lines = builder.effects(outcome.effects);
    if (outcome.postcondition)
      lines.push_back("then " + builder.text(outcome.postcondition->range));
    return lines;
  }

  Exits drawChoose(const Statement& s, const Exits& in) {
    const auto node = builder.node(NodeRole::Test, "choose", s.head.range);
    builder.connect(in, node);
    Exits out;
    for (const auto& branch : s.branches) append(out, drawBlock(branch, {{.from = node}}));
    return out;
  }

  Builder& builder;
  const syntax::Skill* skill;
  std::vector<Scope> scopes;
  std::vector<Exits> breaks;
};

/// The last byte of a block, where its end is reached.
syntax::Range endOf(const syntax::Block& block) {
  const auto end = block.range.end;
  return {end == 0 ? 0 : end - 1, end};
}

/// Draws the watchdog of a composite skill. Without a lower bound it is in time from the start,
/// without an upper bound for ever.
void drawWatchdog(Builder& builder, const syntax::Interval& interval) {
  const auto range = interval.range;
  const auto fails = [&](std::size_t from, std::string when, std::string how) {
    const auto error = builder.node(NodeRole::Error, std::move(how), range);
    builder.edge({from, error, EdgeRole::Forbidden, std::move(when), {}});
  };
  builder.enterCluster("watchdog " + builder.seconds(interval), range);
  Exits in{{.from = builder.node(NodeRole::Start, {}, range), .label = "starts"}};
  std::optional<std::size_t> early;
  if (interval.lower != syntax::Rational{} || interval.lowerOpen) {
    early = builder.node(NodeRole::State, "early", range);
    builder.connect(in, *early);
    in = {{.from = *early, .label = toString(interval.lower) + " s"}};
  }
  const auto onTime = builder.node(NodeRole::State, "on time", range);
  builder.connect(in, onTime);
  builder.edge({onTime, builder.node(NodeRole::End, "in time", range), EdgeRole::Next, "ends", {}});
  if (early) fails(*early, "ends", "undershoot");
  if (interval.upper) fails(onTime, "after " + toString(*interval.upper) + " s", "overshoot");
  builder.leaveCluster();
}

/// Draws what may end a composite skill in any state.
void drawWatched(Builder& builder, const syntax::Skill& skill) {
  if (skill.invariants.empty() && !skill.interrupt) return;
  builder.enterCluster("at any time", skill.name.range);
  for (const auto& invariant : skill.invariants) {
    auto lines = builder.effects(invariant.effects);
    lines.insert(lines.begin(), "fails: " + builder.text(invariant.guard.range));
    builder.node(NodeRole::Invariant, std::string(invariant.tag.text), invariant.range, lines);
  }
  if (skill.interrupt)
    builder.node(NodeRole::Interrupt, "interrupted", skill.interrupt->range,
                 builder.effects(skill.interrupt->effects));
  builder.leaveCluster();
}

/// A monitor that is always armed waits for its precondition again after each end of its body.
void drawRearming(Builder& builder, const syntax::Skill& skill) {
  if (!skill.armed || skill.preconditions.empty()) return;
  const auto& nodes = builder.graph.nodes;
  const auto wait = std::ranges::find(nodes, NodeRole::Wait, &Node::role); // the first of all
  const auto waits = static_cast<std::size_t>(wait - nodes.begin());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].role == NodeRole::Success || nodes[i].role == NodeRole::Failure)
      builder.edge({i, waits, EdgeRole::Next, "once it is false", {}});
}

} // namespace

Graph drawBody(const analysis::Program& program, const SkillDefinition& skill) {
  Builder builder(program, skill.file);
  builder.graph.title = (skill->monitor ? "monitor " : "skill ") + std::string(skill.name());
  if (skill->monitor)
    builder.graph.note = skill->armed ? "starts whenever its precondition begins to hold"
                                      : "started with the program";
  if (skill->unstoppable && !skill->monitor) builder.graph.note = "is never stopped once it runs";
  const auto& body = *skill->body;
  const auto out =
      BodyPicture(builder, &skill.node()).drawScope(body, drawBeginning(builder, skill));
  if (!out.empty())
    builder.connect(out,
                    builder.node(NodeRole::Success, "success", endOf(body), {"end of the body"}));
  drawRearming(builder, skill.node());
  drawWatched(builder, skill.node());
  if (skill->timeInterval) drawWatchdog(builder, *skill->timeInterval);
  return std::move(builder.graph);
}

Graph drawEnvironment(const analysis::Program& program,
                      const analysis::Definition<syntax::Environment>& environment) {
  Builder builder(program, environment.file);
  builder.graph.title = "environment " + std::string(environment.name());
  const auto start = builder.node(NodeRole::Start, {}, environment->name.range);
  const auto& body = environment->body;
  const auto out = BodyPicture(builder, nullptr).drawScope(body, {{.from = start}});
  if (!out.empty()) builder.connect(out, builder.node(NodeRole::End, "ends", endOf(body)));
  return std::move(builder.graph);
}

} // namespace proskill::viz
