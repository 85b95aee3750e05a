#include "tests/support/random/random_program.h"
#include "tests/support/texts.h"

#include "syntax/tree/statements.h"

#include <catch2/catch.hpp>

#include <map>

namespace proskill::test::random_program_test {

using namespace proskill::syntax;

namespace {

constexpr std::uint64_t kPrograms = 3000;

/// How often each construct of the language occurred.
class Census {
public:
  void count(const analysis::Program& program) {
    for (const auto& form : program.files[0].document.forms())
      std::visit([&](const auto& node) { of(node); }, form.node());
  }

  [[nodiscard]] int of(const std::string& what) const {
    auto found = seen.find(what);
    return found == seen.end() ? 0 : found->second;
  }
  [[nodiscard]] int of(StatementKind kind) const { return of("statement " + number(kind)); }
  [[nodiscard]] int of(ExprKind kind) const { return of("expression " + number(kind)); }
  [[nodiscard]] int of(PropertyKind kind) const { return of("property " + number(kind)); }

private:
  template <class Kind> static std::string number(Kind kind) {
    return std::to_string(static_cast<int>(kind));
  }

  void of(const UnknownForm&) { FAIL("an unknown form"); }
  void of(const Include&) { FAIL("an include"); }
  void of(const Platform&) { FAIL("a platform"); }
  void of(const Constant&) { FAIL("a constant: random_constants.h puts them in"); }
  void of(const StateVariable& variable) {
    fields(variable.fields);
    if (variable.transitionsKind == Transitions::Listed) ++seen["restricted transitions"];
  }
  void of(const Event& event) {
    fields(event.fields);
    effects(event.effects);
  }
  void of(const Resource& resource) { fields(resource.fields); }
  void of(const Environment& environment) { block(environment.body, 0); }
  void of(const Property& property) {
    ++seen["property " + number(property.kind)];
    for (const auto& operand : property.operands) expression(operand);
  }
  void of(const Skill& skill) {
    fields(skill.fields);
    for (const auto& condition : skill.preconditions) expression(condition.condition);
    for (const auto& invariant : skill.invariants) effects(invariant.effects);
    if (skill.timeInterval) interval(*skill.timeInterval);
    if (skill.timeInterval && skill.isComposite()) ++seen["interval of a composite skill"];
    if (skill.interrupt && skill.isComposite()) ++seen["interrupt of a composite skill"];
    for (const auto* outcomes : {&skill.successes, &skill.failures})
      for (const auto& outcome : *outcomes)
        if (outcome.postcondition) ++seen["postcondition"];
    if (skill.body) block(*skill.body, 0);
  }

  void fields(const syntax::List<FieldUse>& uses) {
    for (const auto& use : uses) ++seen[std::string(use.keyword.text)];
  }
  void effects(const Effects& all) {
    if (all.items.size() > 1) ++seen["several effects"];
    for (const auto& effect : all.items) expression(effect.value);
  }
  void interval(const Interval& bounds) {
    if (!bounds.upper) ++seen["unbounded interval"];
    if (bounds.lowerOpen || (bounds.upper && bounds.upperOpen)) ++seen["open interval"];
  }
  void expression(const Expr& expr) {
    ++seen["expression " + number(expr.kind)];
    for (const auto& operand : expr.operands) expression(operand);
  }
  void block(const Block& body, int inBranch) {
    for (const auto& each : body.statements) statement(each, inBranch);
  }
  void statement(const Statement& each, int inBranch) {
    ++seen["statement " + number(each.kind)];
    if (inBranch > 0 && each.kind == StatementKind::Success) ++seen["success in a branch"];
    if (inBranch > 0 && each.kind == StatementKind::Failure) ++seen["failure in a branch"];
    if (inBranch > 0 && each.kind == StatementKind::Parallel) ++seen["parallel in a branch"];
    if (inBranch > 0 && each.kind == StatementKind::Race) ++seen["race in a branch"];
    if (each.kind == StatementKind::WaitTime) interval(each.duration);
    if (each.kind == StatementKind::WaitCondition && !each.effects.items.empty())
      ++seen["wait with effects"];
    if (syntax::hasTimeout(each)) ++seen["wait with timeout"];
    expression(each.condition);
    effects(each.effects);
    const std::string prefix = each.kind == StatementKind::Case ? "case with " : "";
    for (std::size_t i = 1; i < each.arms.size(); ++i)
      ++seen[prefix + (each.arms[i].condition ? "elseif" : "else")];
    for (const auto& arm : each.arms) {
      if (arm.condition) expression(*arm.condition);
      block(arm.body, inBranch);
    }
    bool parallel = syntax::runsBranches(each);
    for (const auto& branch : each.branches) block(branch, inBranch + (parallel ? 1 : 0));
  }

