#include "codegen/plan/plan.h"

#include "codegen/plan/walk_expressions.h"
#include "syntax/text/quote.h"

#include <algorithm>
#include <vector>

namespace proskill::codegen {
namespace {

using analysis::Program;
using syntax::StatementKind;
using SkillDefinition = analysis::Definition<syntax::Skill>;

GenerationError ambiguous(const std::vector<const SkillDefinition*>& candidates) {
  std::string names;
  for (const auto* candidate : candidates)
    names += (names.empty() ? "" : ", ") + syntax::backquoted(candidate->name());
  return {"several skills could be the mission: " + names,
          candidates[0]->at((*candidates[0])->name.range)};
}

/// Null if the program is a library of skills.
std::expected<const SkillDefinition*, GenerationError> chooseMission(const Program& program,
                                                                     const Options& options) {
  if (options.mainSkill.empty()) {
    const auto main = analysis::mainSkill(program);
    if (!main.skill && main.candidates.size() > 1)
      return std::unexpected(ambiguous(main.candidates));
    return main.skill;
  }
  const auto* skill = program.skills.find(options.mainSkill);
  if (!skill)
    return std::unexpected(GenerationError{
        "there is no skill " + syntax::backquoted(options.mainSkill) + " to be the mission", {}});
  if (!(*skill)->isComposite())
    return std::unexpected(GenerationError{syntax::backquoted(options.mainSkill) +
                                               " is a basic skill; a mission is a composite one",
                                           skill->at((*skill)->name.range)});
  return skill;
}

/// Calls `visit(automaton, statement)` for each statement that has a state, including those in
/// branches.
template <class Visit> void forEachStep(const BodyAutomaton& body, Visit&& visit) {
  forEachThread(body, [&](const BodyAutomaton& thread) {
    for (const auto& state : thread.states)
      if (state.statement) visit(thread, *state.statement);
  });
}

/// The names of all composite skills that may run when those of `roots` run.
std::set<std::string_view> reachable(const Program& program,
                                     std::vector<const SkillDefinition*> roots) {
  std::set<std::string_view> found;
  while (!roots.empty()) {
    const auto* skill = roots.back();
    roots.pop_back();
    if (!skill || !(*skill)->isComposite() || !found.insert(skill->name()).second) continue;
    analysis::forEachStatement(*(*skill)->body, [&](const syntax::Statement& statement) {
      if (statement.kind == StatementKind::Call)
        roots.push_back(program.skills.find(statement.head.text));
    });
  }
  return found;
}

class Planner {
public:
  Planner(const Program& program, const SkillDefinition* mission)
      : program(program), mission(mission) {}

  GenerationPlan make() {
    addSkills();
    addEnvironment();
    for (const auto& skill : plan.skills)
      if (skill.body) noteCalls(*skill.body);
    noteBranchEnds();
    noteStops();
    noteHoldOuts();
    noteResults();
    noteInputs();
    plan.ownOutcomes = OwnOutcomes(plan);
    return std::move(plan);
  }

private:
  void addSkills() {
    std::vector<const SkillDefinition*> roots{mission};
    for (const auto& skill : program.skills.all)
      if (skill->monitor) roots.push_back(&skill);
    const auto composites = reachable(program, roots);
    for (const auto& skill : program.skills.all)
      if (!skill->isComposite()) add(skill);
    for (const auto& skill : program.skills.all)
      if (skill->isComposite() && composites.contains(skill.name())) add(skill);
  }

  void add(const SkillDefinition& skill) {
    auto& added = plan.skills.emplace_back();
    added.definition = &skill;
    added.root = &skill == mission || (skill->isComposite() && skill->monitor);
    added.generalCaller = !mission && !skill->isComposite();
    if (skill->isComposite()) added.body = bodyAutomaton(*skill->body, skill.name());
    if (&skill == mission) plan.mission = &added;
  }

  void addEnvironment() {
    if (program.environments.all.empty()) return;
    plan.environment = &program.environments.all[0];
    plan.environmentBody = bodyAutomaton((*plan.environment)->body, plan.environment->name());
  }

  SkillPlan* find(std::string_view name) {
    const auto found = std::ranges::find(plan.skills, name, &SkillPlan::name);
    return found == plan.skills.end() ? nullptr : &*found;
  }

  void noteCalls(const BodyAutomaton& body) {
    forEachStep(body, [&](const BodyAutomaton& thread, const syntax::Statement& statement) {
      if (statement.kind == StatementKind::Call)
        find(statement.head.text)->callers.insert(thread.name);
      else if (statement.kind == StatementKind::Interrupt)
        noteInterrupt(statement.name.text);
    });
  }

  void noteInterrupt(std::string_view name) {
    auto* skill = find(name);
    if (skill && skill->skill().interrupt) skill->mayBeInterrupted = true;
  }

