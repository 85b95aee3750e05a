#include "bridge/rl/compose.h"

#include "graph/components.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace proskill::bridge::rl {
namespace {

/// What a composite, or a method that is declared only, is in the program.
struct Known {
  const Composite* composite = nullptr;
  Callable callable;
  std::vector<bool> isRobot; ///< by parameter
};
using KnownComposites = std::map<std::string, Known>;

/// The parameters of one composite: values, and robots, which stand for a skillset.
struct Parameters {
  std::map<std::string, std::string> types;  ///< of values, in the program
  std::map<std::string, std::string> robots; ///< their skillsets
};

/// Writes the body of one composite.
class Body {
public:
  Body(Translation& to, const KnownComposites& known, const Parameters& parameters,
       std::string called)
      : to(to), known(known), parameters(parameters), name(std::move(called)) {}

  /// Statements after which the term has succeeded. \param failure what follows if it fails
  Block of(const Term& term, const Block& failure) {
    switch (term.kind) {
    case TermKind::Name: return condition(term, failure);
    case TermKind::Call: return call(term, failure);
    case TermKind::Skill: return skill(term, failure);
    case TermKind::Ros: return ros(term, failure);
    case TermKind::Sequence:
    case TermKind::And: return sequence(term, failure);
    case TermKind::Choice:
    case TermKind::Or: return choice(term, failure);
    case TermKind::Parallel: return parallel(term, failure);
    case TermKind::Race: return race(term, failure);
    case TermKind::If: return branches(term, failure);
    }
    return {};
  }

private:
  static Block jump(const std::string& label) { return {list("goto", label)}; }
  static Form labelled(const std::string& label) { return list("label", label); }

  void fail(const Place& place, std::string message) {
    to.errors.push_back({place, std::move(message)});
  }

  static Block when(Form condition, const Block& failure) {
    Form test = list("if", std::move(condition));
    append(test.parts, failure);
    return {test};
  }

  Block condition(const Term& term, const Block& failure) {
    const auto type = parameters.types.find(term.name.text);
    if (type != parameters.types.end() && type->second == "bool")
      return when(list("not", "$" + asName(term.name.text)), failure);
    fail(term.place,
         fmt::format("`{}` is neither a call nor a parameter of type `bool`", term.name.text));
    return {};
  }

  Block called(const Term& term, const Callable& what, const std::vector<Term>& arguments,
               const Block& failure) {
    if (arguments.size() != what.inputs.size())
      fail(term.place,
           fmt::format("`{}` takes {}, not {}", term.name.text,
                       counted(what.inputs.size(), "argument", "arguments"), arguments.size()));
    Form form = list(what.name);
    for (std::size_t i = 0; i < std::min(arguments.size(), what.inputs.size()); ++i)
      append(form.parts, {what.inputs[i], argument(arguments[i], what.types[i])});
    form.comment = to.comment({term.name.text, term.place}, "call");
    auto statements = when(list("/=", what.name + ".status", "success"), failure);
    statements.insert(statements.begin(), std::move(form));
    return statements;
  }

  Form argument(const Term& term, const std::string& wanted) {
    const auto type = parameters.types.find(term.name.text);
    if (term.kind != TermKind::Name || type == parameters.types.end())
      fail(term.place, "an argument must be a parameter of the composite");
    else if (type->second != wanted)
      fail(term.place, fmt::format("`{}` is of type `{}` in the program; `{}` is needed",
                                   term.name.text, type->second, wanted));
    return "$" + asName(term.name.text);
  }

  Block call(const Term& term, const Block& failure) {
    const auto found = known.find(term.name.text);
    if (found == known.end()) {
      fail(term.place, fmt::format("unknown composite `{}`", term.name.text));
      return {};
    }
    return called(term, found->second.callable, valuesOf(term, found->second), failure);
  }

  /// The arguments without the robots, of which each skillset has one.
  std::vector<Term> valuesOf(const Term& term, const Known& callee) {
    const auto& wanted = callee.composite->parameters;
    std::vector<Term> values;
    for (std::size_t i = 0; i < term.parts.size(); ++i)
      if (i < wanted.size() && callee.isRobot[i])
        needRobot(term.parts[i], wanted[i].type);
      else
        values.push_back(term.parts[i]);
    return values;
  }

  void needRobot(const Term& term, const std::string& skillset) {
    const auto robot = parameters.robots.find(term.name.text);
    if (term.kind != TermKind::Name || robot == parameters.robots.end() ||
        robot->second != skillset)
      fail(term.place, fmt::format("a robot with `{}` is needed", skillset));
  }

