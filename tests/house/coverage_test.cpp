#include "syntax/document.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace proskill::syntax;

/// The examples cover the whole language: nobody would learn what none of them uses, and few tests
/// would cover it.
namespace {

std::vector<Document> parseExamples() {
  std::vector<Document> documents;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(PROSKILL_SOURCE_DIR "/examples")) {
    if (entry.path().extension() != ".proskill") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    documents.push_back(Document::parse(text.str()));
  }
  return documents;
}

/// What the examples use.
struct Used {
  std::set<StatementKind> statements;
  std::set<ExprKind> expressions;
  std::set<PropertyKind> properties;

  void add(const Expr& expr) {
    expressions.insert(expr.kind);
    for (const auto& operand : expr.operands) add(operand);
  }
  void add(const std::optional<Expr>& expr) {
    if (expr) add(*expr);
  }
  void add(const Effects& effects) {
    for (const auto& effect : effects.items) add(effect.value);
  }
  void add(const Block& block) {
    for (const auto& statement : block.statements) add(statement);
  }
  void add(const Statement& statement) {
    statements.insert(statement.kind);
    add(statement.condition);
    add(statement.effects);
    for (const auto& argument : statement.arguments) add(argument.value);
    for (const auto& branch : statement.branches) add(branch);
    for (const auto& arm : statement.arms) {
      add(arm.condition);
      add(arm.body);
    }
  }
  void add(const Outcome& outcome) {
    add(outcome.effects);
    add(outcome.postcondition);
  }
  void add(const Skill& skill) {
    for (const auto& precondition : skill.preconditions) add(precondition.condition);
    for (const auto& invariant : skill.invariants) add(invariant.guard);
    for (const auto& outcome : skill.successes) add(outcome);
    for (const auto& outcome : skill.failures) add(outcome);
    if (skill.action)
      for (const auto& argument : skill.action->arguments) add(argument);
    if (skill.body) add(*skill.body);
  }
  void add(const Property& property) {
    properties.insert(property.kind);
    for (const auto& operand : property.operands) add(operand);
    add(property.after);
    add(property.before);
  }
  void add(const Environment& environment) { add(environment.body); }
  template <class Other> void add(const Other&) {}
};

Used usedInExamples() {
  Used used;
  for (const auto& document : parseExamples())
    for (const auto& form : document.forms())
      std::visit([&](const auto& node) { used.add(node); }, form.node());
  return used;
}

/// The members of an enumeration up to `last`, without the first, which means "missing".
template <class Enum> std::set<Enum> allUpTo(Enum last) {
  std::set<Enum> all;
  for (int i = 1; i <= static_cast<int>(last); ++i) all.insert(static_cast<Enum>(i));
  return all;
}

template <class Enum> std::vector<int> unused(std::set<Enum> all, const std::set<Enum>& used) {
  std::vector<int> missing;
  for (auto kind : all)
    if (!used.contains(kind)) missing.push_back(static_cast<int>(kind));
  return missing;
}

/// Nodes of the grammar that occur only in programs with errors.
const std::set<std::string_view> kOfMistakes{"surplus_close",  "keyword",    "operator",
                                             "malformed_name", "unexpected", "list",
                                             "unknown_field"};

constexpr std::array kNodes{
#define NODE(name, type) std::string_view(type),
#include "syntax/tree/node_kinds.def"
#undef NODE
};

} // namespace

TEST_CASE("every kind of statement, expression and property is used in some example") {
  auto used = usedInExamples();
  const std::vector<int> none;
  CHECK(unused(allUpTo(StatementKind::Choose), used.statements) == none);
  CHECK(unused(allUpTo(ExprKind::StrongRelease), used.expressions) == none);
  CHECK(unused(allUpTo(PropertyKind::Ltl), used.properties) == none);
}

TEST_CASE("every definition and field of the grammar is used in some example") {
  std::string trees;
  for (const auto& document : parseExamples()) trees += document.dump();
  for (auto node : kNodes) {
    INFO(node);
    auto inTrees = trees.find("(" + std::string(node) + " ") != std::string::npos;
    CHECK(inTrees != kOfMistakes.contains(node));
  }
}
