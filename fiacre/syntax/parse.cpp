#include "fiacre/syntax/parse.h"

#include "fiacre/syntax/parser.h"
#include "fiacre/syntax/words.h"

#include <fmt/format.h>

#include <array>

namespace proskill::fiacre {
namespace {

/// Limits the number of problems: a text that is not Fiacre has one per word.
void shorten(std::vector<SyntaxProblem>& problems) {
  constexpr std::size_t most = 1000;
  if (problems.size() <= most) return;
  auto& last = problems[most];
  last.message = fmt::format("{} more errors from here on", problems.size() - most);
  problems.resize(most + 1);
}

template <class Visit> void eachAtom(Observable& observable, const Visit& visit) {
  if (observable.kind <= ObservableKind::Event) visit(observable);
  for (auto& operand : observable.operands) eachAtom(operand, visit);
}

template <class Visit> void eachAtom(Ltl& ltl, const Visit& visit) {
  if (ltl.kind == LtlKind::Atom) eachAtom(ltl.atom, visit);
  for (auto& operand : ltl.operands) eachAtom(operand, visit);
}

template <class Visit> void eachAtom(Program& program, const Visit& visit) {
  for (auto& component : program.components)
    for (auto& port : component.ports)
      if (port.probe) eachAtom(*port.probe, visit);
  for (auto& property : program.properties) {
    auto& pattern = property.pattern;
    for (auto& operand : pattern.operands) eachAtom(operand, visit);
    for (auto* scope : {&pattern.after, &pattern.before, &pattern.until})
      if (*scope) eachAtom(**scope, visit);
    if (pattern.kind == PatternKind::Ltl) eachAtom(pattern.ltl, visit);
  }
}

} // namespace

bool Parser::isAtDeclaration(std::size_t ahead) const {
  if (peek(ahead).kind == TokenKind::End) return true;
  return beginsDeclaration(peek(ahead), peek(ahead + 1), peek(ahead + 2));
}

/// The kind of name that the current declaration declares; nullopt if it declares none.
std::optional<NameKind> Parser::declared() const {
  constexpr auto kKinds =
      std::to_array<std::pair<std::string_view, NameKind>>({{"const", NameKind::Constant},
                                                            {"type", NameKind::Type},
                                                            {"channel", NameKind::Channel},
                                                            {"event", NameKind::Event},
                                                            {"task", NameKind::Task},
                                                            {"extern", NameKind::Extern},
                                                            {"function", NameKind::Function},
                                                            {"process", NameKind::Process},
                                                            {"component", NameKind::Component},
                                                            {"property", NameKind::Property}});
  const auto found = std::ranges::find_if(kKinds, [&](auto& each) { return isAt(each.first); });
  return found == kKinds.end() ? std::nullopt : std::optional(found->second);
}

/// Whether the next tokens end an entry point, or attach it to a model.
bool Parser::endsEntry(std::size_t ahead) const {
  return isAtDeclaration(ahead) || isAt(">", ahead) || isAt(">", ahead + 1);
}

Parsed Parser::program() {
  while (peek().kind != TokenKind::End) {
    const auto before = at;
    const auto begin = peek().begin;
    const auto kind = declared();
    try {
      actor.clear();
      declaration();
    } catch (const CannotRead&) {
      resume();
    }
    if (kind) parsed.blocks.push_back({*kind, begin, lastEnd()});
    if (at == before) ++at; // skip an unreadable word at which the next declaration begins
  }
  finish();
  return std::move(parsed);
}

void Parser::declaration() {
  if (accept("const")) return constant();
  if (accept("type")) return typeDeclaration();
  if (accept("channel")) return channel();
  if (accept("event")) return eventPort();
  if (accept("task")) return task();
  if (accept("extern")) return external();
  if (accept("function")) return function();
  if (accept("process")) return process();
  if (accept("component")) return component();
  if (accept("property")) return property();
  if (accept("assert") || accept("prove")) return assertion();
  if (isAtName()) return entry();
  fail("a declaration is missing, such as `process` or `property`");
}

/// Continues at the next declaration. Keywords such as `type` cannot occur in statements.
void Parser::resume() {
  while (!isAtDeclaration()) ++at;
}

void Parser::constant() {
  const auto declared = names("the name of a constant", NameKind::Constant, true);
  expect(":");
  const Type shared = type();
  expect("is");
  const Expr given = expr();
  for (const auto& each : declared) {
    if (const auto number = value(given)) constants[each] = *number;
    parsed.program.constants.push_back({each, shared, given});
  }
}

void Parser::typeDeclaration() {
  TypeDeclaration result{.name = name("the name of a type", NameKind::Type, true)};
  expect("is");
  result.type = type();
  parsed.program.types.push_back(std::move(result));
}

void Parser::channel() {
  const auto declared = name("the name of a channel", NameKind::Channel, true);
  expect("is");
  portType(channels[declared]);
}

void Parser::eventPort() {
  EventPort result{.port = {.name = name("the name of a port", NameKind::Event, true)}};
  expect(":");
  portType(result.port);
  expect("is");
  result.function = name("the name of a function of C", NameKind::Foreign);
  parsed.program.eventPorts.push_back(std::move(result));
}

void Parser::task() {
  Task result{.name = name("the name of a task", NameKind::Task, true)};
  result.parameters = typesInParentheses();
  expect(":");
  result.result = type();
  expect("is");
  result.function = name("the name of a function of C", NameKind::Foreign);
  parsed.program.tasks.push_back(std::move(result));
}

void Parser::external() {
  Extern result{.name = name("the name of a function", NameKind::Extern, true)};
  result.parameters = typesInParentheses();
  expect(":");
  result.result = type();
  expect("is");
  result.function = name("the name of a function of C", NameKind::Foreign);
  parsed.program.externs.push_back(std::move(result));
}

void Parser::entry() {
  if (isAt(">", 1)) return attachment();
  if (!endsEntry(1)) fail(fmt::format("unexpected `{}`, expected a declaration", peek().text));
  if (!parsed.program.main.empty())
    report(fmt::format("the model is already `{}`", parsed.program.main), peek());
  parsed.program.main = name("the name of a component", NameKind::Component);
}

/// Reads `observer > model`.
void Parser::attachment() {
  const auto begin = peek().begin;
  Attachment result{.observer = name("the name of a component", NameKind::Component)};
  expect(">");
  result.model = name("the name of the model", NameKind::Component);
  actor = "observer " + result.observer;
  result.origin = origin(begin);
  parsed.program.observers.push_back(std::move(result));
}

/// Resolves paths, which begin with an observer or, implicitly, with the model.
void Parser::finish() {
  auto& program = parsed.program;
  const auto observes = [&](const std::string& name) {
    return std::ranges::find(program.observers, name, &Attachment::observer) !=
           program.observers.end();
  };
  for (const auto& [begins, token] : paths)
    if (begins != program.main && !program.main.empty() && !observes(begins))
      report(fmt::format("the path begins with `{}`, but the model is `{}`", begins, program.main),
             token);
  eachAtom(program, [&](Observable& atom) {
    if (!observes(atom.observer)) atom.observer.clear();
  });
  std::ranges::stable_sort(parsed.problems, {}, &SyntaxProblem::begin);
  shorten(parsed.problems);
}

Parsed parse(std::string_view text, const PathSteps& steps) {
  return Parser(text, steps).program();
}

} // namespace proskill::fiacre