  Block skill(const Term& term, const Block& failure) {
    const auto robot = parameters.robots.find(term.owner.text);
    const auto& skillset = robot == parameters.robots.end() ? term.owner.text : robot->second;
    const auto found = to.callable.find({skillset, term.name.text});
    if (found != to.callable.end()) return called(term, found->second, term.parts, failure);
    fail(term.place, fmt::format("unknown skill `{}.{}`", term.owner.text, term.name.text));
    return {};
  }

  /// A basic skill for each use, whose action has the topic and the arguments.
  Block ros(const Term& term, const Block& failure) {
    Callable made{to.names.take("ros_" + term.name.text + "_" + asName(term.owner.text)), {}, {}};
    Form command = list("ros_" + term.name.text, asString(term.owner.text));
    std::vector<Form> inputs;
    for (const auto& each : term.parts) {
      const auto type = parameters.types.find(each.name.text);
      made.inputs.push_back(fmt::format("argument_{}", made.inputs.size() + 1));
      made.types.push_back(type == parameters.types.end() ? "string" : type->second);
      command.parts.emplace_back("$" + made.inputs.back());
      append(inputs, {"$" + made.inputs.back(), made.types.back()});
    }
    Form skill = list("defskill", made.name);
    skill.comment = to.comment({term.owner.text, term.place}, ("ros." + term.name.text).c_str());
    if (!inputs.empty()) append(skill.parts, {":input", Form(std::move(inputs))});
    append(skill.parts, {":action", command, ":success", "done"});
    if (term.name.text != "publish") append(skill.parts, {":failure", "failed"});
    to.skills.push_back(std::move(skill));
    auto statements = called(term, made, term.parts, failure);
    if (term.name.text == "publish") statements.erase(statements.begin() + 1, statements.end());
    return statements;
  }

  Block sequence(const Term& term, const Block& failure) {
    Block all;
    for (const auto& part : term.parts) append(all, of(part, failure));
    return all;
  }

  Block choice(const Term& term, const Block& failure) {
    Block all;
    const auto done = labels.take("done");
    for (std::size_t i = 0; i + 1 < term.parts.size(); ++i) {
      const auto next = labels.take("next");
      append(all, of(term.parts[i], jump(next)));
      append(all, {list("goto", done), labelled(next)});
    }
    append(all, of(term.parts.back(), failure));
    all.push_back(labelled(done));
    return all;
  }

  Block branches(const Term& term, const Block& failure) {
    Block all;
    const auto done = labels.take("done");
    for (std::size_t i = 0; i + 1 < term.parts.size(); i += 2) {
      const auto otherwise = labels.take("otherwise");
      append(all, of(term.parts[i], jump(otherwise)));
      append(all, of(term.parts[i + 1], failure));
      append(all, {list("goto", done), labelled(otherwise)});
    }
    append(all, of(term.parts.back(), failure));
    all.push_back(labelled(done));
    return all;
  }

  /// A branch that ends with one effect where it succeeds, and with another one where it fails.
  Form branch(const Term& term, const Block& success, const Block& failure) {
    const auto failed = labels.take("failed");
    const auto done = labels.take("done");
    auto all = of(term, jump(failed));
    append(all, success);
    append(all, {list("goto", done), labelled(failed)});
    append(all, failure);
    all.push_back(labelled(done));
    return Form(std::move(all));
  }

  Block parallel(const Term& term, const Block& failure) {
    const auto all = variable("_all", {":states", list("Succeed", "Fail"), ":init", "Succeed"});
    Form branches = list("//");
    for (const auto& part : term.parts)
      branches.parts.push_back(branch(part, {}, {list("set", list(all, "Fail"))}));
    Block statements{list("set", list(all, "Succeed")), branches};
    append(statements, when(list(all, "Fail"), failure));
    return statements;
  }

  Block race(const Term& term, const Block& failure) {
    const auto first =
        variable("_first", {":states", list("Succeeds", "Fails"), ":init", "Succeeds"});
    Form all = list("race");
    for (const auto& part : term.parts)
      all.parts.push_back(branch(part, {list("set", list(first, "Succeeds"))},
                                 {list("set", list(first, "Fails"))}));
    Block statements{all};
    append(statements, when(list(first, "Fails"), failure));
    return statements;
  }

  std::string variable(const char* suffix, const Block& fields) {
    auto called = to.names.take(name + suffix);
    Form form = list("defsv", called);
    append(form.parts, fields);
    to.variables.push_back(std::move(form));
    return called;
  }

  Translation& to;
  const KnownComposites& known;
  const Parameters& parameters;
  const std::string name;
  NamePool labels;
};

class Composites {
public:
  Composites(Translation& to, const std::vector<Skillset>& all) : to(to) {
    for (const auto& skillset : all) skillsets.insert(skillset.name.text);
  }

