#include "tests/support/random_model.h"

#include "tests/support/random_source.h"
#include "tests/support/tree.h"

namespace proskill::test {

using namespace fiacre;

namespace {

/// `robot[index].field`
Expr part(std::string index, std::string field) {
  Expr element;
  element.kind = ExprKind::Index;
  element.operands = {name("robot"), name(std::move(index))};
  Expr expr;
  expr.kind = ExprKind::Field;
  expr.name = std::move(field);
  expr.operands = {std::move(element)};
  return expr;
}

enum class Sort : std::uint8_t { Bool, Number, Colour };

struct Scalar {
  Expr lvalue;
  Sort sort;
};

const std::vector<std::string> kColours{"Red", "Green", "Blue"};

/// Builds one program, from the shared variables inwards.
class Builder {
public:
  explicit Builder(std::uint64_t seed) : random(seed) {}

  Program build() {
    declareTypes();
    declareShared();
    std::size_t ports = random.below(3);
    for (std::size_t i = 0; i < ports; ++i) addPort("p" + std::to_string(i));
    std::size_t count = 2 + random.below(2);
    for (std::size_t i = 0; i < count; ++i) addProcess(i);
    program.components.push_back(component);
    program.main = component.name;
    for (std::size_t i = 0; i < count; ++i) askForStates(i);
    askForTheRest();
    return std::move(program);
  }

private:
  void declareTypes() {
    Type colour = plain(TypeKind::Union);
    for (const auto& text : kColours) colour.members.push_back(member(text));
    program.types.push_back({"colour", colour, {}});
    Type record = plain(TypeKind::Record);
    record.members = {member("busy", {plain(TypeKind::Bool)}), member("mood", {named("colour")})};
    program.types.push_back({"robot_record", record, {}});
    Type array = plain(TypeKind::Array);
    array.size = 2;
    array.element = {named("robot_record")};
    program.types.push_back({"robot_array", array, {}});
    program.constants = {{"left", plain(TypeKind::Nat), number(0)},
                         {"right", plain(TypeKind::Nat), number(1)}};
    Function twice;
    twice.name = "both";
    twice.parameters = {{"first_one", plain(TypeKind::Bool), false},
                        {"second_one", named("colour"), false}};
    twice.result = plain(TypeKind::Bool);
    twice.body =
        with(StatementKind::Return, binary(Op::And, name("first_one"),
                                           binary(Op::Equal, name("second_one"), name("Red"))));
    program.functions.push_back(twice);
  }

  void declareShared() {
    component.name = "Main";
    addShared("flag", plain(TypeKind::Bool), boolean(random.chance(50)), Sort::Bool);
    addShared("level", range(0, 2), number(random.between(0, 2)), Sort::Number);
    if (random.chance(60))
      addShared("paint", named("colour"), name(random.pick(kColours)), Sort::Colour);
    if (random.chance(60)) return;
    Expr array;
    array.kind = ExprKind::Array;
    for (int i = 0; i < 2; ++i) {
      Expr record;
      record.kind = ExprKind::Record;
      record.fields = {"busy", "mood"};
      record.operands = {boolean(random.chance(50)), name(random.pick(kColours))};
      array.operands.push_back(record);
    }
    component.variables.push_back({"robot", named("robot_array"), array, {}});
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
    Port port;
    port.name = std::move(text);
    if (random.chance(70)) port.interval = interval();
    component.ports.push_back(port);
  }

  Interval interval() {
    Interval result;
    if (random.chance(40)) return Interval{0, 0, false, false};
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
    case Sort::Bool:
      return random.chance(30) ? negation(scalar.lvalue) : boolean(random.chance(50));
    case Sort::Colour: return name(random.pick(kColours));
    case Sort::Number: break;
    }
    if (random.chance(60)) return number(random.between(0, 2));
    return conditional(binary(Op::Less, scalar.lvalue, number(2)),
                       binary(Op::Add, scalar.lvalue, number(1)), number(0));
  }

  Expr test(const std::vector<Scalar>& among) {
    const Scalar& scalar = random.pick(among);
    Expr result = scalar.lvalue;
    if (scalar.sort == Sort::Colour) {
      result = binary(Op::Equal, scalar.lvalue, name(random.pick(kColours)));
      if (random.chance(15)) result = call(scalar.lvalue);
    }
    if (scalar.sort == Sort::Number)
      result = binary(random.chance(50) ? Op::LessEqual : Op::NotEqual, scalar.lvalue,
                      number(random.between(0, 2)));
    if (random.chance(30)) result = negation(std::move(result));
    if (random.chance(15))
      result = binary(random.chance(50) ? Op::And : Op::Or, result, test(among));
    return result;
  }

