#include "bridge/gen/translate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <utility>

namespace proskill::bridge::gen {
namespace {

std::string_view kindOf(const Service& service) {
  switch (service.kind) {
  case ServiceKind::Attribute: return "attribute";
  case ServiceKind::Function: return "function";
  case ServiceKind::Activity: return "activity";
  }
  std::unreachable();
}

/// Whether a run of the codels can come from `start` to `ether`.
bool canEnd(const Service& service) {
  std::set<std::string> seen{"start"};
  std::deque<std::string> open{"start"};
  while (!open.empty()) {
    const auto state = open.front();
    open.pop_front();
    if (state == "ether") return true;
    for (const auto& codel : service.codels)
      if (has(codel.states, state))
        for (const auto& step : codel.steps)
          if (seen.insert(step.state.text).second) open.push_back(step.state.text);
  }
  return false;
}

Form all(std::vector<Form> forms) { return forms.size() == 1 ? forms.front() : Form(forms); }

} // namespace

void Translation::add(const Component& component) {
  ports += component.ports;
  tasks += component.tasks;
  addFlags(component);
  for (const auto& service : component.services) skill(service);
}

std::string Translation::nameOf(const Component& component, const std::string& word) const {
  return several ? component.name.text + "_" + word : word;
}

/// Skills have their names first, since users call them.
void Translation::addFlags(const Component& component) {
  flags.clear();
  skillNames.clear();
  const auto isNamed = [&](const Service& service, auto list) {
    return std::ranges::any_of(component.services, [&](const Service& other) {
      return other.name.text != service.name.text && has(other.*list, service.name.text);
    });
  };
  for (const auto& service : component.services)
    skillNames[service.name.text] = names.take(nameOf(component, service.name.text));
  for (const auto& service : component.services) {
    auto& own = flags[service.name.text];
    if (isNamed(service, &Service::interrupts))
      own.replaced = addFlag(component, service, "replaced");
    if (isNamed(service, &Service::after) || isNamed(service, &Service::before))
      own.done = addFlag(component, service, "done");
  }
}

std::string Translation::addFlag(const Component& component, const Service& service,
                                 const char* suffix) {
  auto name = names.take(fmt::format("{}_{}", nameOf(component, service.name.text), suffix));
  variables.push_back(
      list("defsv", name, ":states", list("No", "Yes"), ":init", "No", ":transitions", ":all"));
  return name;
}

const std::string& Translation::flagOf(const Word& service, std::string Flags::*which) const {
  static const Flags none;
  const auto found = flags.find(service.text);
  return (found == flags.end() ? none : found->second).*which;
}

void Translation::skill(const Service& service) {
  Form form = list("defskill", skillNames.at(service.name.text));
  form.comment = asComment(service.name.place,
                           fmt::format("{} {}", kindOf(service), service.name.text), folder);
  std::vector<Form> inputs;
  NamePool inputNames; // parts of `ids` may have one name: `linear.max`, `angular.max`
  Form command = list(service.name.text);
  for (const auto& parameter : service.parameters) {
    if (!parameter.isInput) {
      ++outputs;
      continue;
    }
    const auto input = "$" + inputNames.take(parameter.name.text);
    append(inputs, {input, parameter.scalar});
    command.parts.emplace_back(input);
  }
  if (!inputs.empty()) append(form.parts, {":input", Form(std::move(inputs))});
  preconditions(service, form);
  start(service, form);
  if (const auto interval = leaves.of(service.name.text).interval(); !interval.empty())
    append(form.parts, {":time_interval", interval});
  append(form.parts, {":action", command});
  if (service.kind == ServiceKind::Activity)
    append(form.parts, {":interrupt", Form(std::vector<Form>{})});
  else
    append(form.parts, {":interruptible", "nil"});
  outcomes(service, form);
  skills.push_back(std::move(form));
  codels += service.codels.size();
  approximate(service);
}

void Translation::preconditions(const Service& service, Form& form) const {
  std::vector<Form> conditions;
  NamePool tags;
  for (const auto& other : service.after)
    if (const auto& flag = flagOf(other, &Flags::done); !flag.empty())
      append(conditions, {tags.take("after_" + other.text), list(flag, "Yes")});
  for (const auto& other : service.before)
    if (const auto& flag = flagOf(other, &Flags::done); !flag.empty())
      append(conditions, {tags.take("before_" + other.text), list(flag, "No")});
  if (!conditions.empty()) append(form.parts, {":precondition", Form(std::move(conditions))});
}

void Translation::start(const Service& service, Form& form) const {
  std::vector<Form> effects;
  const auto& own = flagOf(service.name, &Flags::replaced);
  if (!own.empty()) effects.push_back(list(own, "No"));
  std::set<std::string> seen{service.name.text};
  for (const auto& other : service.interrupts)
    if (const auto& flag = flagOf(other, &Flags::replaced);
        !flag.empty() && seen.insert(other.text).second)
      effects.push_back(list(flag, "Yes"));
  if (!effects.empty()) append(form.parts, {":start", all(std::move(effects))});
  if (!own.empty())
    append(form.parts, {":invariant", list("not_replaced", list(":guard", list(own, "No")))});
}

void Translation::outcomes(const Service& service, Form& form) const {
  const auto& leaf = leaves.of(service.name.text);
  append(form.parts, {":success", "done"});
  if (const auto& flag = flagOf(service.name, &Flags::done); !flag.empty())
    form.parts.push_back(list(":effects", list(flag, "Yes")));
  NamePool tags;
  tags.take("done");
  std::vector<Form> failures;
  std::set<std::string> seen;
  for (const auto& exception : service.exceptions)
    if (seen.insert(exception.text).second) failures.emplace_back(tags.take(exception.text));
  if (!failures.empty() && leaf.fails) append(form.parts, {":failure", all(std::move(failures))});
}

void Translation::approximate(const Service& service) {
  const auto& name = service.name.text;
  if (has(service.interrupts, name))
    notes.push_back(
        {service.name.place,
         fmt::format("a second call of `{}` ends the first one; in the program it waits "
                     "for its end",
                     name)});
  if (!service.codels.empty() && service.kind == ServiceKind::Activity && !canEnd(service))
    notes.push_back(
        {service.name.place,
         fmt::format("`{}` never leads to `ether`; in the program it may succeed", name)});
}

Block Translation::program() const {
  Block all = variables;
  append(all, skills);
  return all;
}

std::vector<std::string> Translation::omitted() const {
  std::vector<std::string> parts;
  if (ports > 0) parts.push_back(counted(ports, "port", "ports"));
  if (tasks > 0) parts.push_back(counted(tasks, "task", "tasks"));
  if (codels > 0) parts.push_back(counted(codels, "codel", "codels"));
  if (outputs > 0) parts.push_back(counted(outputs, "output", "outputs"));
  if (parts.empty()) return {};
  return {fmt::format("not in the program: {}", fmt::join(parts, ", "))};
}

} // namespace proskill::bridge::gen
