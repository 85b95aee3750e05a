#include "tests/support/random/random_model.h"

#include "tests/fiacre/build.h"
#include "tests/support/random/random_data.h"
#include "tests/support/random/random_observer.h"

#include <algorithm>
#include <set>

namespace proskill::test {

using namespace fiacre;
using namespace fiacre::test;

namespace {

Expr conditional(Expr test, Expr yes, Expr no) {
  return {.kind = ExprKind::Conditional,
          .operands = {std::move(test), std::move(yes), std::move(no)}};
}

/// `robot[index].field`
Expr part(std::string at, std::string member) {
  return field(index(name("robot"), name(std::move(at))), std::move(member));
}

enum class Sort : std::uint8_t { Bool, Number, Colour };

struct Scalar {
  Expr lvalue;
  Sort sort;
};

const std::vector<std::string> kColours{"Red", "Green", "Blue"};

/// Builds a program, from the shared variables inwards.
class Builder {
public:
  explicit Builder(std::uint64_t seed, bool withData = false)
      : random(seed),
        rich(withData),
        haste(random.chance(50) ? 10 : 40),
        caution(random.chance(50) ? 20 : 50) {}

  Program build() {
    declareTypes();
    declareShared();
    std::size_t ports = random.below(rich ? 4 : 3);
    for (std::size_t i = 0; i < ports; ++i) addPort("p" + std::to_string(i));
    if (rich && ports >= 2 && random.chance(60)) component.priorities = {{{"p0"}, {"p1"}}};
    if (rich && ports == 3) component.priorities.push_back({{"p1"}, {"p2"}});
    std::size_t count = 2 + random.below(3);
    for (std::size_t i = 0; i < count; ++i) addProcess(i);
    program.components.push_back(component);
    program.main = component.name;
    for (std::size_t i = 0; i < count; ++i) askForStates(i);
    askForTheRest();
    return std::move(program);
  }

private:
  void declareTypes() {
    program.types = {{"colour", unionOf(kColours), {}},
                     {"robot_record", record({{"busy", boolean()}, {"mood", named("colour")}}), {}},
                     {"robot_array", array(2, named("robot_record")), {}}};
    program.constants = {{"left", nat(), number(0)}, {"right", nat(), number(1)}};
    Statement body{.kind = StatementKind::Return,
                   .values = {binary(Op::And, name("first_one"),
                                     binary(Op::Equal, name("second_one"), name("Red")))}};
    program.functions = {
        {.name = "both",
         .parameters = {{"first_one", boolean(), false}, {"second_one", named("colour"), false}},
         .result = boolean(),
         .body = body}};
  }

  void declareShared() {
    component.name = "Main";
    addShared("flag", boolean(), truth(random.chance(50)), Sort::Bool);
    addShared("level", range(0, 2), number(random.between(0, 2)), Sort::Number);
    if (random.chance(60))
      addShared("paint", named("colour"), name(random.pick(kColours)), Sort::Colour);
    if (rich) addRandomData(program, component);
    if (rich || random.chance(60)) return;
    Expr robots{.kind = ExprKind::Array};
    for (int i = 0; i < 2; ++i)
      robots.operands.push_back(
          {.kind = ExprKind::Record,
           .fields = {"busy", "mood"},
           .operands = {truth(random.chance(50)), name(random.pick(kColours))}});
    component.variables.push_back({"robot", named("robot_array"), robots, {}});
    for (const char* index : {"left", "right"}) {
      scalars.push_back({part(index, "busy"), Sort::Bool});
      scalars.push_back({part(index, "mood"), Sort::Colour});
    }
  }

  void addShared(std::string text, Type type, Expr init, Sort sort) {
    scalars.push_back({name(text), sort});
    component.variables.push_back({std::move(text), std::move(type), std::move(init), {}});
  }

  void addPort(std::string text) {
    Port added{.name = std::move(text)};
    if (random.chance(70)) added.interval = interval();
    if (rich && random.chance(60)) {
      added.values = random.pick(std::vector<std::vector<Type>>{
          {range(0, 2)}, {named("letter_type")}, {boolean(), range(0, 2)}});
      added.in = added.out = true;
    }
    component.ports.push_back(added);
  }

  /// What a process stores of received values.
  void declareMail(Process& process) {
    if (std::ranges::all_of(process.ports, [](const auto& port) { return port.values.empty(); }))
      return;
    process.variables.push_back({"got", range(0, 2), number(0), {}});
    process.variables.push_back({"seen", boolean(), truth(false), {}});
    process.variables.push_back({"mail", named("letter_type"), name("nothing"), {}});
    local.push_back({name("got"), Sort::Number});
    local.push_back({name("seen"), Sort::Bool});
    if (random.chance(25))
      process.variables.push_back({"box", named("box_type"), Expr{.kind = ExprKind::Queue}, {}});
  }

