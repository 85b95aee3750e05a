#include "fiacre/print/print.h"
#include "fiacre/print/print_parts.h"

#include <fmt/format.h>

#include <cassert>
#include <utility>

namespace proskill::fiacre {
namespace {

bool isAtomic(const Observable& o) {
  return o.kind == ObservableKind::State || o.kind == ObservableKind::Value ||
         o.kind == ObservableKind::Tag || o.kind == ObservableKind::Event;
}

std::string operand(const Observable& observable, const std::string& main) {
  return "(" + printObservable(observable, main) + ")";
}

/// A single atom needs no parentheses.
std::string plain(const Observable& observable, const std::string& main) {
  return isAtomic(observable) ? printObservable(observable, main) : operand(observable, main);
}

std::string printAtom(const Observable& observable, const std::string& main) {
  std::string path = observable.observer.empty() ? main : observable.observer;
  path = (path.empty() ? "model" : path) + "/"; // without a model, in the form of `--properties`
  for (auto place : observable.path) path += fmt::format("{}/", place);
  switch (observable.kind) {
  case ObservableKind::State: return path + "state " + observable.name;
  case ObservableKind::Tag: return path + "tag " + observable.name;
  case ObservableKind::Event: return path + "event " + observable.name;
  case ObservableKind::Value: return path + "value " + printOperand(observable.value);
  case ObservableKind::Enter:
  case ObservableKind::Leave:
  case ObservableKind::Not:
  case ObservableKind::And:
  case ObservableKind::Or:
  case ObservableKind::Implies: break;
  }
  std::unreachable();
}

template <class Node, class Print>
std::string printJoined(const std::vector<Node>& operands, std::string_view connective,
                        Print print) {
  std::vector<std::string> parts;
  for (const auto& node : operands) parts.push_back("(" + print(node) + ")");
  return join(parts, fmt::format(" {} ", connective));
}

} // namespace

std::string printObservable(const Observable& o, const std::string& main) {
  const auto print = [&](const Observable& inner) { return printObservable(inner, main); };
  switch (o.kind) {
  case ObservableKind::Enter: return "enter " + operand(o.operands[0], main);
  case ObservableKind::Leave: return "leave " + operand(o.operands[0], main);
  case ObservableKind::Not: return "not " + operand(o.operands[0], main);
  case ObservableKind::And: return printJoined(o.operands, "and", print);
  case ObservableKind::Or: return printJoined(o.operands, "or", print);
  case ObservableKind::Implies: return printJoined(o.operands, "=>", print);
  case ObservableKind::State:
  case ObservableKind::Value:
  case ObservableKind::Tag:
  case ObservableKind::Event: return printAtom(o, main);
  }
  std::unreachable();
}

namespace {

std::string printLtl(const Ltl& ltl, const std::string& main) {
  const auto print = [&](const Ltl& inner) { return printLtl(inner, main); };
  const auto prefix = [&](std::string_view op) {
    return fmt::format("{} ({})", op, printLtl(ltl.operands[0], main));
  };
  switch (ltl.kind) {
  case LtlKind::Atom: return printObservable(ltl.atom, main);
  case LtlKind::Globally: return prefix("[]");
  case LtlKind::Finally: return prefix("<>");
  case LtlKind::Next: return prefix("()");
  case LtlKind::Not: return prefix("not");
  case LtlKind::Until: return printJoined(ltl.operands, "until", print);
  case LtlKind::And: return printJoined(ltl.operands, "and", print);
  case LtlKind::Or: return printJoined(ltl.operands, "or", print);
  case LtlKind::Implies: return printJoined(ltl.operands, "=>", print);
  }
  assert(false);
  return {};
}

/// The scope of a pattern: `after …`, `before …`, and its times.
std::string printScope(const Pattern& pattern, const std::string& main) {
  std::string out;
  if (pattern.after)
    out += (pattern.between ? " between " : " after ") + plain(*pattern.after, main);
  if (pattern.until) out += (pattern.between ? " and " : " until ") + plain(*pattern.until, main);
  if (pattern.before) out += " before " + plain(*pattern.before, main);
  if (pattern.within) out += " within " + printInterval(*pattern.within);
  if (pattern.forInterval) out += " for interval " + printInterval(*pattern.forInterval);
  if (pattern.forDuration) out += fmt::format(" for duration {}", *pattern.forDuration);
  if (pattern.lasting) out += fmt::format(" lasting {}", *pattern.lasting);
  return out;
}

std::string_view word(PatternKind kind) {
  switch (kind) {
  case PatternKind::DeadlockFree: return "deadlockfree";
  case PatternKind::InfinitelyOften: return "infinitelyoften";
  case PatternKind::Mortal: return "mortal";
  case PatternKind::Present: return "present";
  case PatternKind::Absent: return "absent";
  case PatternKind::Always: return "always";
  case PatternKind::LeadsTo: return "leadsto";
  case PatternKind::Precedes: return "precedes";
  case PatternKind::Ltl: return "ltl";
  case PatternKind::Progress: return "progress";
  case PatternKind::NoError: return "no error";
  case PatternKind::AlwaysReachable: return "always reachable";
  case PatternKind::Longest: return "longest";
  case PatternKind::Shortest: return "shortest";
  }
  assert(false);
  return {};
}

} // namespace

std::string printPattern(const Pattern& pattern, const std::string& main) {
  const auto& operands = pattern.operands;
  switch (pattern.kind) {
  case PatternKind::DeadlockFree: return "deadlockfree";
  case PatternKind::Progress: return "time can always progress";
  case PatternKind::NoError: return "nothing fails at run time";
  case PatternKind::Ltl: return "ltl " + printLtl(pattern.ltl, main);
  case PatternKind::AlwaysReachable:
    return fmt::format("{} can always be reached", operand(operands[0], main));
  case PatternKind::Longest:
  case PatternKind::Shortest:
    return fmt::format("the {} time from {} to {}", word(pattern.kind), operand(operands[0], main),
                       operand(operands[1], main));
  case PatternKind::LeadsTo:
  case PatternKind::Precedes:
    return fmt::format("{} {}{} {}{}", operand(operands[0], main), word(pattern.kind),
                       pattern.first ? " first" : "", operand(operands[1], main),
                       printScope(pattern, main));
  case PatternKind::InfinitelyOften:
  case PatternKind::Mortal:
  case PatternKind::Present:
  case PatternKind::Absent:
  case PatternKind::Always:
    return fmt::format("{} {}{}", word(pattern.kind), plain(operands[0], main),
                       printScope(pattern, main));
  }
  std::unreachable();
}

void printProperty(Output& out, const Property& property, const std::string& main,
                   const PrintOptions& options) {
  auto& writer = out.writer;
  writer.blank();
  Place place(out, property.origin);
  writer.comment(0, property.comment);
  if (property.pattern.kind == PatternKind::DeadlockFree)
    for (const auto& rest : property.pattern.operands)
      writer.comment(0, "It may stop where " + printObservable(rest, main) + ".");
  const auto text =
      fmt::format("property {} is {}", property.name, printPattern(property.pattern, main));
  if (!isOfFiacre(property.pattern.kind)) return writer.comment(0, text);
  writer.line(0, text);
  if (!property.asserted) return;
  writer.line(0, fmt::format("{} {}", options.prove ? "prove" : "assert", property.name));
}

} // namespace proskill::fiacre
