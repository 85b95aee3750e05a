#include "tests/support/random/random_words.h"

#include <algorithm>

namespace proskill::test {

namespace {

/// A state variable with such a name is not the type of an input.
const std::vector<std::string> kTypes{"int", "nat", "float", "bool", "string"};

/// Generates names that are unique among definitions of a kind.
class UniqueNames {
public:
  explicit UniqueNames(RandomSource& source) : random(source) {}

  /// Usually a plain name; sometimes a word that Fiacre or the generated code uses, but not a
  /// keyword of statements, which could not be called.
  std::string draw(const std::string& plain) {
    static const std::vector<std::string> awkward{
        "start",   "state",     "from",     "to",   "select",  "on",       "is",      "any",
        "nat",     "wait",      "record",   "port", "process", "union",    "first",   "full",
        "empty",   "tag",       "event",    "idle", "run",     "None",     "root",    "caller",
        "Main",    "type",      "var",      "in",   "out",     "foreach",  "read",    "skill",
        "sv_v0",   "v0_error",  "loop",     "null", "init",    "end",      "queue",   "array",
        "const",   "component", "priority", "stop", "start_",  "skill_s1", "r0_used", "NS1",
        "monitor", "no_result", "skill_id"};
    std::string name =
        random.chance(15) ? random.pick(awkward) : plain + std::to_string(used.size());
    if (std::ranges::find(used, name) != used.end()) name = plain + std::to_string(used.size());
    used.push_back(name);
    return name;
  }

private:
  RandomSource& random;
  std::vector<std::string> used;
};

std::vector<std::string> tags(RandomSource& random, const std::string& stem, std::size_t atMost) {
  std::vector<std::string> all;
  std::size_t count = random.below(atMost + 1);
  for (std::size_t i = 0; i < count; ++i) all.push_back(stem + std::to_string(i));
  static const std::vector<std::string> awkward{"idle",       "start",
                                                "success",    "failure",
                                                "no_status",  "no_tag",
                                                "None",       "root",
                                                "stopped",    "int",
                                                "nat",        "state",
                                                "skill",      "interrupted",
                                                "failed_inv", "return",
                                                "main",       "_x",
                                                "s0_idle",    "skill_none",
                                                "over",       "most_general_caller"};
  if (!all.empty() && random.chance(12)) all[0] = random.pick(awkward);
  return all;
}

VariableWords enumeration(RandomSource& random, std::string name) {
  static const std::vector<std::string> pool{"Good", "Low", "Bad", "Free"};
  VariableWords variable{std::move(name), {}, 0, 0};
  std::size_t count = 2 + random.below(2);
  std::size_t shift = random.below(2); // variables share some values
  for (std::size_t i = 0; i < count; ++i) variable.values.push_back(pool[i + shift]);
  static const std::vector<std::string> awkward{
      "none", "union", "None",        "root",  "success", "no_result", "no_status", "failure",
      "idle", "state", "interrupted", "skill", "start",   "int",       "double",    "v0",
      "case", "dead",  "stopping",    "over",  "_x",      "ret_val",   "undershoot"};
  if (random.chance(12)) variable.values[0] = random.pick(awkward);
  return variable;
}

/// Where conditions read inputs, most types are those that can be read.
std::string basicType(RandomSource& random, const ProgramSize& size) {
  return size.inputs > 0 && random.chance(85) ? "bool" : random.pick(kTypes);
}

SkillWords skill(RandomSource& random, std::string name, const Words& words,
                 const ProgramSize& size) {
  SkillWords result;
  result.name = std::move(name);
  result.interruptible = random.chance(40);
  result.unstoppable = !result.interruptible && random.chance(35);
  result.successes = tags(random, "done", 2);
  result.failures = tags(random, "broken", 2);
  if (!result.failures.empty() && !result.successes.empty() &&
      result.failures[0] == result.successes[0])
    result.failures[0] = "lost";
  while (random.chance(std::max(20U, size.inputs))) {
    bool known = random.chance(std::max(20U, size.inputs)) && !words.variables.empty();
    std::string type = known ? random.pick(words.variables).name : basicType(random, size);
    if (result.inputs.size() < 3)
      result.inputs.emplace_back("a" + std::to_string(result.inputs.size()), type);
  }
  return result;
}

void addSkills(RandomSource& random, const ProgramSize& size, Words& words) {
  UniqueNames names(random);
  auto add = [&](const std::string& stem, bool composite, bool monitor) {
    words.skills.push_back(skill(random, names.draw(stem), words, size));
    words.skills.back().composite = composite;
    words.skills.back().monitor = monitor;
    if (!composite || !monitor) return;
    words.skills.back().inputs.clear();
  };
  if (!words.library) {
    add("mission", true, false);
    words.skills.back().inputs.clear();
    for (std::size_t i = random.below(size.composites + 1); i > 0; --i) add("c", true, false);
  }
  for (std::size_t i = random.below(size.monitors + 1); i > 0; --i) add("m", true, true);
  for (std::size_t i = 1 + random.below(size.basicSkills); i > 0; --i) add("s", false, false);
}

} // namespace

Words randomWords(RandomSource& random, const ProgramSize& size) {
  Words words;
  words.library = random.chance(size.library);
  UniqueNames variables(random);
  for (std::size_t i = 1 + random.below(size.stateVariables); i > 0; --i)
    words.variables.push_back(enumeration(random, variables.draw("v")));
  for (std::size_t i = random.below(size.naturals + 1); i > 0; --i) {
    std::int64_t low = random.between(0, 1);
    words.variables.push_back({variables.draw("n"), {}, low, low + random.between(1, 2)});
  }
  UniqueNames events(random);
  for (std::size_t i = random.below(size.events + 1); i > 0; --i)
    words.events.push_back(events.draw("e"));
  for (const auto& event : words.events)
    if (!random.chance(size.every)) words.emitted.push_back(event);
  UniqueNames resources(random);
  for (std::size_t i = random.below(size.resources + 1); i > 0; --i)
    words.resources.push_back(resources.draw("r"));
  addSkills(random, size, words);
  return words;
}

std::string Phrases::seconds(std::int64_t least) {
  std::string whole = std::to_string(random.between(least, std::max(least, size.seconds)));
  return random.chance(size.halves) ? whole + ".5" : whole;
}

std::string Phrases::duration() { return seconds(0); }

std::string Phrases::interval() {
  bool lowerOpen = random.chance(20);
  std::int64_t lower = random.between(0, size.seconds - 1);
  std::string text =
      (lowerOpen ? "]" : "[") + std::to_string(lower) + (random.chance(20) ? " , " : ",");
  if (random.chance(15)) return text + "...[";
  bool point = !lowerOpen && random.chance(15);
  std::string upper = point ? std::to_string(lower) : seconds(lower + 1);
  return text + upper + (!point && random.chance(20) ? "[" : "]");
}

std::string Phrases::every() {
  std::string text = interval();
  while (text == "[0,0]" || text == "[0 , 0]") text = interval();
  return text;
}

std::string Phrases::literal(const std::string& type) {
  if (type == "int") return std::to_string(random.between(-2, 2));
  if (type == "nat") return std::to_string(random.between(0, 2));
  if (type == "float") return random.chance(50) ? "-0.5" : "3.0";
  if (type == "bool") return random.chance(50) ? "true" : "false";
  if (type == "string") return "\"a (\\\"b\\\")\"";
  for (const auto& variable : vocabulary.variables)
    if (variable.name == type)
      return variable.values.empty() ? std::to_string(variable.low) : random.pick(variable.values);
  return "0";
}

/// An input of the skill that has the values of the variable.
std::optional<std::string> Phrases::inputOf(const VariableWords& variable) {
  if (!writtenIn || size.inputs == 0 || !random.chance(size.inputs)) return std::nullopt;
  if (std::ranges::find(kTypes, variable.name) != kTypes.end()) return std::nullopt;
  std::vector<std::string> all;
  for (const auto& [name, type] : writtenIn->inputs)
    if (type == variable.name) all.push_back("$" + name);
  if (all.empty()) return std::nullopt;
  return random.pick(all);
}

Form Phrases::effect(const VariableWords& variable) {
  if (const auto input = inputOf(variable)) {
    if (!variable.values.empty() || random.chance(50)) return {variable.name, *input};
    return {variable.name, Form{random.chance(50) ? "+" : "-", variable.name, *input}};
  }
  if (!variable.values.empty()) return {variable.name, random.pick(variable.values)};
  if (random.chance(50))
    return {variable.name, std::to_string(random.between(variable.low, variable.high))};
  return {variable.name, Form{random.chance(50) ? "+" : "-", variable.name, "1"}};
}

Form Phrases::effects() {
  Form first = effect(random.pick(vocabulary.variables));
  if (random.chance(70)) return first;
  Form all{first};
  for (const auto& variable : vocabulary.variables)
    if (variable.name != first.items[0].word && random.chance(50)) all.add(effect(variable));
  return all;
}

Form Phrases::comparisonOfNaturals(const VariableWords& variable) {
  static const std::vector<std::string> operators{"=", "/=", "<", "<=", ">", ">="};
  std::string number = std::to_string(random.between(variable.low, variable.high));
  if (const auto input = inputOf(variable)) {
    if (random.chance(50)) return {variable.name, *input};
    return {random.pick(operators), *input, random.chance(50) ? number : variable.name};
  }
  if (random.chance(25)) return {variable.name, number};
  Form left = variable.name;
  if (random.chance(30)) left = {random.chance(70) ? "+" : "-", variable.name, "1"};
  for (const auto& other : vocabulary.variables)
    if (other.values.empty() && other.name != variable.name && random.chance(30))
      return {random.pick(operators), left, other.name};
  return {random.pick(operators), left, number};
}

Form Phrases::comparisonOfOutcomes() {
  static const std::vector<std::string> statuses{"no_status", "success",    "success",    "success",
                                                 "failure",   "failed_inv", "interrupted"};
  const auto& skill = random.pick(vocabulary.skills);
  std::string equality = random.chance(70) ? "=" : "/=";
  std::vector<std::string> results = skill.successes;
  results.insert(results.end(), skill.failures.begin(), skill.failures.end());
  if (results.empty() || random.chance(70))
    return {equality, skill.name + ".status", random.pick(statuses)};
  return {equality, skill.name + ".res", random.pick(results)};
}

/// A condition on truth values that the skill is given, if it is given any.
std::optional<Form> Phrases::truth() {
  if (!writtenIn || size.inputs == 0 || !random.chance(size.inputs * 3 / 4)) return std::nullopt;
  std::vector<std::string> all;
  for (const auto& [name, type] : writtenIn->inputs)
    if (type == "bool") all.push_back("$" + name);
  if (all.empty()) return std::nullopt;
  const std::string input = random.pick(all);
  const std::string equality = random.chance(50) ? "=" : "/=";
  switch (random.below(6)) {
  case 0: return Form{equality, input, literal("bool")};
  case 1: return Form{equality, literal("bool"), input};
  case 2: return Form{equality, input, random.pick(all)};
  default: return Form(input);
  }
}

Form Phrases::comparison() {
  if (auto condition = truth()) return *condition;
  if (random.chance(3)) return random.chance(50) ? "true" : "false";
  if (random.chance(25)) return comparisonOfOutcomes();
  const auto& variable = random.pick(vocabulary.variables);
  if (variable.values.empty()) return comparisonOfNaturals(variable);
  std::string value = random.pick(variable.values);
  if (const auto input = inputOf(variable)) {
    if (random.chance(40)) return {variable.name, *input};
    return {random.chance(60) ? "=" : "/=", random.chance(70) ? Form(*input) : Form(variable.name),
            random.chance(70) ? Form(value) : Form(*input)};
  }
  if (random.chance(60)) return {variable.name, value};
  return {random.chance(60) ? "=" : "/=", variable.name, value};
}

Form Phrases::observation() {
  static const std::vector<std::string> statuses{"success", "failure", "failed_inv", "interrupted"};
  const auto& skill = random.pick(vocabulary.skills);
  switch (random.below(6)) {
  case 0: return {"running", skill.name};
  case 1: return {"called", skill.name};
  case 2:
    return random.chance(50) ? Form{"ended", skill.name}
                             : Form{"ended", skill.name, random.pick(statuses)};
  case 3:
    if (!vocabulary.events.empty()) return {"occurs", random.pick(vocabulary.events)};
    break;
  case 4:
    if (!vocabulary.labels.empty()) return {"at", random.pick(vocabulary.labels)};
    break;
  default: break;
  }
  const auto& variable = random.pick(vocabulary.variables);
  return {"value", variable.name,
          variable.values.empty() ? std::to_string(variable.high) : random.pick(variable.values)};
}

Form Phrases::connect(bool widened, std::size_t depth) {
  auto part = [&] { return widened ? proposition(depth - 1) : condition(depth - 1); };
  if (random.chance(35)) return {random.chance(50) ? "not" : "~", part()};
  static const std::vector<std::string> operators{"and", "&", "or", "|", "=>", "<=>"};
  return {random.pick(operators), part(), part()};
}

Form Phrases::condition(std::size_t depth) {
  return depth > 0 && random.chance(30) ? connect(false, depth) : comparison();
}

Form Phrases::proposition(std::size_t depth) {
  if (depth > 0 && random.chance(40)) return connect(true, depth);
  return random.chance(60) ? observation() : comparison();
}

} // namespace proskill::test
