#include "fiacre/syntax/parser.h"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace proskill::fiacre {
namespace {

struct Connective {
  std::string_view word;
  LtlKind ltl;
  ObservableKind observable;
};

/// From the lowest precedence to the highest.
constexpr auto kConnectives = std::to_array<Connective>({
    {"=>", LtlKind::Implies, ObservableKind::Implies},
    {"or", LtlKind::Or, ObservableKind::Or},
    {"and", LtlKind::And, ObservableKind::And},
});

/// A combination of state formulas is a state formula.
Ltl joined(const Connective& connective, std::vector<Ltl> operands) {
  if (!std::ranges::all_of(operands, isAtom))
    return {.kind = connective.ltl, .operands = std::move(operands)};
  Ltl result{.kind = LtlKind::Atom, .atom = {.kind = connective.observable}};
  for (auto& operand : operands) result.atom.operands.push_back(std::move(operand.atom));
  return result;
}

/// Height and size of a tree of formulas.
struct Extent {
  std::size_t height = 0;
  std::size_t nodes = 1;

  void addPart(const Extent& part) {
    height = std::max(height, part.height + 1);
    nodes += part.nodes;
  }
};

Extent extentOf(const Observable& observable) {
  Extent result;
  for (const auto& operand : observable.operands) result.addPart(extentOf(operand));
  return result;
}

Extent extentOf(const Ltl& formula) {
  Extent result = extentOf(formula.atom);
  for (const auto& operand : formula.operands) result.addPart(extentOf(operand));
  return result;
}

/// Limit on nodes of formulas that are used by name. Each use is a copy, and nested names could
/// make it grow exponentially.
constexpr std::size_t kMostNamed = 200'000;

} // namespace

Ltl Parser::formula() {
  const Deeper deeper(*this);
  return formulaChain(0);
}

/// `a => b => c` is `a => (b => c)`; operands of other connectives form one list.
Ltl Parser::formulaChain(std::size_t level) {
  if (level == kConnectives.size()) return formulaUntil();
  const auto& connective = kConnectives[level];
  Height height(*this);
  auto operands = operandsOf(formulaChain(level + 1));
  height.addPart();
  const bool toTheRight = connective.ltl == LtlKind::Implies;
  while (connective.word != separator && accept(connective.word)) {
    const Deeper deeper(*this);
    operands.push_back(formulaChain(toTheRight ? level : level + 1));
    height.addPart();
    if (toTheRight) break;
  }
  if (operands.size() == 1) return std::move(operands[0]);
  height.addNode();
  return joined(connective, std::move(operands));
}

/// `a until b until c` is `a until (b until c)`; `a release b` is `not (not a until not b)`.
Ltl Parser::formulaUntil() {
  Height height(*this);
  Ltl left = formulaPrefix();
  height.addPart();
  const bool until = separator != "until" && (accept("until") || accept("U"));
  if (!until && !accept("release")) return left;
  const Deeper deeper(*this);
  Ltl right = formulaUntil();
  height.addPart();
  height.addNode();
  if (until)
    return {.kind = LtlKind::Until, .operands = operandsOf(std::move(left), std::move(right))};
  height.addNode();
  height.addNode();
  return negated({.kind = LtlKind::Until,
                  .operands = operandsOf(negated(std::move(left)), negated(std::move(right)))});
}

Ltl Parser::formulaPrefix() {
  const Deeper deeper(*this);
  const auto operand = [&] {
    Height above(*this);
    Ltl read = formulaPrefix();
    above.addPart();
    above.addNode();
    return read;
  };
  if (accept("not")) return negated(operand());
  const auto temporal = [&](LtlKind kind, std::size_t tokens) {
    at += tokens;
    return Ltl{.kind = kind, .operands = operandsOf(operand())};
  };
  if (isAtPair("[", "]")) return temporal(LtlKind::Globally, 2);
  if (isAtPair("(", ")")) return temporal(LtlKind::Next, 2);
  if (isAt("<>")) return temporal(LtlKind::Finally, 1);
  for (auto [word, kind] :
       {std::pair{"enter", ObservableKind::Enter}, {"leave", ObservableKind::Leave}}) {
    if (!accept(word)) continue;
    Ltl inner = operand();
    if (!isAtom(inner)) fail(fmt::format("`{}` does not take a temporal formula", word));
    return {.kind = LtlKind::Atom,
            .atom = {.kind = kind, .operands = operandsOf(std::move(inner.atom))}};
  }
  return formulaPrimary();
}

Ltl Parser::formulaPrimary() {
  if (joinsPatterns && isAtPattern()) return joinedPattern(peek(), {});
  if (accept("(")) {
    const Token first = peek();
    const auto outside = std::exchange(separator, {});
    Ltl inner = formula();
    if (joinsPatterns && (isAt("leadsto") || isAt("precedes")))
      inner = joinedPattern(first, std::move(inner));
    separator = outside;
    expect(")");
    return inner;
  }
  if (isAtName() && !isAt("/", 1)) {
    if (const auto named = formulas.find(peek().text); named != formulas.end()) {
      mention(NameKind::Property);
      return namedFormula(named->second);
    }
    fail(fmt::format("`{}` is not the name of a formula; a path begins with `NAME/`", peek().text));
  }
  return {.kind = LtlKind::Atom, .atom = atom()};
}

