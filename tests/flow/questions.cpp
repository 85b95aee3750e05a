#include "tests/flow/questions.h"

#include "syntax/diagnostics/codes.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::test {

namespace {

using namespace analysis::flow;
using syntax::Code;
using syntax::Diagnostic;

class Questions {
public:
  explicit Questions(const Report& report) : report(report) {}

  std::vector<Query> all(const std::vector<Diagnostic>& found) {
    askAboutValues();
    askAboutPairs();
    askAboutEvents();
    askAboutResources();
    for (const Diagnostic& each : found) askAbout(each);
    return std::move(queries);
  }

private:
  void ask(const std::string& condition, bool possible) {
    queries.push_back({condition, possible});
  }

  void askAboutValues() {
    const Variables& variables = report.variables();
    for (VariableId id = 0; id < variables.size(); ++id) {
      forEachValue(id, [&](unsigned value, const std::string& condition) {
        ask(condition, report.solver.ever(id).contains(value));
        if (variables[id].kind == VariableKind::StateVariable) askInside(id, value, condition);
      });
    }
    askAtLabels();
  }

  template <class Visit> void forEachValue(VariableId id, Visit visit) {
    const Variable& variable = report.variables()[id];
    if (variable.kind == VariableKind::Called || variable.kind == VariableKind::Used) return;
    for (unsigned value = 0; value < variable.domain.size(); ++value)
      visit(value, fmt::format("(= {} {})", report.variables().name(id),
                               report.variables().words(id, ValueSet::of(value))));
  }

  /// While a skill is running.
  void askInside(VariableId id, unsigned value, const std::string& condition) {
    const System& system = report.system();
    for (std::size_t skill = 0; skill < report.program.skills.all.size(); ++skill) {
      const Process& process = system[system.ofSkill(skill)];
      auto slot = process.slots.find(id);
      if (!process.analysed || !slot) continue;
      bool possible = false;
      for (NodeId node = 0; node < process.graph->nodes.size(); ++node) {
        NodeKind kind = (*process.graph)[node].kind;
        if (kind == NodeKind::Start || kind == NodeKind::End || kind == NodeKind::Refused) continue;
        State state = report.solver.during(system.ofSkill(skill), node);
        possible |= state.reachable && state.values[*slot].contains(value);
      }
      ask(fmt::format("(and (running {}) {})", report.program.skills.all[skill].name(), condition),
          possible);
    }
  }

  void askAtLabels() {
    forEachNode(report, [&](ProcessId id, const Process& process, NodeId node, const Node& each) {
      if (!each.statement || each.statement->kind != syntax::StatementKind::Label) return;
      if (report.index.symbols().labels(each.statement->name.text).size() != 1) return;
      const std::vector<NodeId> places = placesOf(*process.graph, node);
      if (places.size() == 2) askWhatFollows(id, node, places.back());
      for (Slot slot = 0; slot < process.slots.size(); ++slot)
        if (!hasOwnOutcome(process, process.slots[slot]))
          forEachValue(process.slots[slot], [&](unsigned value, const std::string& condition) {
            bool possible = false;
            for (NodeId at : places) {
              State state = report.solver.during(id, at);
              possible |= state.reachable && state.values[slot].contains(value);
            }
            ask(fmt::format("(and (at {}) {})", each.statement->name.text, condition), possible);
          });
    });
  }

  /// Whether the body reads the outcome of its own last call, and a property that of the last call
  /// by anybody: several threads call the skill.
  [[nodiscard]] bool hasOwnOutcome(const Process& process, VariableId id) const {
    const Variable& variable = report.variables()[id];
    if (variable.kind != VariableKind::Status && variable.kind != VariableKind::Result)
      return false;
    const System& system = report.system();
    const ProcessId skill = system.ofSkill(variable.definition);
    const auto& sites = system.callers(skill);
    const auto isMine = [&](const Site& site) {
      return system[site.caller].definition == process.definition;
    };
    const auto isOther = [&](const Site& site) { return site.caller != sites.front().caller; };
    return std::ranges::any_of(sites, isMine) &&
           (system[skill].root || std::ranges::any_of(sites, isOther));
  }

  /// A property cannot read the inputs of a skill.
  [[nodiscard]] static bool readsInput(const syntax::Expr& expr) {
    return expr.kind == syntax::ExprKind::Parameter ||
           std::ranges::any_of(expr.operands, readsInput);
  }

  [[nodiscard]] bool readsOwnOutcome(const Process& process, const syntax::Expr& condition) const {
    std::vector<VariableId> reads;
    report.system().resolver().addReads(condition, reads);
    return std::ranges::any_of(reads, [&](VariableId id) { return hasOwnOutcome(process, id); });
  }

