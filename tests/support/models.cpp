#include "tests/support/models.h"

#include <algorithm>
#include <stdexcept>

namespace proskill::test {

using fiacre::Observable;
using fiacre::ObservableKind;
using fiacre::PatternKind;
using fiacre::Property;

Property absentState(std::uint32_t place, std::string state) {
  Observable seen{.kind = ObservableKind::State, .path = {place}, .name = std::move(state)};
  return {.name = "p", .pattern = {.kind = PatternKind::Absent, .operands = {seen}}};
}

Property absentTag(std::uint32_t place, std::string tagName) {
  Observable seen{.kind = ObservableKind::Tag, .path = {place}, .name = std::move(tagName)};
  return {.name = "p", .pattern = {.kind = PatternKind::Absent, .operands = {seen}}};
}

Property absentValue(fiacre::Expr value) {
  Observable seen{.kind = ObservableKind::Value, .value = std::move(value)};
  return {.name = "p", .pattern = {.kind = PatternKind::Absent, .operands = {seen}}};
}

Property plain(PatternKind kind) { return {.name = "p", .pattern = {.kind = kind}}; }

Model& Model::variable(std::string name, fiacre::Type type, fiacre::Expr init) {
  made.components[0].variables.push_back({std::move(name), std::move(type), std::move(init), {}});
  return *this;
}

Model& Model::channel(std::string name, std::optional<fiacre::Interval> interval) {
  made.components[0].ports.push_back({.name = std::move(name), .interval = interval});
  return *this;
}

namespace {

void portsOf(const fiacre::Statement& statement, std::vector<std::string>& ports) {
  if (statement.kind == fiacre::StatementKind::Send &&
      std::ranges::find(ports, statement.name) == ports.end())
    ports.push_back(statement.name);
  for (const auto& child : statement.children) portsOf(child, ports);
}

} // namespace

Model& Model::add(fiacre::Process process) {
  fiacre::Instance instance{.process = process.name};
  for (const auto& shared : made.components[0].variables) {
    process.parameters.push_back({shared.name, shared.type, true});
    instance.arguments.push_back(fiacre::test::name(shared.name));
    instance.references.push_back(true);
  }
  for (const auto& from : process.transitions) portsOf(from.statement, instance.ports);
  for (const auto& port : instance.ports) process.ports.push_back({.name = port});
  made.components[0].instances.push_back(std::move(instance));
  made.processes.push_back(std::move(process));
  return *this;
}

Model& Model::ask(Property property) {
  made.properties.push_back(std::move(property));
  return *this;
}

verify::Result Model::answers(const verify::Options& options) const {
  std::vector<verify::Question> questions;
  for (std::size_t i = 0; i < made.properties.size(); ++i) questions.push_back({i});
  auto result = verify::verify(made, {}, questions, options);
  if (!result) throw std::runtime_error(result.error().message);
  return *result;
}

verify::Answer Model::answer(Property property, const verify::Options& options) const {
  Model with = *this;
  with.made.properties = {std::move(property)};
  return with.answers(options).answers.at(0);
}

bool Model::isFalse(Property property) const {
  std::optional<bool> first;
  for (const auto& options : reductionChoices()) {
    auto truth = answer(property, options).truth;
    if (truth == verify::Truth::Unknown) throw std::runtime_error("unknown");
    if (first && *first != (truth == verify::Truth::False))
      throw std::runtime_error("the answer depends on the reductions");
    first = truth == verify::Truth::False;
  }
  return *first;
}

bool Model::reaches(std::uint32_t place, std::string state) const {
  return isFalse(absentState(place, std::move(state)));
}

std::vector<verify::Options> reductionChoices() {
  const std::set<verify::Reduction> all = verify::Options{}.reductions;
  std::vector<verify::Options> choices(2);
  choices[1].reductions.clear();
  for (auto one : all) {
    choices.emplace_back().reductions = {one};
    choices.emplace_back().reductions.erase(one);
  }
  choices.emplace_back().classesBeforeSlices = 0;
  return choices;
}

std::uint64_t classesToProve(Model model, fiacre::Property property,
                             std::set<verify::Reduction> reductions) {
  model.ask(std::move(property));
  verify::Options options;
  options.reductions = std::move(reductions);
  auto result = model.answers(options);
  if (result.answers[0].truth != verify::Truth::True)
    throw std::logic_error("the property is not true");
  return result.exploration.classes;
}

} // namespace proskill::test
