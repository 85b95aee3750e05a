#include "tests/support/random/random_body.h"

#include <algorithm>

namespace proskill::test {

Form Bodies::ofSkill(std::size_t skill) {
  Form body;
  topLevel({skill, size.depth, false, false, nullptr}, body);
  return body;
}

Form Bodies::ofEnvironment() {
  Form body;
  topLevel({0, size.depth, true, false, nullptr}, body);
  return body;
}

std::vector<std::size_t> Bodies::uncalled() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 1; i < vocabulary.skills.size(); ++i) {
    const auto& skill = vocabulary.skills[i];
    bool mine = skill.composite && !skill.monitor;
    if (mine && std::ranges::find(called, i) == called.end()) all.push_back(i);
  }
  return all;
}

std::vector<Form> Bodies::block(Place place) {
  std::vector<Form> statements;
  for (std::size_t i = 1 + random.below(size.statements); i > 0; --i) {
    Form next = statement(place);
    if (size.labels > 0 && !place.environment && looks(next) && random.chance(size.labels))
      statements.push_back({"label", newLabel()});
    statements.push_back(std::move(next));
  }
  return statements;
}

/// It tests something, or stops a skill.
bool Bodies::looks(const Form& statement) {
  if (!statement.isList()) return false;
  const std::string& head = statement.items.front().word;
  bool waits = head == "^" && statement.items[1].isList();
  return waits || head == "if" || head == "while" || head.ends_with(".interrupt");
}

std::string Bodies::newLabel() {
  vocabulary.labels.push_back("L" + std::to_string(vocabulary.labels.size()));
  return vocabulary.labels.back();
}

// A body or a branch has labels of its own; a jump leads forwards or backwards to one of them.
void Bodies::topLevel(Place place, Form& body) {
  std::vector<std::string> labels;
  place.labels = &labels;
  if (random.chance(15)) labels.push_back(newLabel());
  bool forward = random.chance(40);
  if (!labels.empty() && !forward) body.add({"label", labels[0]});
  body.addAll(block(place));
  if (!labels.empty() && !forward) body.add({"if", phrase.condition(), Form{"goto", labels[0]}});
  if (!labels.empty() && forward) body.add({"label", labels[0]});
  if (!labels.empty() && forward && random.chance(50)) body.addAll(block(place));
}

Form Bodies::statement(Place place) {
  if (place.depth > 0 && random.chance(35)) {
    --place.depth;
    return compound(place);
  }
  return simple(place);
}

Form Bodies::simple(Place place) {
  if (place.inLoop && random.chance(12)) return random.chance(50) ? Form("break") : Form{"break"};
  if (!place.labels->empty() && random.chance(15))
    return {"if", phrase.condition(), Form{"goto", place.labels->front()}};
  if (random.chance(25)) return wait(place);
  if (place.environment) {
    if (!vocabulary.emitted.empty() && random.chance(80))
      return {"emit", random.pick(vocabulary.emitted)};
    return interruptOf(place);
  }
  if (random.chance(50)) return callOrInterrupt(place);
  switch (random.below(3)) {
  case 0: return {"set", phrase.effects()};
  case 1: return outcome(place);
  default: return print();
  }
}

Form Bodies::compound(Place place) {
  if (random.chance(size.forks)) return branches(place, fork(place));
  return random.chance(65) ? choice(place) : loop(place);
}

const char* Bodies::fork(Place place) {
  if (place.environment) return "choose";
  return random.chance(size.races) ? "race" : "//";
}

Form Bodies::wait(Place place) {
  Form wait{"^"};
  switch (random.below(place.environment ? 3 : 4)) {
  case 0: return {"^", phrase.duration()};
  case 1: return {"^", phrase.interval()};
  case 2: wait.add(phrase.condition()); break;
  default: wait.addAll({phrase.condition(), ":effects", phrase.effects()});
  }
  if (random.chance(30)) addTimeout(place, wait);
  return wait;
}

void Bodies::addTimeout(Place place, Form& wait) {
  wait.addAll({":timeout", random.chance(60) ? phrase.duration() : phrase.interval()});
  if (place.depth == 0 || random.chance(20)) return;
  --place.depth;
  wait.addAll(block(place));
}

Form Bodies::interruptOf(Place place) {
  std::vector<std::string> names;
  for (const auto& skill : vocabulary.skills)
    if (skill.interruptible && !(place.environment && skill.monitor)) names.push_back(skill.name);
  if (names.empty()) return wait(place);
  return {random.pick(names) + ".interrupt"};
}

