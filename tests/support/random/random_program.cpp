#include "tests/support/random/random_program.h"

#include "tests/support/random/random_body.h"

#include <algorithm>

namespace proskill::test {

namespace {

const std::vector<std::string> kUntils{"W", "R", "M"};

/// Generates the definitions, one kind at a time.
class Definitions {
public:
  Definitions(std::uint64_t seed, const ProgramSize& bounds)
      : random(seed),
        size(bounds),
        words(randomWords(random, size)),
        phrase(random, words, size),
        bodies(random, words, phrase, size) {}

  std::vector<Form> write() {
    for (const auto& variable : words.variables) program.push_back(stateVariable(variable));
    for (const auto& name : words.events) program.push_back(event(name));
    for (const auto& resource : words.resources) program.push_back(this->resource(resource));
    addSkills();
    if (random.chance(size.environment))
      program.push_back({"defenvironment", "world", ":body", bodies.ofEnvironment()});
    for (std::size_t i = random.below(size.properties + 1); i > 0; --i) addProperty(i);
    return std::move(program);
  }

private:
  Form stateVariable(const VariableWords& variable) {
    Form form{"defsv", variable.name};
    if (variable.values.empty()) {
      std::vector<std::string> numbers;
      for (auto n = variable.low; n <= variable.high; ++n) numbers.push_back(std::to_string(n));
      form.addAll({":init", initial(numbers), ":min", numbers.front(), ":max", numbers.back()});
      return form;
    }
    Form values;
    for (const auto& value : variable.values) values.add(value);
    form.addAll({":states", values, ":init", initial(variable.values)});
    if (size.next > 0 || random.chance(40)) return form;
    form.add(":transitions");
    if (random.chance(25))
      form.add(":all");
    else
      form.add(transitions(variable));
    return form;
  }

  /// One of the values, or several.
  Form initial(const std::vector<std::string>& values) {
    if (!random.chance(size.open)) return random.pick(values);
    Form some;
    for (const auto& value : values)
      if (random.chance(60)) some.add(value);
    return some.items.empty() ? Form(random.pick(values)) : some;
  }

  Form transitions(const VariableWords& variable) {
    Form moves;
    for (const auto& from : variable.values)
      for (const auto& to : variable.values)
        if (from != to && random.chance(60)) moves.add({from, to});
    if (moves.items.empty()) moves.add({variable.values[0], variable.values[1]});
    return moves;
  }

  Form event(const std::string& name) {
    Form form{"defevent", name};
    if (std::ranges::find(words.emitted, name) == words.emitted.end())
      form.addAll({":every", phrase.every()});
    else if (random.chance(size.guarded))
      form.addAll({":guard", list(phrase.condition())});
    form.addAll({":effects", phrase.effects()});
    return form;
  }

  Form resource(const std::string& name) {
    Form form{"defresource", name};
    if (random.chance(50)) form.addAll({":capacity", std::to_string(random.between(1, 2))});
    return form;
  }

  // the main skill comes last, to call what the others do not
  void addSkills() {
    std::vector<Form> forms;
    for (std::size_t i = words.skills.size(); i-- > 0;) forms.push_back(skill(i));
    std::ranges::reverse(forms);
    program.insert(program.end(), forms.begin(), forms.end());
  }

  Form skill(std::size_t index) {
    const SkillWords skill = words.skills[index];
    phrase.writeIn(&skill);
    Form form = definition(index, skill);
    phrase.writeIn(nullptr);
    return form;
  }

  Form definition(std::size_t index, const SkillWords& skill) {
    Form form{"defskill", skill.name};
    if (skill.monitor) form.addAll({":monitor", index % 2 == 0 ? "always" : "t"});
    if (!skill.inputs.empty()) form.addAll({":input", inputs(skill)});
    if (random.chance(30)) {
      form.addAll({":precondition", preconditions()});
      words.skills[index].refusable = true;
    }
    if (random.chance(30)) form.addAll({":start", phrase.effects()});
    if (random.chance(skill.composite ? 20 : 35)) form.addAll({":invariant", invariants(index)});
    if (random.chance(skill.composite ? 35 : 75))
      form.addAll({":time_interval", phrase.interval()});
    if (!skill.composite) form.addAll({":action", action(skill)});
    addInterrupt(form, skill);
    addOutcomes(form, ":success", skill.successes);
    addOutcomes(form, ":failure", skill.failures);
    if (!words.resources.empty() && random.chance(40)) form.addAll({":resources", resources()});
    if (skill.composite) form.addAll({":body", body(index)});
    return form;
  }

  void addInterrupt(Form& form, const SkillWords& skill) {
    if (skill.unstoppable) form.addAll({":interruptible", "nil"});
    if (!skill.interruptible) return;
    if (random.chance(15))
      form.addAll({":interruptible", "t"});
    else
      form.addAll({":interrupt", Form{":effects", phrase.effects()}});
  }

  Form body(std::size_t index) {
    Form body = bodies.ofSkill(index);
    if (index != 0) return body;
    for (std::size_t skill : bodies.uncalled())
      body.items.insert(body.items.begin(), bodies.call(skill, 0));
    return body;
  }

  static Form inputs(const SkillWords& skill) {
    Form form;
    for (const auto& [name, type] : skill.inputs) form.addAll({"$" + name, type});
    return form;
  }

  Form preconditions() {
    Form form;
    for (std::size_t i = 1 + random.below(2); i > 0; --i)
      form.addAll({"p" + std::to_string(i), list(phrase.condition())});
    return form;
  }