  std::map<std::string, int> seen;
};

Census censusOfAll() {
  Census census;
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed)
    census.count(test::programOfText(test::textOf(test::randomProgram(seed))));
  return census;
}

} // namespace

TEST_CASE("random programs are well-formed") {
  for (std::uint64_t seed = 0; seed < kPrograms; ++seed) {
    std::string text = test::textOf(test::randomProgram(seed));
    analysis::Program program = test::programOfText(text);
    for (const auto& found : analysis::check(program)) {
      INFO("seed " << seed << ": " << found.message << "\n" << text);
      REQUIRE(found.severity != Severity::Error);
    }
  }
}

TEST_CASE("the same seed gives the same program, another seed another") {
  CHECK(test::randomProgram(7) == test::randomProgram(7));
  CHECK(test::randomProgram(7) != test::randomProgram(8));
}

TEST_CASE("random programs use every statement of the language") {
  Census census = censusOfAll();
  for (int kind = static_cast<int>(StatementKind::Call);
       kind <= static_cast<int>(StatementKind::Choose); ++kind) {
    INFO("statement " << kind);
    CHECK(census.of(static_cast<StatementKind>(kind)) >= 20);
  }
  for (const char* special :
       {"wait with effects", "wait with timeout", "elseif", "else", "case with else",
        "success in a branch", "failure in a branch", "parallel in a branch", "race in a branch",
        "unbounded interval", "open interval", "several effects"}) {
    INFO(special);
    CHECK(census.of(std::string(special)) >= 20);
  }
}

TEST_CASE("random programs use every field and every condition of the language") {
  Census census = censusOfAll();
  for (const char* field : {":init",
                            ":min",
                            ":max",
                            ":states",
                            ":transitions",
                            ":every",
                            ":guard",
                            ":effects",
                            ":capacity",
                            ":input",
                            ":precondition",
                            ":start",
                            ":invariant",
                            ":time_interval",
                            ":action",
                            ":interrupt",
                            ":interruptible",
                            ":success",
                            ":failure",
                            ":resources",
                            ":monitor",
                            ":body",
                            "restricted transitions",
                            "postcondition",
                            "interval of a composite skill",
                            "interrupt of a composite skill"}) {
    INFO(field);
    CHECK(census.of(std::string(field)) >= 20);
  }
  for (int kind = static_cast<int>(ExprKind::Test); kind <= static_cast<int>(ExprKind::Value);
       ++kind) {
    INFO("expression " << kind);
    CHECK(census.of(static_cast<ExprKind>(kind)) >= 10);
  }
  for (auto kind : {PropertyKind::Always, PropertyKind::Never, PropertyKind::Reachable,
                    PropertyKind::DeadlockFree, PropertyKind::Present, PropertyKind::Absent})
    CHECK(census.of(kind) >= 20);
}

TEST_CASE("a minimised program is as small as can be and still shows what was looked for") {
  auto program = test::randomProgram(12);
  auto callsSomething = [](const std::vector<test::Form>& forms) {
    analysis::Program candidate = test::programOfText(test::textOf(forms));
    if (!test::isWellFormed(candidate)) return false;
    Census census;
    census.count(candidate);
    return census.of(StatementKind::Parallel) > 0;
  };
  for (std::uint64_t seed = 0; !callsSomething(program); ++seed)
    program = test::randomProgram(seed);
  auto small = test::minimise(program, callsSomething);
  CHECK(callsSomething(small));
  CHECK(test::textOf(small).size() < test::textOf(program).size() / 3);
  CHECK(small.size() <= 2);
}

} // namespace proskill::test::random_program_test
