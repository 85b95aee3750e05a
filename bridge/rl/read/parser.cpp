#include "bridge/rl/read/parser.h"

#include "bridge/text/token_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::bridge::rl {
namespace {

class Parser {
public:
  explicit Parser(std::vector<Token> tokens) : reader(std::move(tokens)) {}

  std::expected<Parsed, Error> file() {
    while (!reader.isAtEnd()) entry();
    if (reader.firstError()) return std::unexpected(*reader.firstError());
    return std::move(parsed);
  }

private:
  void entry() {
    if (reader.takeIf("include"))
      reader.oneOrMore([&] {
        parsed.includes.push_back(reader.take(TokenKind::String, "a file name in quotes"));
      });
    else if (reader.takeIf("type"))
      reader.oneOrMore([&] { static_cast<void>(type()); });
    else if (reader.takeIf("skillset"))
      skillset();
    else if (reader.takeIf("def"))
      parsed.composites.push_back(readComposite(reader, true));
    else if (reader.takeIf("dec") || reader.takeIf("decl"))
      parsed.composites.push_back(readComposite(reader, false));
    else
      reader.fail("`type`, `include`, `skillset` or `def`");
  }

  void skillset() {
    Skillset made;
    made.name = reader.word("the name of a skillset");
    if (reader.isAt("<")) skipAngles();
    reader.expect("{");
    reader.untilBrace([&] { part(made); });
    parsed.skillsets.push_back(std::move(made));
  }

  void part(Skillset& made) {
    if (reader.takeIf("parameter"))
      reader.oneOrMore([&] { made.parameters.push_back(variable()); });
    else if (reader.takeIf("data"))
      reader.oneOrMore([&] { made.data.push_back(variable()); });
    else if (reader.takeIf("resource"))
      reader.oneOrMore([&] { made.resources.push_back(resource()); });
    else if (reader.takeIf("event"))
      reader.oneOrMore([&] { made.events.push_back(event()); });
    else if (reader.takeIf("skill"))
      reader.oneOrMore([&] { made.skills.push_back(skill()); });
    else
      reader.fail("`parameter`, `data`, `resource`, `event` or `skill`");
  }

  /// Takes the keyword of a part that may be there once.
  bool takeOnly(const char* keyword, bool isThere) {
    const auto place = reader.peek().place;
    if (!reader.takeIf(keyword)) return false;
    if (isThere) reader.fail(place, fmt::format("a second `{}`", keyword));
    return true;
  }

  // --- Types and variables

  void skipAngles() {
    std::size_t depth = 0;
    do {
      depth += reader.isAt("<") ? 1 : 0;
      depth -= reader.isAt(">") ? 1 : 0;
      reader.skip();
    } while (depth > 0 && !reader.isAtEnd());
  }

  std::string type() {
    auto text = reader.word("a type").text;
    while (reader.takeIf("::") || reader.takeIf("/") || reader.takeIf("."))
      text += "/" + reader.word("the rest of a type").text;
    if (reader.isAt("<")) skipAngles();
    if (reader.takeIf("[")) {
      if (!reader.isAt("]")) reader.skip();
      reader.expect("]");
    }
    return text;
  }

  Variable variable() {
    Variable made;
    made.name = reader.word("a name");
    reader.expect(":");
    made.type = type();
    if (reader.takeIf("period")) duration();
    return made;
  }

  void duration() {
    static_cast<void>(reader.take(TokenKind::Number, "a number"));
    static_cast<void>(reader.takeIf("sec") || reader.takeIf("ms"));
  }

  // --- Resources and events

  Resource resource() {
    Resource made;
    made.name = reader.word("the name of a resource");
    reader.expect("{");
    reader.untilBrace([&] { resourceField(made); });
    if (made.states.empty()) reader.fail(made.name.place, "this resource needs `state { … }`");
    if (made.initial.text.empty()) reader.fail(made.name.place, "this resource needs `initial`");
    return made;
  }

  void resourceField(Resource& made) {
    if (reader.takeIf("state"))
      reader.oneOrMore([&] { made.states.push_back(reader.word("a state")); });
    else if (takeOnly("initial", !made.initial.text.empty()))
      made.initial = reader.word("a state");
    else if (!takeOnly("transition", made.allMoves || !made.moves.empty()))
      reader.fail("`state`, `initial` or `transition`");
    else if (reader.takeIf("all"))
      made.allMoves = true;
    else
      reader.oneOrMore([&] {
        auto from = reader.word("a state");
        reader.expect("->");
        made.moves.emplace_back(std::move(from), reader.word("a state"));
      });
  }

  Event event() {
    Event made;
    made.name = reader.word("the name of an event");
    reader.expect("{");
    reader.untilBrace([&] {
      if (takeOnly("guard", made.guard.has_value()))
        made.guard = expr();
      else
        effects(made.effects);
    });
    return made;
  }

  // --- Skills

  Skill skill() {
    Skill made;
    made.name = reader.word("the name of a skill");
    reader.expect("{");
    reader.untilBrace([&] { skillField(made); });
    return made;
  }