  void noteBranchEnds() {
    for (auto& skill : plan.skills) {
      if (!skill.body) continue;
      forEachStep(*skill.body,
                  [&](const BodyAutomaton& thread, const syntax::Statement& statement) {
                    const bool ends = statement.kind == StatementKind::Success ||
                                      statement.kind == StatementKind::Failure;
                    if (ends && !thread.path.empty()) skill.branchEnds = true;
                  });
    }
  }

  /// Notes who can be stopped: a skill that is stopped stops what it called. Repeated until nothing
  /// changes.
  void noteStops() {
    bool changed = true;
    while (changed) {
      changed = false;
      for (const auto& skill : plan.skills)
        if (skill.body) changed |= noteStopsOf(skill);
    }
  }

  bool noteStopsOf(const SkillPlan& skill) {
    bool changed = false;
    forEachStep(*skill.body, [&](const BodyAutomaton& thread, const syntax::Statement& statement) {
      if (statement.kind != StatementKind::Call) return;
      if (!skill.mayStrike(thread)) return;
      auto& callee = *find(statement.head.text);
      changed |= !callee.callerMayStop;
      callee.callerMayStop = true;
    });
    return changed;
  }

  /// Notes the skills that must not be stopped, and all their callers.
  void noteHoldOuts() {
    auto& all = plan.holdOuts;
    for (const auto& skill : plan.skills)
      if (skill.skill().unstoppable) all.insert(skill.name());
    for (std::size_t before = 0; before != all.size();) {
      before = all.size();
      for (const auto& skill : plan.skills)
        if (skill.body)
          forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
            if (waitsForHoldOut(thread)) all.insert(thread.name);
          });
    }
    for (auto& skill : plan.skills)
      if (skill.body)
        forEachThread(*skill.body, [&](const BodyAutomaton& thread) {
          skill.callsHoldOut |= waitsForHoldOut(thread);
        });
  }

  [[nodiscard]] bool waitsForHoldOut(const BodyAutomaton& thread) const {
    return std::ranges::any_of(thread.states, [&](const BodyState& state) {
      if (!state.statement) return false;
      const bool calls = state.statement->kind == StatementKind::Call &&
                         plan.holdOuts.contains(state.statement->head.text);
      return calls || std::ranges::any_of(state.branches, [&](const BodyAutomaton& branch) {
               return plan.holdOuts.contains(branch.name);
             });
    });
  }

  void noteResults() {
    forEachExpression(program, [&](const syntax::Expr& expr) {
      if (expr.kind != syntax::ExprKind::Access || expr.member.text != "res") return;
      if (auto* skill = find(expr.name.text)) skill->resultIsRead = true;
    });
  }

  /// Notes the inputs that matter. Repeated until nothing changes, since skills pass them on.
  void noteInputs() {
    for (auto& skill : plan.skills)
      forEachExpression(skill.skill(), [&](const syntax::Expr& expr) { noteInput(skill, expr); });
    bool changed = true;
    while (changed) {
      changed = false;
      for (auto& skill : plan.skills)
        if (skill.body) changed |= notePassedInputs(skill);
    }
  }

  bool notePassedInputs(SkillPlan& skill) {
    bool changed = false;
    forEachStep(*skill.body, [&](const BodyAutomaton&, const syntax::Statement& statement) {
      if (statement.kind != StatementKind::Call) return;
      const auto& callee = *find(statement.head.text);
      for (const auto& argument : statement.arguments)
        if (std::ranges::any_of(callee.inputs, [&](const syntax::Input* input) {
              return input->name.text.substr(1) == argument.name.text;
            }))
          changed |= noteInput(skill, argument.value);
    });
    return changed;
  }

  /// \return whether the expression is an input that was not noted
  static bool noteInput(SkillPlan& skill, const syntax::Expr& expr) {
    if (expr.kind != syntax::ExprKind::Parameter) return false;
    const auto& all = skill.skill().inputs;
    const auto input = std::ranges::find_if(
        all, [&](const syntax::Input& each) { return each.name.text == expr.name.text; });
    if (input == all.end()) return false;
    if (std::ranges::find(skill.inputs, &*input) != skill.inputs.end()) return false;
    skill.inputs.push_back(&*input);
    return true;
  }

  const Program& program;
  const SkillDefinition* mission;
  GenerationPlan plan;
};

} // namespace

const SkillPlan* GenerationPlan::find(std::string_view name) const {
  const auto found = std::ranges::find(skills, name, &SkillPlan::name);
  return found == skills.end() ? nullptr : &*found;
}

bool GenerationPlan::hasGeneralCaller() const {
  return std::ranges::any_of(skills, &SkillPlan::generalCaller);
}

std::expected<GenerationPlan, GenerationError> makeGenerationPlan(const Program& program,
                                                                  const Options& options) {
  const auto mission = chooseMission(program, options);
  if (!mission) return std::unexpected(mission.error());
  auto plan = Planner(program, *mission).make();
  for (auto& skill : plan.skills) skill.isMeasured = options.edition == Edition::Executed;
  return plan;
}

} // namespace proskill::codegen