  /// A value to send.
  Expr sent(const Type& type) {
    if (type.kind == TypeKind::Bool)
      return random.pick(std::vector<Expr>{name("flag"), name("seen"), truth(true)});
    if (type.kind == TypeKind::Range)
      return random.pick(std::vector<Expr>{name("level"), name("got"), number(1),
                                           index(name("cells"), name("level"))});
    return random.pick(std::vector<Expr>{name("letter"), name("mail"), name("nothing"),
                                         call("some", {name("level")}),
                                         call("other", {name("flag")})});
  }

  /// `p!x` or `p?y`, and a use of the received value.
  void communicate(const Port& by, const Process& process, std::vector<Statement>& steps) {
    const bool sends = random.chance(50);
    Statement made{.kind = sends ? StatementKind::Send : StatementKind::Receive, .name = by.name};
    for (const auto& type : by.values) {
      if (sends) {
        made.values.push_back(sent(type));
        continue;
      }
      made.targets.push_back(name(type.kind == TypeKind::Bool    ? "seen"
                                  : type.kind == TypeKind::Range ? "got"
                                                                 : "mail"));
    }
    if (!sends && random.chance(30)) made.values.push_back(test(local));
    steps.push_back(std::move(made));
    if (sends) return;
    const bool hasBox =
        std::ranges::find(process.variables, "box", &Variable::name) != process.variables.end();
    if (hasBox && random.chance(60))
      steps.push_back(ifElse(unary(Op::Full, name("box")),
                             assign(name("mail"), unary(Op::First, name("box"))),
                             assign(name("box"), binary(Op::Enqueue, name("box"), name("mail")))));
    if (random.chance(30))
      steps.push_back({.kind = StatementKind::Case,
                       .values = {name("mail"), call("some", {name("got")}), name("any")},
                       .children = {assign(name("seen"), truth(true)), null()}});
  }

  Interval interval() {
    Interval result;
    if (random.chance(haste)) return Interval{0, 0, false, false};
    result.lower = random.between(0, 3);
    result.lowerOpen = random.chance(25);
    if (random.chance(25)) return result;
    std::int64_t least = result.lower + (result.lowerOpen ? 1 : 0);
    result.upper = random.between(least, std::max<std::int64_t>(least, 4));
    result.upperOpen = *result.upper > result.lower && random.chance(25);
    if (result.lowerOpen && result.upperOpen && *result.upper == result.lower + 1)
      result.upperOpen = false;
    return result;
  }

  Expr valueOf(const Scalar& scalar) {
    switch (scalar.sort) {
    case Sort::Bool: return random.chance(30) ? negation(scalar.lvalue) : truth(random.chance(50));
    case Sort::Colour: return name(random.pick(kColours));
    case Sort::Number: break;
    }
    if (random.chance(60)) return number(random.between(0, 2));
    return conditional(binary(Op::Less, scalar.lvalue, number(2)),
                       binary(Op::Add, scalar.lvalue, number(1)), number(0));
  }

  Expr test(const std::vector<Scalar>& among) {
    if (rich && random.chance(35)) return randomDataTest(random);
    const Scalar& scalar = random.pick(among);
    Expr result = scalar.lvalue;
    if (scalar.sort == Sort::Colour) {
      result = binary(Op::Equal, scalar.lvalue, name(random.pick(kColours)));
      if (random.chance(15)) result = call("both", {name("flag"), scalar.lvalue});
    }
    if (scalar.sort == Sort::Number)
      result = binary(random.chance(50) ? Op::LessEqual : Op::NotEqual, scalar.lvalue,
                      number(random.between(0, 2)));
    if (random.chance(30)) result = negation(std::move(result));
    if (random.chance(15))
      result = binary(random.chance(50) ? Op::And : Op::Or, result, test(among));
    return result;
  }

  void addProcess(std::size_t index) {
    Process made{.name = "P" + std::to_string(index)};
    Instance instance;
    instance.process = made.name;
    for (const auto& variable : component.variables) {
      made.parameters.push_back({variable.name, variable.type, true});
      instance.arguments.push_back(name(variable.name));
      instance.references.push_back(true);
    }
    for (const auto& offered : component.ports) {
      if (!random.chance(60)) continue;
      made.ports.push_back(offered);
      instance.ports.push_back(offered.name);
    }
    local = scalars;
    if (random.chance(50)) {
      made.variables.push_back({"count", range(0, 2), number(0), {}});
      local.push_back({name("count"), Sort::Number});
    }
    if (rich) declareMail(made);
    std::size_t states = 2 + random.below(3);
    for (std::size_t i = 0; i < states; ++i) made.states.push_back({"s" + std::to_string(i), 0});
    for (std::size_t i = 0; i < states; ++i)
      if (i == 0 || random.chance(95)) made.transitions.push_back(stateBody(made, index, i));
    program.processes.push_back(std::move(made));
    component.instances.push_back(std::move(instance));
  }