  /// Adjacent labels and the statement after them: one place in the model.
  static std::vector<NodeId> placesOf(const Graph& graph, NodeId label) {
    std::vector<NodeId> places{label};
    auto isLabel = [&](NodeId node) {
      const syntax::Statement* statement = graph[node].statement;
      return statement && statement->kind == syntax::StatementKind::Label;
    };
    while (isLabel(places.back())) places.push_back(graph[places.back()].edges.front().target);
    return places;
  }

  /// A label and the statement after it: the same may be true at both.
  void askWhatFollows(ProcessId id, NodeId label, NodeId next) {
    const Process& process = report.system()[id];
    const Node& node = (*process.graph)[next];
    const std::string here = fmt::format("(at {})", (*process.graph)[label].statement->name.text);
    const bool tests = node.kind == NodeKind::Wait || node.kind == NodeKind::Test;
    if (tests && !readsInput(*node.conditions.front()) &&
        !readsOwnOutcome(process, *node.conditions.front())) {
      const Condition& condition = process.actions[next].conditions.front();
      const std::string words = textAt(node.conditions.front()->range);
      bool holds = false;
      bool fails = false;
      for (NodeId at : {label, next}) {
        holds |= report.solver.mayHold(id, at, condition);
        fails |= report.solver.mayFail(id, at, condition);
      }
      ask(fmt::format("(and {} {})", here, words), holds);
      ask(fmt::format("(and {} (not {}))", here, words), fails);
    }
    ProcessId target = process.actions[next].target;
    if (node.kind != NodeKind::Interrupt || target == kNoProcess) return;
    const std::size_t skill = report.system()[target].definition;
    auto slot = process.slots.find(report.variables().of(VariableKind::Called, skill));
    bool runs = !slot;
    for (NodeId at : {label, next})
      if (slot && report.solver.reachable(id, at))
        runs |= report.solver.before(id, at).values[*slot].contains(1);
    ask(fmt::format("(and {} (running {}))", here, report.program.skills.all[skill].name()), runs);
  }

  /// Whether two skills may run at once.
  void askAboutPairs() {
    const System& system = report.system();
    for (std::size_t i = 0; i < report.program.skills.all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        ProcessId a = system.ofSkill(i);
        ProcessId b = system.ofSkill(j);
        bool calls = system.activity(a).contains(b) || system.activity(b).contains(a);
        bool beside = system.concurrent(a).contains(b) && !system.exclusive(a).contains(b) &&
                      !system.exclusive(b).contains(a);
        ask(fmt::format("(and (running {}) (running {}))", report.program.skills.all[i].name(),
                        report.program.skills.all[j].name()),
            calls || beside);
      }
  }

  /// What a diagnostic claims never to happen.
  void askAbout(const Diagnostic& claim) {
    const auto words = quoted(claim.message);
    if (claim.code == Code::ImpossibleStatus)
      ask(fmt::format("(= {}.status {})", words[0], words[1]), false);
    if (claim.code == Code::ResourceHeldByCaller && words.size() == 3)
      ask(fmt::format("(and (running {}) (running {}))", words[1], words[2]), false);
    if (claim.code == Code::ContradictoryPreconditions)
      ask(fmt::format("(running {})", words[1]), false);
  }

  /// Whether an event ever occurs.
  void askAboutEvents() {
    std::set<std::string_view> emitted;
    forEachReachedNode(report, [&](ProcessId, const Process&, NodeId, const Node& node) {
      if (node.kind == NodeKind::Emit) emitted.insert(node.statement->name.text);
    });
    for (const auto& event : report.program.events.all)
      ask(fmt::format("(occurs {})", event.name()),
          report.system().hasFreeEvents() || emitted.contains(event.name()));
  }

  /// How many have taken a resource at once.
  void askAboutResources() {
    for (std::size_t i = 0; i < report.program.resources.all.size(); ++i) {
      const VariableId id = report.variables().of(VariableKind::Used, i);
      const ValueSet ever = report.solver.ever(id);
      for (unsigned value = 0; value < report.variables()[id].domain.size(); ++value) {
        const std::string words = report.variables().words(id, ValueSet::of(value));
        if (words.find_first_not_of("0123456789") != std::string::npos) continue;
        const std::string name = fmt::format("{}_used", report.program.resources.all[i].name());
        queries.push_back({name + " is " + words, ever.contains(value), name, std::stoll(words)});
      }
    }
  }

  [[nodiscard]] std::string textAt(syntax::Range range) const {
    return report.program.files[0].document.text().substr(range.begin, range.length());
  }

  const Report& report;
  std::vector<Query> queries;
};

} // namespace

std::vector<Query> questionsOf(const Report& report, const std::vector<Diagnostic>& found) {
  return Questions(report).all(found);
}

std::vector<std::string> quoted(const std::string& message) {
  std::vector<std::string> words;
  for (std::size_t at = message.find('`'); at != std::string::npos;
       at = message.find('`', at + 1)) {
    std::size_t end = message.find('`', at + 1);
    words.push_back(message.substr(at + 1, end - at - 1));
    at = end;
  }
  return words;
}

} // namespace proskill::test
