#include "report/simulation_json.h"

#include "report/report_json.h"

#include <fmt/format.h>

namespace proskill::report {

namespace {

std::string textAt(const OrderedJson& json, const char* name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

std::expected<ide::ChosenStep, std::string> stepOf(const OrderedJson& json) {
  if (!json.is_object() || textAt(json, "actor").empty())
    return std::unexpected("a step needs an `actor` and a `description`");
  ide::ChosenStep step{.actor = textAt(json, "actor"), .description = textAt(json, "description")};
  if (const auto found = json.find("transitions"); found != json.end() && found->is_array())
    for (const auto& it : *found)
      if (it.is_string()) step.transitions.push_back(it.get<std::string>());
  const auto late = json.find("late");
  if (late != json.end() && *late == true) step.when = verify::When::Late;
  return step;
}

std::string descriptionOf(const ide::SimulatedRun& run) {
  return run.mainSkill().empty() ? "a chosen run of a library of skills"
                                 : fmt::format("a chosen run of `{}`", run.mainSkill());
}

OrderedJson unmetJson(const std::vector<ide::UnmetValue>& values) {
  OrderedJson all = OrderedJson::array();
  for (const auto& it : values)
    all.push_back({{"variable", it.variable}, {"expected", it.expected}, {"actual", it.actual}});
  return all;
}

} // namespace

std::expected<ChosenRun, std::string> readChosenRun(const OrderedJson& json) {
  if (!json.is_object()) return std::unexpected("a run must be a JSON object");
  ChosenRun run{.name = textAt(json, "name"), .mainSkill = textAt(json, "main")};
  const auto steps = json.find("steps");
  if (steps == json.end() || !steps->is_array()) return std::unexpected("a run must have `steps`");
  for (const auto& it : *steps) {
    if (it.is_object() && it.contains("remark")) continue;
    auto step = stepOf(it);
    if (!step) return std::unexpected(step.error());
    run.steps.push_back(std::move(*step));
  }
  const auto expected = json.find("expect");
  if (expected == json.end() || expected->is_null()) return run;
  if (!expected->is_object())
    return std::unexpected("`expect` must have a value for each variable");
  for (const auto& [variable, value] : expected->items()) {
    if (!value.is_string()) return std::unexpected("a value in `expect` must be a string");
    run.expected[variable] = value.get<std::string>();
  }
  return run;
}

OrderedJson simulationJson(const analysis::Program& program, const ide::SimulatedRun& run,
                           const ChosenRun& asked, const std::optional<ide::MissingStep>& missing) {
  OrderedJson trace{
      {"name", "simulation"}, {"description", descriptionOf(run)}, {"verdict", "chosen"}};
  trace.update(traceJson(program, run.trace()));
  for (std::size_t i = 0; i < run.trace().steps.size(); ++i)
    if (asked.steps[i].when == verify::When::Late) trace["steps"][i]["late"] = true;
  OrderedJson choices = OrderedJson::array();
  for (const auto& step : run.choices()) choices.push_back(stepJson(program, step));
  OrderedJson json{{"main", run.mainSkill()},
                   {"trace", std::move(trace)},
                   {"choices", std::move(choices)},
                   {"missing", nullptr},
                   {"unmet", OrderedJson::array()}};
  if (missing) {
    json["missing"] = {{"index", missing->index}, {"why", missing->why}};
  } else {
    json["unmet"] = unmetJson(ide::unmet(run, asked.expected));
  }
  return json;
}

} // namespace proskill::report
