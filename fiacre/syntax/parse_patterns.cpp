#include "fiacre/syntax/parser.h"

#include <utility>

namespace proskill::fiacre {

/// Whether the next word begins a pattern. The keywords of other patterns are between two formulas.
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

/// Translates a pattern into a formula, so that it can be combined with others.
/// \param begun the formula before `leadsto` or `precedes`, if it was read
Ltl Parser::joinedPattern(const Token& first, std::optional<Ltl> begun) {
  const bool outside = std::exchange(joinsPatterns, false);
  const Pattern read = begun ? betweenTwo(momentary(std::move(*begun), first)) : pattern();
  joinsPatterns = outside;
  hasPatterns = true;
  if (auto formula = asFormula(read)) {
    height += 3; // the translation adds at most this height
    return *formula;
  }
  report("this pattern cannot be combined with others: assert it by itself, or write it as `ltl`",
         first);
  throw CannotRead();
}

/// Reads the rest of a pattern after its first formula.
Pattern Parser::betweenTwo(Observable first) {
  Pattern result{.kind = isAt("leadsto") ? PatternKind::LeadsTo : PatternKind::Precedes};
  ++at;
  result.first = result.kind == PatternKind::LeadsTo && accept("first");
  result.operands.push_back(std::move(first));
  result.operands.push_back(observable());
  scopes(result);
  return result;
}

/// Reports a keyword that was given twice.
void Parser::once(bool known) {
  if (!known) return;
  --at;
  fail(fmt::format("duplicate `{}` in one pattern", peek().text));
}

/// Reads scopes and times. `after`, possibly with `until`, and `between` exclude each other.
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

/// Reads a time limit. \return whether there was one
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