  Form invariants(std::size_t skill) {
    Form form;
    for (std::size_t i = 1 + random.below(2); i > 0; --i) {
      words.skills[skill].invariants.push_back("i" + std::to_string(i));
      Form clause{":guard", list(phrase.condition())};
      if (random.chance(50)) clause.addAll({":effects", phrase.effects()});
      form.addAll({"i" + std::to_string(i), clause});
    }
    return form;
  }

  /// a condition in parentheses, or an input: tags may follow
  static Form list(Form condition) {
    return condition.isList() || condition.word.front() == '$'
               ? condition
               : Form{"not", Form{"not", condition}};
  }

  static Form action(const SkillWords& skill) {
    Form form{"command_" + skill.name};
    for (const auto& [name, _] : skill.inputs) form.add("$" + name);
    if (skill.inputs.empty()) form.addAll({"1", "2.5", "\"fast\""});
    return form;
  }

  Form resources() {
    Form form;
    for (const auto& resource : words.resources)
      if (form.items.empty() || random.chance(50)) form.add(resource);
    return form;
  }

  void addOutcomes(Form& form, const char* keyword, const std::vector<std::string>& tags) {
    if (tags.empty()) return;
    form.add(keyword);
    if (tags.size() == 1 && random.chance(60)) {
      form.add(tags[0]);
      if (random.chance(70)) form.add(clause());
      return;
    }
    Form all;
    for (const auto& tag : tags) all.addAll({tag, clause()});
    form.add(all);
  }

  Form clause() {
    Form form;
    if (random.chance(70)) form.addAll({":effects", phrase.effects()});
    if (random.chance(30) || form.items.empty())
      form.addAll({":postcondition", list(phrase.condition())});
    return form;
  }

  void addProperty(std::size_t number) {
    static const std::vector<std::string> heads{"always", "never",   "reachable",
                                                "absent", "present", "always_reachable"};
    Form body{"deadlockfree"};
    if (size.scopes > 0 && random.chance(size.scopes))
      body = withScope();
    else if (random.chance(30))
      body = ofRuns();
    else if (!random.chance(15))
      body = {random.pick(heads), phrase.proposition(2)};
    addFair(body);
    program.push_back({"defproperty", "wish" + std::to_string(number), body});
  }

  /// Adds `:fair` to properties whose verdict may depend on it.
  void addFair(Form& body) {
    const auto& head = body.items.front().word;
    const bool isOfEnd =
        head == "present" || head == "infinitelyoften" || head == "leadsto" || head == "ltl";
    const bool isTimed = std::ranges::find(body.items, Form(":within")) != body.items.end();
    if (!isOfEnd || isTimed || !random.chance(30)) return;
    body.add(":fair");
    if (random.chance(70))
      body.add("nil");
    else if (random.chance(30))
      body.add("t");
    else
      body.add(someSkills());
  }

  Form someSkills() {
    Form some{random.pick(words.skills).name};
    for (const auto& skill : words.skills)
      if (skill.name != some.items.front().word && random.chance(30)) some.add(skill.name);
    return some;
  }

  /// A pattern with scopes and times, in a meaningful combination.
  Form withScope() {
    static const std::vector<std::string> heads{"present", "absent", "leadsto"};
    if (random.chance(20))
      return {random.chance(50) ? "longest" : "shortest", phrase.proposition(1),
              phrase.proposition(1)};
    const auto head = random.pick(heads);
    Form form{head, phrase.proposition(1)};
    if (head == "leadsto") {
      form.addAll({phrase.proposition(1), ":within", phrase.interval()});
      return form;
    }
    const bool after = random.chance(60);
    const bool before = !after && random.chance(60);
    if (after || before) form.addAll({after ? ":after" : ":before", phrase.proposition(1)});
    if (head == "present" && !before && random.chance(40))
      form.addAll({":lasting", std::to_string(random.between(1, size.seconds))});
    else if (random.chance(75) || (!after && !before))
      form.addAll({head == "present" ? ":within" : ":for", phrase.interval()});
    return form;
  }

  Form ofRuns() {
    if (size.next > 0 && random.chance(size.next)) return {"ltl", formula(3)};
    if (random.chance(40)) return {"infinitelyoften", phrase.proposition(1)};
    if (random.chance(40))
      return {random.chance(50) ? "leadsto" : "precedes", phrase.proposition(1),
              phrase.proposition(1)};
    return {"ltl", formula(2)};
  }

  Form formula(std::size_t depth) {
    if (depth == 0) return phrase.proposition(1);
    if (size.next > 0 && random.chance(size.next))
      return {Form(random.chance(50) ? "()" : "X"), formula(depth - 1)};
    switch (random.below(5)) {
    case 0: return {random.chance(50) ? "[]" : "G", formula(depth - 1)};
    case 1: return {random.chance(50) ? "<>" : "F", formula(depth - 1)};
    case 2: return {random.chance(50) ? "until" : "U", formula(depth - 1), formula(depth - 1)};
    case 3: return {random.pick(kUntils), formula(depth - 1), formula(depth - 1)};
    default: return {random.chance(50) ? "=>" : "or", formula(depth - 1), formula(depth - 1)};
    }
  }

  RandomSource random;
  ProgramSize size;
  Words words;
  Phrases phrase;
  Bodies bodies;
  std::vector<Form> program;
};

} // namespace

std::vector<Form> randomProgram(std::uint64_t seed, const ProgramSize& size) {
  return Definitions(seed, size).write();
}

} // namespace proskill::test