Form Bodies::call(std::size_t index, std::size_t caller) {
  called.push_back(index);
  const auto& skill = vocabulary.skills[index];
  Form result{skill.name};
  for (const auto& [name, type] : skill.inputs) {
    std::string value = phrase.literal(type);
    for (const auto& [given, givenType] : vocabulary.skills[caller].inputs)
      if (givenType == type && random.chance(size.inputs > 0 ? 75 : 40)) value = "$" + given;
    result.addAll({name, value});
  }
  return result;
}

Form Bodies::callOrInterrupt(Place place) {
  if (random.chance(12)) return interruptOf(place);
  std::vector<std::size_t> callable;
  for (std::size_t i = place.skill + 1; i < vocabulary.skills.size(); ++i)
    if (!vocabulary.skills[i].monitor) callable.push_back(i);
  const auto callee = random.pick(callable);
  if (place.depth > 0 && random.chance(30)) return cases(callee, place);
  return call(callee, place.skill);
}

/// A call with an arm for each outcome, in any order; some end with an `else`.
Form Bodies::cases(std::size_t callee, Place place) {
  --place.depth;
  const SkillWords skill = vocabulary.skills[callee];
  auto patterns = outcomesOf(skill);
  std::ranges::rotate(patterns,
                      patterns.begin() + static_cast<long>(random.below(patterns.size())));
  if (random.chance(30)) {
    patterns.resize(random.below(patterns.size()));
    patterns.emplace_back("else");
  }
  Form result{"case", call(callee, place.skill)};
  for (const auto& pattern : patterns) {
    Form arm;
    arm.add(pattern);
    if (random.chance(60)) arm.addAll(block(place));
    result.add(arm);
  }
  return result;
}

/// Patterns of all outcomes, one for each tag or one for all tags.
std::vector<Form> Bodies::outcomesOf(const SkillWords& skill) {
  std::vector<Form> patterns;
  const auto add = [&](const char* status, const std::vector<std::string>& tags, bool untagged) {
    const bool each = random.chance(60);
    for (const auto& tag : tags)
      if (each) patterns.push_back({status, tag});
    if (untagged || (!each && !tags.empty())) patterns.emplace_back(status);
  };
  add("success", skill.successes, skill.composite || skill.successes.empty());
  add("failure", skill.failures, false);
  add("failed_inv", skill.invariants, false);
  if (skill.interruptible) patterns.emplace_back("interrupted");
  if (skill.refusable) patterns.emplace_back("refused");
  return patterns;
}

Form Bodies::outcome(Place place) {
  const auto& skill = vocabulary.skills[place.skill];
  bool good = random.chance(50);
  const auto& tags = good ? skill.successes : skill.failures;
  if (tags.empty()) return print();
  return {good ? "success" : "failure", random.pick(tags)};
}

Form Bodies::print() {
  const auto& variable = random.pick(vocabulary.variables);
  switch (random.below(4)) {
  case 0: return {"printf", variable.values.empty() ? "\"%d\\n\"" : "\"%s\\n\"", variable.name};
  case 1: return {"printf", "\"100%% (of ; it)\""};
  case 2: return {"printf", "\"%s\"", vocabulary.skills[0].name + ".status"};
  default: return {"printf", "\"%f %s\"", "1.5", "\"text\""};
  }
}

Form Bodies::choice(Place place) {
  Form result{"if", phrase.condition()};
  result.addAll(block(place));
  if (random.chance(25)) {
    result.addAll({"elseif", phrase.condition()});
    result.addAll(block(place));
  }
  if (random.chance(40)) {
    result.add("else");
    result.addAll(block(place));
  }
  return result;
}

// Most loops let time pass; otherwise every second program would loop without delay.
Form Bodies::loop(Place place) {
  place.inLoop = true;
  auto statements = block(place);
  if (random.chance(80)) statements.push_back({"^", "1"});
  switch (random.below(3)) {
  case 0: {
    Form result{"while", phrase.condition()};
    result.addAll(statements);
    return result;
  }
  case 1: {
    Form result{"do"};
    result.addAll(statements);
    result.addAll({"until", phrase.condition()});
    return result;
  }
  default: {
    Form result{"do-until", phrase.condition()};
    result.addAll(statements);
    return result;
  }
  }
}

Form Bodies::branches(Place place, const char* head) {
  Form result{head};
  place.inLoop = place.inLoop && place.environment;
  for (std::size_t i = 1 + random.below(size.branches); i > 0; --i) {
    Form branch;
    if (place.environment)
      branch.addAll(block(place));
    else
      topLevel(place, branch);
    result.add(branch);
  }
  return result;
}

} // namespace proskill::test