  From stateBody(const Process& process, std::size_t index, std::size_t state) {
    std::vector<Statement> branches;
    std::size_t count = 1 + random.below(3);
    for (std::size_t i = 0; i < count; ++i) branches.push_back(path(process, index));
    From result;
    result.state = process.states[state].name;
    result.statement = count == 1 ? branches[0] : select(std::move(branches));
    if (rich && count > 1 && result.statement.children.size() > 1 && isSilent(result.statement) &&
        random.chance(50))
      result.statement.priorityGroups = {1 + random.below(count - 1)};
    return result;
  }

  static bool isSilent(const Statement& statement) {
    return statement.kind != StatementKind::Send && statement.kind != StatementKind::Receive &&
           std::ranges::all_of(statement.children, isSilent);
  }

  Statement path(const Process& process, std::size_t index) {
    std::vector<Statement> steps;
    bool onPort = !process.ports.empty() && random.chance(30);
    if (random.chance(caution)) steps.push_back(on(test(local)));
    if (onPort) {
      const Port& by = random.pick(process.ports);
      if (by.values.empty())
        steps.push_back(port(by.name));
      else
        communicate(by, process, steps);
    } else if (random.chance(90)) {
      steps.push_back({.kind = StatementKind::Wait, .interval = interval()});
    }
    if (random.chance(20)) steps.push_back(someTag(index));
    if (random.chance(50)) steps.push_back(change(onPort, index));
    if (rich && !onPort && random.chance(60)) steps.push_back(randomDataChange(random));
    if (random.chance(25))
      steps.push_back(choice(random.chance(50) ? someTag(index) : change(onPort, index)));
    if (random.chance(15)) steps.push_back(choice(end(process)));
    steps.push_back(end(process));
    return sequence(std::move(steps));
  }

  Statement someTag(std::size_t index) {
    std::string text = "t" + std::to_string(random.below(3));
    tags.emplace(static_cast<std::uint32_t>(index + 1), text);
    return tag(text);
  }

  Statement choice(Statement then) { return ifThen(test(local), std::move(then)); }

  Statement end(const Process& process) {
    if (random.chance(15)) return {.kind = StatementKind::Loop};
    return to(random.pick(process.states).name);
  }

  // Two parts of one step never write the same variable: on a port, each process has its own.
  Statement change(bool onPort, std::size_t index) {
    if (onPort && index >= scalars.size()) return null();
    const Scalar& scalar = onPort ? scalars[index] : random.pick(local);
    return assign(scalar.lvalue, valueOf(scalar));
  }

  void ask(PatternKind kind, std::vector<Observable> operands) {
    Property property;
    property.name = "q" + std::to_string(program.properties.size());
    property.pattern.kind = kind;
    property.pattern.operands = std::move(operands);
    program.properties.push_back(std::move(property));
  }

  void askForStates(std::size_t index) {
    for (const auto& state : program.processes[index].states)
      ask(PatternKind::Absent, {stateOf(static_cast<std::uint32_t>(index + 1), state.name)});
  }

  void askForTheRest() {
    for (const auto& [instance, text] : tags)
      ask(PatternKind::Absent, {{.kind = ObservableKind::Tag, .path = {instance}, .name = text}});
    for (const auto& offered : component.ports)
      ask(PatternKind::Absent, {{.kind = ObservableKind::Event, .name = offered.name}});
    ask(PatternKind::Absent,
        {{.kind = random.chance(50) ? ObservableKind::Enter : ObservableKind::Leave,
          .operands = {value()}}});
    for (int i = 0; i < 3; ++i)
      ask(random.chance(50) ? PatternKind::Always : PatternKind::Absent, {value()});
    ask(PatternKind::Absent,
        {{.kind = ObservableKind::And, .operands = {value(), stateOf(1, "s1")}}});
    ask(PatternKind::DeadlockFree, {});
    ask(PatternKind::DeadlockFree, {stateOf(1, "s1")});
    ask(PatternKind::Progress, {});
    ask(PatternKind::AlwaysReachable, {value()});
    ask(PatternKind::AlwaysReachable, {stateOf(1, "s1")});
    if (!component.ports.empty())
      ask(PatternKind::AlwaysReachable,
          {{.kind = ObservableKind::Event, .name = component.ports[0].name}});
  }

  Observable value() { return {.kind = ObservableKind::Value, .value = test(scalars)}; }

  RandomSource random;
  bool rich;        ///< with data
  unsigned haste;   ///< per cent of intervals that are [0,0]
  unsigned caution; ///< per cent of paths with a guard
  Program program;
  Component component;
  std::vector<Scalar> scalars;                          ///< of the shared variables
  std::set<std::pair<std::uint32_t, std::string>> tags; ///< by instance
  std::vector<Scalar> local;                            ///< including the current process
};

} // namespace

Program randomModel(std::uint64_t seed) { return Builder(seed).build(); }

Program randomModelWithData(std::uint64_t seed) { return Builder(seed, true).build(); }

Program randomModelWithObserver(std::uint64_t seed) {
  auto program = Builder(seed, seed % 2 == 1).build();
  RandomSource random(seed);
  addRandomObserver(random, program);
  return program;
}

} // namespace proskill::test
