#include "fiacre/syntax/parser.h"

#include <fmt/format.h>

namespace proskill::fiacre {

void Parser::function() {
  Function result{.name = name("the name of a function", NameKind::Function, true)};
  actor = "function " + result.name;
  result.parameters = parameters();
  expect(":");
  result.result = type();
  expect("is");
  if (accept("var")) result.variables = variables();
  result.body = functionBody();
  parsed.program.functions.push_back(std::move(result));
}

/// Reads `begin … end`, or a single `return`.
Statement Parser::functionBody() {
  if (isAt("return")) return statement();
  expect("begin");
  auto body = statements();
  expect("end");
  return body;
}

void Parser::process() {
  const auto begin = peek().begin;
  Process result{.name = name("the name of a process", NameKind::Process, true)};
  actor = result.name;
  result.origin = origin(begin);
  if (accept("[")) {
    result.ports = ports();
    expect("]");
  }
  if (isAt("(")) result.parameters = parameters();
  expect("is");
  expect("states");
  do {
    const auto place = peek().begin;
    result.states.push_back({name("the name of a state", NameKind::State, true), 0});
    result.states.back().origin = origin(place, "is in " + result.states.back().name);
  } while (accept(","));
  if (accept("var")) result.variables = variables();
  if (accept("init")) result.init = statements();
  while (isAt("from")) from(result);
  parsed.program.processes.push_back(std::move(result));
}

/// Reads a transition. One with an error is skipped.
void Parser::from(Process& process) try {
  const auto begin = peek().begin;
  expect("from");
  From result{.state = name("the name of a state", NameKind::State)};
  result.statement = statements();
  result.origin = origin(begin);
  process.transitions.push_back(std::move(result));
  // the name of the entry point is on its own
  if (!isAt("from") && !isAtDeclaration() && !(isAtName() && endsEntry(1)))
    fail(fmt::format("`;` is missing before `{}`, or it closes nothing", peek().text));
} catch (const CannotRead&) {
  while (!isAt("from") && !isAtDeclaration()) ++at;
}

void Parser::component() {
  Component result{.name = name("the name of a component", NameKind::Component, true)};
  actor = result.name;
  if (accept("[")) {
    result.interfacePorts = ports();
    expect("]");
  }
  if (isAt("(")) result.parameters = parameters();
  expect("is");
  for (;;) {
    if (accept("var")) {
      std::ranges::move(variables(), std::back_inserter(result.variables));
    } else if (accept("port")) {
      std::ranges::move(ports(true), std::back_inserter(result.ports));
    } else if (accept("priority")) {
      std::ranges::move(priorities(), std::back_inserter(result.priorities));
    } else {
      break;
    }
  }
  if (accept("init")) result.init = statements();
  expect("par");
  result.instances = composition();
  parsed.program.components.push_back(std::move(result));
}

/// `a
/// b > c > d` means `a
/// b > c` and `c > d`.
std::vector<Priority> Parser::priorities() {
  std::vector<Priority> all;
  const auto group = [&] {
    return list("|", [&] { return name("the name of a port", NameKind::Port); });
  };
  do {
    auto higher = group();
    if (!isAt(">")) fail("`>` is missing");
    while (accept(">")) {
      auto lower = group();
      all.push_back({higher, lower});
      higher = std::move(lower);
    }
  } while (accept(","));
  return all;
}

/// Reads `*` or names, up to `in` or `->`. Reads nothing if something else follows.
bool Parser::acceptPortSet(std::string_view closing, PortSet& ports) {
  if (isAt("*") && isAt(closing, 1)) {
    at += 2;
    ports.reset();
    return true;
  }
  std::size_t ahead = 0;
  while (peek(ahead).kind == TokenKind::Name && isAt(",", ahead + 1)) ahead += 2;
  if (peek(ahead).kind != TokenKind::Name || !isAt(closing, ahead + 1)) return false;
  ports = names("the name of a port", NameKind::Port);
  expect(closing);
  return true;
}

/// Reads a composition after `par`. An instance without ports of its own synchronises on those of
/// the composition.
std::vector<Instance> Parser::composition() {
  const Deeper deeper(*this);
  std::vector<Instance> all;
  PortSet ofAll = std::vector<std::string>{};
  acceptPortSet("in", ofAll);
  do {
    PortSet own = ofAll;
    acceptPortSet("->", own);
    all.push_back(instance());
    all.back().synchronised = own;
  } while (accept("||"));
  expect("end");
  accept("par");
  return all;
}

Instance Parser::instance() {
  if (accept("par")) return {.parts = composition()};
  Instance result{.process = name("the name of a process or a component", NameKind::Process)};
  if (accept("[")) {
    result.ports = names("the name of a port", NameKind::Port);
    expect("]");
  }
  if (!accept("(")) return result;
  do {
    result.references.push_back(accept("&"));
    result.arguments.push_back(expr());
  } while (accept(","));
  expect(")");
  return result;
}

} // namespace proskill::fiacre
