#include "bridge/rl/read/composite.h"

#include <array>

namespace proskill::bridge::rl {
namespace {

/// Operators of the same level, the loosest first. `if` is between `and` and `!`.
struct Level {
  std::string_view symbol;
  TermKind kind;
};
constexpr std::array kLevels{Level{"or", TermKind::Or},    Level{"and", TermKind::And},
                             Level{"!", TermKind::Race},   Level{"|", TermKind::Parallel},
                             Level{"+", TermKind::Choice}, Level{">", TermKind::Sequence}};

class TermReader {
public:
  explicit TermReader(TokenReader& from) : reader(from) {}

  Term term(std::size_t level = 0) {
    if (level == 0 && ++depth > kDeepestTerm) {
      reader.fail(reader.peek().place, "this is nested too deep");
      return {};
    }
    auto made = operation(level);
    if (level == 0) --depth;
    return made;
  }

private:
  Term operation(std::size_t level) {
    if (level == kLevels.size()) return atom();
    if (kLevels[level].kind == TermKind::Race && reader.isAt("if")) return choice();
    auto first = term(level + 1);
    if (!reader.isAt(kLevels[level].symbol)) return first;
    Term all{kLevels[level].kind, {}, {}, first.place, {}};
    all.parts.push_back(std::move(first));
    while (reader.takeIf(kLevels[level].symbol)) all.parts.push_back(term(level + 1));
    return all;
  }

  Term choice() {
    Term all{TermKind::If, {}, {}, reader.peek().place, {}};
    reader.expect("if");
    do {
      all.parts.push_back(term());
      reader.expect("then");
      all.parts.push_back(term());
    } while (reader.takeIf("elif"));
    reader.expect("else");
    all.parts.push_back(term());
    reader.expect("end");
    return all;
  }

  Term atom() {
    if (reader.takeIf("(")) {
      auto inner = term();
      reader.expect(")");
      return inner;
    }
    Term made;
    made.place = reader.peek().place;
    made.name = reader.word("a call, a name or `(`");
    if (reader.takeIf(".")) {
      made.kind = TermKind::Skill;
      made.owner = std::exchange(made.name, reader.word("the name of a skill"));
      if (made.owner.text == "ros") return ros(std::move(made));
      reader.expect("(");
      arguments(made);
    } else if (reader.takeIf("(")) {
      made.kind = TermKind::Call;
      arguments(made);
    }
    return made;
  }

  Term ros(Term made) {
    made.kind = TermKind::Ros;
    const auto& what = made.name.text;
    if (what != "publish" && what != "service" && what != "action")
      reader.fail(made.name.place, "after `ros.` comes `publish`, `service` or `action`");
    reader.expect("(");
    made.owner = reader.take(TokenKind::String, "a topic in quotes");
    if (!reader.isAt(")")) reader.expect(",");
    arguments(made);
    return made;
  }

  void arguments(Term& call) {
    if (reader.takeIf(")")) return;
    do call.parts.push_back(term());
    while (reader.takeIf(","));
    reader.expect(")");
  }

  TokenReader& reader;
  std::size_t depth = 0;
};

Variable parameter(TokenReader& reader) {
  Variable made;
  made.name = reader.word("a parameter");
  reader.expect(":");
  made.type = reader.word("a type").text;
  return made;
}

} // namespace

Composite readComposite(TokenReader& reader, bool hasBody) {
  Composite made;
  made.name = reader.word("the name of a composite");
  reader.expect("(");
  if (!reader.isAt(")")) {
    do made.parameters.push_back(parameter(reader));
    while (reader.takeIf(","));
  }
  reader.expect(")");
  if (!hasBody) return made;
  reader.expect("{");
  made.body = TermReader(reader).term();
  reader.expect("}");
  return made;
}

} // namespace proskill::bridge::rl