  static Expr call(const Expr& colour) {
    Expr expr;
    expr.kind = ExprKind::Construct;
    expr.name = "both";
    expr.operands = {name("flag"), colour};
    return expr;
  }

  void addProcess(std::size_t index) {
    Process process;
    process.name = "P" + std::to_string(index);
    Instance instance;
    instance.process = process.name;
    for (const auto& variable : component.variables) {
      process.parameters.push_back({variable.name, variable.type, true});
      instance.arguments.push_back(name(variable.name));
      instance.references.push_back(true);
    }
    for (const auto& port : component.ports) {
      if (!random.chance(60)) continue;
      process.ports.push_back(port);
      instance.ports.push_back(port.name);
    }
    local = scalars;
    if (random.chance(50)) {
      process.variables.push_back({"count", range(0, 2), number(0), {}});
      local.push_back({name("count"), Sort::Number});
    }
    std::size_t states = 2 + random.below(3);
    for (std::size_t i = 0; i < states; ++i) process.states.push_back({"s" + std::to_string(i), 0});
    for (std::size_t i = 0; i < states; ++i)
      if (i == 0 || random.chance(85)) process.transitions.push_back(from(process, index, i));
    program.processes.push_back(std::move(process));
    component.instances.push_back(std::move(instance));
  }

  From from(const Process& process, std::size_t index, std::size_t state) {
    std::vector<Statement> branches;
    std::size_t count = 1 + random.below(3);
    for (std::size_t i = 0; i < count; ++i) branches.push_back(path(process, index));
    From result;
    result.state = process.states[state].name;
    result.statement = count == 1 ? branches[0] : block(StatementKind::Select, std::move(branches));
    return result;
  }

  Statement path(const Process& process, std::size_t index) {
    std::vector<Statement> steps;
    bool onPort = !process.ports.empty() && random.chance(30);
    if (random.chance(50)) steps.push_back(with(StatementKind::On, test(local)));
    if (onPort) {
      steps.push_back(statement(StatementKind::Send, random.pick(process.ports).name));
    } else if (random.chance(90)) {
      steps.push_back(statement(StatementKind::Wait));
      steps.back().interval = interval();
    }
    if (random.chance(20)) steps.push_back(tag());
    if (random.chance(50)) steps.push_back(change(onPort, index));
    if (random.chance(25))
      steps.push_back(choice(random.chance(50) ? tag() : change(onPort, index)));
    if (random.chance(15)) steps.push_back(choice(end(process)));
    steps.push_back(end(process));
    return block(StatementKind::Sequence, std::move(steps));
  }

  Statement tag() { return statement(StatementKind::Tag, "t" + std::to_string(random.below(3))); }

  Statement choice(Statement then) {
    Statement result = with(StatementKind::If, test(local));
    result.children = {std::move(then)};
    return result;
  }

  Statement end(const Process& process) {
    if (random.chance(15)) return statement(StatementKind::Loop);
    return statement(StatementKind::To, random.pick(process.states).name);
  }

  // Two parts of one step never write the same variable: on a port, each process has its own.
  Statement change(bool onPort, std::size_t index) {
    if (onPort && index >= scalars.size()) return statement(StatementKind::Null);
    const Scalar& scalar = onPort ? scalars[index] : random.pick(local);
    if (!onPort && scalar.sort == Sort::Colour && random.chance(20)) {
      Statement any = statement(StatementKind::Any);
      any.targets = {scalar.lvalue};
      if (random.chance(50)) any.values = {test({scalar})};
      return any;
    }
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
    for (std::uint32_t i = 0; i < component.instances.size(); ++i)
      for (int t = 0; t < 3; ++t) {
        Observable observable = stateOf(i + 1, "t" + std::to_string(t));
        observable.kind = ObservableKind::Tag;
        ask(PatternKind::Absent, {observable});
      }
    for (int i = 0; i < 3; ++i)
      ask(random.chance(50) ? PatternKind::Always : PatternKind::Absent, {value()});
    Observable both;
    both.kind = ObservableKind::And;
    both.operands = {value(), stateOf(1, "s1")};
    ask(PatternKind::Absent, {both});
    ask(PatternKind::DeadlockFree, {});
    ask(PatternKind::DeadlockFree, {stateOf(1, "s1")});
    ask(PatternKind::Progress, {});
  }

  Observable value() {
    Observable observable;
    observable.kind = ObservableKind::Value;
    observable.value = test(scalars);
    return observable;
  }

  RandomSource random;
  Program program;
  Component component;
  std::vector<Scalar> scalars; ///< of the shared variables
  std::vector<Scalar> local;   ///< of the process in hand, too
};

} // namespace

Program randomModel(std::uint64_t seed) { return Builder(seed).build(); }

} // namespace proskill::test