  void skillField(Skill& made) {
    const auto place = reader.peek().place;
    if (reader.takeIf("parameter"))
      reader.oneOrMore([&] { made.parameters.push_back(variable()); });
    else if (reader.takeIf("input"))
      reader.oneOrMore([&] { made.inputs.push_back(variable()); });
    else if (reader.takeIf("output"))
      reader.oneOrMore([&] { made.outputs.push_back(variable()); });
    else if (reader.takeIf("precondition"))
      reader.oneOrMore([&] { made.preconditions.push_back(precondition()); });
    else if (reader.takeIf("start"))
      reader.oneOrMore([&] { made.start.push_back(effect()); });
    else if (reader.takeIf("invariant"))
      reader.oneOrMore([&] { made.invariants.push_back(invariant()); });
    else if (takeOnly("progress", made.progress.has_value()))
      made.progress = place, progress();
    else if (takeOnly("interrupt", made.interrupt.has_value()))
      interrupt(made.interrupt.emplace(Interrupt{place, false, {}, {}}));
    else if (reader.takeIf("success"))
      reader.oneOrMore([&] { made.successes.push_back(outcome()); });
    else if (reader.takeIf("failure"))
      reader.oneOrMore([&] { made.failures.push_back(outcome()); });
    else
      reader.fail("a part of a skill, such as `precondition` or `success`");
  }

  Precondition precondition() {
    Precondition made;
    made.name = reader.word("the name of a precondition");
    reader.expect(":");
    made.condition = expr();
    return made;
  }

  Invariant invariant() {
    Invariant made;
    made.name = reader.word("the name of an invariant");
    reader.expect("{");
    bool guarded = false;
    reader.untilBrace([&] {
      if (takeOnly("guard", guarded))
        made.guard = expr(), guarded = true;
      else
        effects(made.effects);
    });
    if (!guarded) reader.fail(made.name.place, "this invariant needs a `guard`");
    return made;
  }

  void progress() {
    reader.expect("{");
    reader.untilBrace([&] {
      if (reader.takeIf("period"))
        duration();
      else if (reader.takeIf("message") || reader.takeIf("output"))
        reader.oneOrMore([&] { static_cast<void>(variable()); });
      else
        reader.fail("`period`, `message` or `output`");
    });
  }

  void interrupt(Interrupt& made) {
    reader.expect("{");
    reader.untilBrace([&] {
      if (!reader.takeIf("interrupting")) return ending(made.effects, made.postcondition);
      made.lasts = reader.takeIf("true");
      if (!made.lasts) reader.expect("false");
    });
  }

  Outcome outcome() {
    Outcome made;
    made.name = reader.word("the name of an outcome");
    reader.expect("{");
    reader.untilBrace([&] { ending(made.effects, made.postcondition); });
    return made;
  }

  void ending(Effects& all, std::optional<Expr>& postcondition) {
    if (takeOnly("postcondition", postcondition.has_value()))
      postcondition = expr();
    else
      effects(all);
  }

  void effects(Effects& all) {
    reader.expect("effect");
    reader.oneOrMore([&] { all.push_back(effect()); });
  }

  Effect effect() {
    Effect made;
    made.resource = reader.word("a resource");
    reader.expect("->");
    made.state = reader.word("a state");
    return made;
  }

  // --- Conditions, the loosest operator first

  Expr expr() {
    if (++depth > kDeepestExpr) {
      reader.fail(reader.peek().place, "this condition is nested too deeply");
      return {};
    }
    auto left = disjunction();
    std::size_t arrows = 0;
    while (reader.takeIf("=>")) {
      if (++arrows > kDeepestExpr) reader.fail(reader.peek().place, "too many `=>`");
      left = joined(ExprKind::Implies, std::move(left), disjunction());
    }
    --depth;
    return left;
  }

  Expr disjunction() {
    auto left = conjunction();
    while (reader.takeIf("or")) add(ExprKind::Or, left, conjunction());
    return left;
  }

  Expr conjunction() {
    auto left = negation();
    while (reader.takeIf("and")) add(ExprKind::And, left, negation());
    return left;
  }

  Expr negation() {
    bool negated = false;
    while (reader.takeIf("not")) negated = !negated;
    auto operand = atom();
    if (!negated) return operand;
    Expr made{ExprKind::Not, {}, {}, {}};
    made.operands.push_back(std::move(operand));
    return made;
  }

  Expr atom() {
    if (reader.takeIf("(")) {
      auto inner = expr();
      reader.expect(")");
      return inner;
    }
    if (reader.takeIf("true")) return {ExprKind::True, {}, {}, {}};
    if (reader.takeIf("false")) return {ExprKind::False, {}, {}, {}};
    Expr made;
    made.resource = reader.word("a condition");
    made.kind = reader.takeIf("!=") ? ExprKind::IsNot : ExprKind::Is;
    if (made.kind == ExprKind::Is) reader.expect("==");
    made.state = reader.word("a state");
    return made;
  }

  static Expr joined(ExprKind kind, Expr left, Expr right) {
    Expr made{kind, {}, {}, {}};
    made.operands.push_back(std::move(left));
    made.operands.push_back(std::move(right));
    return made;
  }

  /// The same for operators of any number of operands, so that a long chain is not deep.
  static void add(ExprKind kind, Expr& left, Expr right) {
    if (left.kind == kind && !left.operands.empty())
      left.operands.push_back(std::move(right));
    else
      left = joined(kind, std::move(left), std::move(right));
  }

  TokenReader reader;
  Parsed parsed;
  std::size_t depth = 0;
};

} // namespace

std::expected<Parsed, Error> parse(std::string_view text, const std::filesystem::path& file) {
  auto tokens = tokensOf(text, file);
  if (!tokens) return std::unexpected(tokens.error());
  return Parser(*std::move(tokens)).file();
}

} // namespace proskill::bridge::rl
