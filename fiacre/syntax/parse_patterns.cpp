#include "fiacre/syntax/parser.h"

#include <utility>

namespace proskill::fiacre {

/// A word that begins a pattern; others stand between two formulas.
bool Parser::isAtPattern(std::size_t ahead) const {
  constexpr std::string_view kWords[] = {"deadlockfree", "ltl",    "infinitelyoften", "mortal",
                                         "present",      "absent", "always"};
  return std::ranges::any_of(kWords, [&](auto word) { return isAt(word, ahead); });
}

Pattern Parser::pattern() {
  if (accept("deadlockfree")) return {.kind = PatternKind::DeadlockFree};
  if (accept("ltl")) return {.kind = PatternKind::Ltl, .ltl = formula()};
  Pattern result;
  for (auto [word, kind] : {std::pair{"infinitelyoften", PatternKind::InfinitelyOften},
                            {"mortal", PatternKind::Mortal},
                            {"present", PatternKind::Present},
                            {"absent", PatternKind::Absent},
                            {"always", PatternKind::Always}})
    if (accept(word)) result.kind = kind;
  result.operands.push_back(observable());
  scopes(result);
  return result;
}

/// A pattern as a formula of runs, which others are joined to. \param begun the formula before
/// `leadsto` or `precedes`, if it is one of these
Ltl Parser::joinedPattern(const Token& first, std::optional<Ltl> begun) {
  const bool outside = std::exchange(joinsPatterns, false);
  const Pattern read = begun ? betweenTwo(momentary(std::move(*begun), first)) : pattern();
  joinsPatterns = outside;
  hasPatterns = true;
  if (auto formula = asFormula(read)) {
    height += 3; // which it has at most above its operands
    return *formula;
  }
  report("this pattern cannot be combined with others: assert it by itself, or write it as `ltl`",
         first);
  throw CannotRead();
}

/// After the first formula.
Pattern Parser::betweenTwo(Observable first) {
  Pattern result{.kind = isAt("leadsto") ? PatternKind::LeadsTo : PatternKind::Precedes};
  ++at;
  result.first = result.kind == PatternKind::LeadsTo && accept("first");
  result.operands.push_back(std::move(first));
  result.operands.push_back(observable());
  scopes(result);
  return result;
}

/// Behind a word of a pattern that may come but once.
void Parser::once(bool known) {
  if (!known) return;
  --at;
  fail(fmt::format("duplicate `{}` in one pattern", peek().text));
}

/// `after`, with `until`, and `between` are one.
void Parser::scopes(Pattern& pattern) {
  for (;;) {
    if (accept("after")) {
      once(pattern.after.has_value());
      pattern.after = observableUpTo("until");
      if (accept("until")) pattern.until = observable();
    } else if (accept("between")) {
      once(pattern.after.has_value());
      pattern.between = true;
      pattern.after = observableUpTo("and");
      expect("and");
      pattern.until = observable();
    } else if (accept("before")) {
      once(pattern.before.has_value());
      pattern.before = observable();
    } else if (!times(pattern)) {
      return;
    }
  }
}

/// Whether a time came.
bool Parser::times(Pattern& pattern) {
  if (accept("within")) {
    once(pattern.within.has_value());
    pattern.within = interval();
  } else if (accept("lasting")) {
    once(pattern.lasting.has_value());
    pattern.lasting = time();
  } else if (accept("for")) {
    once(pattern.forDuration || pattern.forInterval);
    if (accept("duration")) {
      pattern.forDuration = time();
    } else {
      expect("interval");
      pattern.forInterval = interval();
    }
  } else {
    return false;
  }
  return true;
}

} // namespace proskill::fiacre