  void declare(const Composite& composite) {
    Known made{&composite, {to.names.take(composite.name.text), {}, {}}, {}};
    for (const auto& parameter : composite.parameters) {
      made.isRobot.push_back(skillsets.contains(parameter.type));
      if (made.isRobot.back()) continue;
      made.callable.inputs.push_back(asName(parameter.name.text));
      made.callable.types.emplace_back(typeOf(parameter.type));
    }
    if (!known.emplace(composite.name.text, std::move(made)).second)
      fail(composite.name, fmt::format("a second composite is called `{}`", composite.name.text));
  }

  void add(const Composite& composite) {
    const auto& made = known.at(composite.name.text).callable;
    const auto parameters = parametersOf(composite);
    Form form = list("defskill", made.name);
    form.comment = to.comment(composite.name, composite.body ? "def" : "dec");
    std::vector<Form> inputs;
    for (std::size_t i = 0; i < made.inputs.size(); ++i)
      append(inputs, {"$" + made.inputs[i], made.types[i]});
    if (!inputs.empty()) append(form.parts, {":input", Form(std::move(inputs))});
    if (composite.body)
      addBody(composite, made, parameters, form);
    else
      addAction(made, form);
    to.skills.push_back(std::move(form));
  }

  /// ProSkill has no recursion. The first composite of a cycle is reported.
  void checkCycles(const std::vector<Composite>& all) {
    std::vector<std::vector<graph::Node>> callees(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].body) addCallees(*all[i].body, all, callees[i]);
    const auto cycles = graph::componentsOf(all.size(), [&](graph::Node caller, std::size_t i) {
      return i < callees[caller].size() ? callees[caller][i] : graph::kNoNode;
    });
    std::set<graph::Node> reported;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool isInCycle = std::ranges::any_of(
          callees[i], [&](graph::Node callee) { return cycles[callee] == cycles[i]; });
      if (isInCycle && reported.insert(cycles[i]).second)
        fail(all[i].name, fmt::format("`{}` calls itself", all[i].name.text));
    }
  }

  /// Calls what has parameters and is not called.
  void addStarts(const std::vector<Composite>& all) {
    for (const auto& composite : all) {
      const auto& callable = known.at(composite.name.text).callable;
      if (!composite.body || callable.inputs.empty() || isCalled.contains(composite.name.text))
        continue;
      if (auto made = startOf(callable, to.names))
        append(to.skills, *made);
      else
        fail(composite.name, std::move(made.error()));
    }
  }

private:
  void fail(const Word& at, std::string message) {
    to.errors.push_back({at.place, std::move(message)});
  }

  Parameters parametersOf(const Composite& composite) {
    Parameters made;
    std::set<std::string> seen;
    for (const auto& [name, type] : composite.parameters) {
      if (!seen.insert(asName(name.text)).second)
        fail(name, fmt::format("a second parameter is called `{}`", name.text));
      if (!skillsets.contains(type)) {
        made.types.emplace(name.text, typeOf(type));
        continue;
      }
      const bool isSecond =
          std::ranges::any_of(made.robots, [&](const auto& other) { return other.second == type; });
      if (isSecond)
        fail(name,
             fmt::format("two robots with `{}` are not supported: the program has one", type));
      made.robots.emplace(name.text, type);
    }
    return made;
  }

  void addBody(const Composite& composite, const Callable& made, const Parameters& parameters,
               Form& form) {
    Body body(to, known, parameters, made.name);
    auto statements = body.of(*composite.body, {list("failure", "failed")});
    statements.push_back(list("success", "done"));
    const Form written(std::move(statements));
    append(form.parts, {":success", "done"});
    if (contains(written, list("failure", "failed"))) append(form.parts, {":failure", "failed"});
    append(form.parts, {":body", written});
  }

  static void addAction(const Callable& made, Form& form) {
    Form command = list(made.name);
    for (const auto& input : made.inputs) command.parts.emplace_back("$" + input);
    append(form.parts, {":action", command, ":success", "done", ":failure", "failed"});
  }

  void addCallees(const Term& term, const std::vector<Composite>& all,
                  std::vector<graph::Node>& callees) {
    const auto found = term.kind == TermKind::Call ? known.find(term.name.text) : known.end();
    if (found != known.end()) {
      isCalled.insert(term.name.text);
      callees.push_back(static_cast<graph::Node>(found->second.composite - all.data()));
    }
    for (const auto& part : term.parts) addCallees(part, all, callees);
  }

  Translation& to;
  std::set<std::string> skillsets;
  KnownComposites known;
  std::set<std::string> isCalled;
};

} // namespace

void addComposites(Translation& to, const std::vector<Skillset>& skillsets,
                   const std::vector<Composite>& composites) {
  Composites all(to, skillsets);
  for (const auto& composite : composites) all.declare(composite);
  all.checkCycles(composites);
  for (const auto& composite : composites) all.add(composite);
  all.addStarts(composites);
}

} // namespace proskill::bridge::rl
