#include "viz/builder.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace proskill::viz {
namespace {

using syntax::Statement;
using syntax::StatementKind;

class CallsPicture {
public:
  explicit CallsPicture(const analysis::Program& shown)
      : program(shown), main(analysis::mainSkill(shown).skill) {}

  Graph draw() {
    graph.title = "who calls whom";
    const auto& skills = program.skills.all;
    for (const auto& skill : skills) {
      const Builder builder(program, skill.file);
      graph.nodes.push_back({role(skill),
                             std::string(skill.name()),
                             details(builder, skill),
                             builder.source(skill->name.range),
                             {}});
    }
    for (std::size_t i = 0; i < skills.size(); ++i)
      if (skills[i]->body) collect(i, *skills[i]->body);
    for (auto& [key, use] : uses) addEdge(std::get<0>(key), use);
    return std::move(graph);
  }

private:
  struct Use {
    std::size_t to = 0;
    StatementKind kind = StatementKind::Call;
    std::size_t count = 0;
    Source first;
  };

  [[nodiscard]] NodeRole role(const SkillDefinition& skill) const {
    if (main && skill.form == main->form) return NodeRole::Mission;
    if (skill->monitor) return NodeRole::Monitor;
    return skill->isComposite() ? NodeRole::Composite : NodeRole::Basic;
  }

  static std::vector<std::string> details(const Builder& builder, const SkillDefinition& skill) {
    if (!skill->timeInterval) return {};
    return {builder.seconds(*skill->timeInterval)};
  }

  void collect(std::size_t from, const syntax::Block& block) {
    for (const auto& statement : block.statements) {
      if (statement.kind == StatementKind::Call || statement.kind == StatementKind::Interrupt)
        note(from, statement);
      for (const auto& branch : statement.branches) collect(from, branch);
      for (const auto& arm : statement.arms) collect(from, arm.body);
    }
  }

  void note(std::size_t from, const Statement& statement) {
    const auto* callee = program.skills.find(statement.name.text);
    if (!callee) return;
    const auto to = static_cast<std::size_t>(callee - program.skills.all.data());
    auto& use = uses[{from, to, statement.kind}];
    if (use.count++ == 0)
      use = {to, statement.kind, 1,
             Builder(program, program.skills.all[from].file).source(statement.range)};
  }

  void addEdge(std::size_t from, const Use& use) {
    const auto edgeRole = use.kind == StatementKind::Call ? EdgeRole::Calls : EdgeRole::Interrupts;
    const auto label = use.count > 1 ? "×" + std::to_string(use.count) : std::string();
    graph.edges.push_back({from, use.to, edgeRole, label, use.first});
  }

  const analysis::Program& program;
  const SkillDefinition* main;
  Graph graph;
  std::map<std::tuple<std::size_t, std::size_t, StatementKind>, Use> uses;
};

} // namespace

Graph drawCalls(const analysis::Program& program) { return CallsPicture(program).draw(); }

} // namespace proskill::viz