/// Reads a name. \pre the next token is one
Ltl Parser::namedFormula(const Ltl& formula) {
  const auto [levels, nodes] = extentOf(formula);
  copied += nodes;
  if (copied > kMostNamed) fail("the formula is too large with the named formulas in it");
  ++at;
  height = levels;
  return formula;
}

/// Reads a state formula.
Observable Parser::observable() {
  const Token first = peek();
  return momentary(formula(), first);
}

/// Reads a state formula that ends before a keyword which could also continue it.
Observable Parser::observableUpTo(std::string_view word) {
  separator = word;
  const Token first = peek();
  Ltl read = formula();
  separator = {};
  return momentary(std::move(read), first);
}

Observable Parser::momentary(Ltl result, const Token& first) {
  if (isAtom(result)) return std::move(result.atom);
  report("expected a condition on one moment, found a temporal formula", first);
  throw CannotRead();
}

/// Reads a position in `par`, or the name of an instance.
std::optional<std::uint32_t> Parser::step() {
  if (isAtName() && isAt("/", 1)) {
    const auto known = steps.find(peek().text);
    if (known == steps.end()) fail(fmt::format("no part of the model is called `{}`", peek().text));
    ++at;
    return known->second;
  }
  if (peek().kind != TokenKind::Number) return std::nullopt;
  const auto place = number().number;
  if (place < 1 || place > std::int64_t{1} << 31) fail("places in `par` count from 1");
  return static_cast<std::uint32_t>(place);
}

/// Reads an atom such as `main/1/2/state idle`.
Observable Parser::atom() {
  height = 0;
  const Token first = peek();
  Observable result;
  result.observer = name("a path such as `main/1/state idle`", NameKind::Component);
  paths.emplace_back(result.observer, first);
  expect("/");
  while (const auto place = step()) {
    result.path.push_back(*place);
    expect("/");
  }
  const Within within(*this, {result.observer, result.path});
  if (accept("value")) {
    constexpr std::size_t kEquality = 2;
    result.kind = ObservableKind::Value;
    result.value = binary(kEquality);
    return result;
  }
  struct Named {
    std::string_view word;
    ObservableKind kind;
    NameKind name;
  };
  for (auto [word, kind, named] : {Named{"state", ObservableKind::State, NameKind::State},
                                   {"tag", ObservableKind::Tag, NameKind::Tag},
                                   {"event", ObservableKind::Event, NameKind::Port}}) {
    if (!accept(word)) continue;
    result.kind = kind;
    result.name = name(fmt::format("the name of a {}", word), named);
    return result;
  }
  fail("`state`, `value`, `tag` or `event` is missing in the path");
}

/// Patterns may be combined in parentheses by `and`, `or`, `not` and `=>`; `hasPatterns` says
/// whether there are any.
Ltl Parser::formulaOrPatterns() {
  joinsPatterns = true;
  hasPatterns = false;
  try {
    Ltl read = formula();
    joinsPatterns = false;
    return read;
  } catch (const CannotRead&) {
    joinsPatterns = false;
    throw;
  }
}

/// Reads a property. One that is a formula has a name that later ones may use.
void Parser::property() {
  const auto begin = peek().begin;
  Property result{.name = name("the name of a property", NameKind::Property, true),
                  .asserted = false};
  actor = "property " + result.name;
  expect("is");
  separator = {};
  if (isAtPattern()) {
    result.pattern = pattern();
  } else {
    const Token first = peek();
    Ltl plain = formulaOrPatterns();
    if (hasPatterns || !isAtom(plain)) {
      result.pattern = {.kind = PatternKind::Ltl, .ltl = std::move(plain)};
    } else if (isAt("leadsto") || isAt("precedes")) {
      result.pattern = betweenTwo(momentary(std::move(plain), first));
    } else {
      formulas[result.name] = std::move(plain);
      return;
    }
  }
  if (auto named = asFormula(result.pattern)) formulas[result.name] = std::move(*named);
  result.origin = origin(begin);
  parsed.program.properties.push_back(std::move(result));
}

/// Reads `assert p`. The texts for its verdicts are dropped.
void Parser::assertion() {
  const Token token = peek();
  auto asked = name("the name of a property", NameKind::Property);
  while (isAt("-") && peek(1).kind == TokenKind::Name && peek(2).kind == TokenKind::String) at += 3;
  const auto found = std::ranges::find(parsed.program.properties, asked, &Property::name);
  if (found != parsed.program.properties.end())
    found->asserted = true;
  else
    report(fmt::format("the property `{}` is not declared above", asked), token);
}

} // namespace proskill::fiacre
