#include "bridge/bt/emit/emit.h"

#include "bridge/bt/emit/elements.h"
#include "bridge/bt/emit/statements.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <tuple>

namespace proskill::bridge::bt {
namespace {

using analysis::Definition;
using Json = nlohmann::ordered_json;

/// What is called `skill`, or the mission.
const Definition<syntax::Skill>* missionOf(Draft& draft, std::string_view skill) {
  const auto* found =
      skill.empty() ? analysis::mainSkill(draft.program).skill : draft.program.skills.find(skill);
  if (found && (*found)->isComposite()) return found;
  draft.errors.push_back({{draft.program.files.front().path},
                          skill.empty() ? "there is no mission, or several: name one with `--main`"
                                        : fmt::format("`{}` is not a composite skill", skill)});
  return nullptr;
}

/// In the order of the text; statements are translated in another one.
Errors sorted(Errors errors) {
  std::ranges::stable_sort(errors, {}, [](const Error& error) {
    return std::tuple(error.place.file, error.place.line, error.place.column);
  });
  return errors;
}

class TreeWriter {
public:
  explicit TreeWriter(Draft& draft)
      : draft(draft), conditions(draft), calls(draft), loops(draft.program) {}

  Element document(const Definition<syntax::Skill>& mission) {
    auto root =
        element("root", {{"BTCPP_format", "4"}, {"main_tree_to_execute", Calls::nameOf(mission)}});
    calls.want(mission);
    for (std::size_t i = 0; i < calls.composites.size(); ++i)
      root.children.push_back(tree(*calls.composites[i]));
    if (const auto code = conditions.initially(); !code.empty()) {
      auto& main = root.children.front().children.front();
      main = inOrder(true, element("Script", {{"code", code}}), std::move(main));
    }
    conditions.checkGuards();
    root.children.push_back(model());
    noteTheRest();
    return root;
  }

  [[nodiscard]] std::string leaves() const {
    Json all = Json::object();
    for (const auto* leaf : calls.leaves) all[std::string(leaf->name())] = leafOf(*leaf);
    for (const auto& [id, changes] : conditions.conditions)
      if (!changes) all[id] = {{"kind", "condition"}, {"changes", false}};
    return Json{{"leaves", all}}.dump(2) + "\n";
  }

private:
  Element tree(const Definition<syntax::Skill>& skill) {
    auto body = guarded(skill, Statements(draft, conditions, calls, loops, skill).body());
    return element("BehaviorTree", {{"ID", Calls::nameOf(skill)}}, {std::move(body)});
  }

  /// A body that ends with a failure as soon as a guard of its skill is false.
  Element guarded(const Definition<syntax::Skill>& skill, Element body) {
    if (skill->invariants.empty()) return body;
    std::vector<Element> children;
    for (const auto& each : skill->invariants)
      children.push_back(conditions.ofGuard(each.guard, skill.file));
    children.push_back(std::move(body));
    return element("ReactiveSequence", {}, std::move(children));
  }

  Element model() {
    auto model = element("TreeNodesModel");
    for (const auto* leaf : calls.leaves) {
      std::vector<Element> ports;
      for (const auto& input : (*leaf)->inputs)
        ports.push_back(element("input_port", {{"name", std::string(input.name.text.substr(1))}}));
      model.children.push_back(
          element("Action", {{"ID", std::string(leaf->name())}}, std::move(ports)));
    }
    for (const auto& [id, changes] : conditions.conditions)
      model.children.push_back(element("Condition", {{"ID", id}}));
    return model;
  }

  [[nodiscard]] Json leafOf(const Definition<syntax::Skill>& skill) const {
    const auto ends = calls.endsOf(skill.name());
    Json leaf = Json::object();
    if (const auto& time = skill->timeInterval) {
      const auto seconds = [](syntax::Rational value) {
        return static_cast<double>(value.numerator) / static_cast<double>(value.denominator);
      };
      leaf["duration"] = {seconds(time->lower), nullptr};
      if (time->upper) leaf["duration"][1] = seconds(*time->upper);
    }
    if (!ends.failure) leaf["outcomes"] = {"success"};
    if (!ends.success) leaf["outcomes"] = {"failure"};
    return leaf;
  }

  /// The file of leaves has closed intervals.
  void noteTime(const Definition<syntax::Skill>& skill) {
    const auto& time = skill->timeInterval;
    if (time && (time->lowerOpen || (time->upper && time->upperOpen)))
      draft.note(skill.at(time->range), "that this interval is open");
  }

  /// What is neither in the tree nor in the file of leaves.
  void noteTheRest() {
    for (const auto* leaf : calls.leaves) noteTime(*leaf);
    for (const auto& each : draft.program.skills.all)
      if (!calls.isKnown(each.name()))
        draft.note(each.at(each->name.range), "a skill that is not called");
    for (const auto& each : draft.program.events.all) {
      const auto variable = Variables::onlyVariableOf(each.node());
      const bool isImplied =
          !variable.empty() && conditions.variables.changed(variable) == Changed::Freely;
      if (!isImplied) draft.note(each.at(each->name.range), "an event");
    }
    for (const auto& each : draft.program.environments.all)
      draft.note(each.at(each->name.range), "an environment");
    for (const auto& each : draft.program.properties.all)
      draft.note(each.at(each->name.range), "a property");
  }

  Draft& draft;
  Conditions conditions;
  Calls calls;
  CountedLoops loops;
};

} // namespace

std::expected<EmittedTree, Errors> emitTree(const analysis::Program& program,
                                            std::string_view skill) {
  Draft draft{program, {}, {}};
  const auto* mission = missionOf(draft, skill);
  if (!mission) return std::unexpected(std::move(draft.errors));
  TreeWriter writer(draft);
  const auto document = writer.document(*mission);
  if (depthOf(document) > kDeepestXml)
    draft.fail(mission->at((*mission)->name.range), "statements that are nested so deeply");
  if (!draft.errors.empty()) return std::unexpected(sorted(std::move(draft.errors)));
  return EmittedTree{{writeXml(document), std::move(draft.notes)}, writer.leaves()};
}

} // namespace proskill::bridge::bt
