#include "ide/features/tokens.h"
#include "tests/ide/marked_program.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using ide::TokenType;
using test::MarkedProgram;

namespace {

/// The marked tokens.
std::vector<ide::Token> markedTokens(const MarkedProgram& program) {
  auto all = ide::tokens(program.view());
  auto marked = program.marked();
  std::erase_if(all, [&](const ide::Token& token) {
    return std::ranges::find(marked, analysis::Location{program.view().file, token.range}) ==
           marked.end();
  });
  return all;
}

void checkTokens(std::string_view text, TokenType type, unsigned modifiers = 0) {
  INFO(text);
  const MarkedProgram program(text);
  auto tokens = markedTokens(program);
  CHECK(tokens.size() == program.marked().size());
  for (const auto& token : tokens) {
    CHECK(token.type == type);
    CHECK(token.modifiers == modifiers);
  }
}

} // namespace

TEST_CASE("names are coloured by what they name") {
  const std::string lamp = "(defsv lamp :states (On Off) :init Off)";
  checkTokens(lamp + "(defevent e :effects (lamp [[On]]))", TokenType::Value);
  checkTokens(lamp + "(defevent e :effects ([[lamp]] On))", TokenType::Variable, ide::kWritten);
  checkTokens(lamp + "(defproperty p (always ([[lamp]] On)))", TokenType::Variable);
  checkTokens(lamp + "(defevent [[e]] :effects (lamp On))", TokenType::Event,
              ide::kDefinition | ide::kUnused);
  checkTokens("(defskill f :action (x)) (defskill m :body (([[f]])))", TokenType::Skill);
  checkTokens("(defskill [[f]] :action (x)) (defskill m :body ((f)))", TokenType::Skill,
              ide::kDefinition);
  checkTokens("(defskill m :body ((goto [[l]]) (label l)))", TokenType::Label);
  checkTokens("(defskill m :body ((label [[l]])))", TokenType::Label,
              ide::kDefinition | ide::kUnused);
  checkTokens("(defskill f :input ($a [[float]]) :action (x $a))", TokenType::Type);
  checkTokens("(defskill f :input ($a float) :action (x [[$a]]))", TokenType::Parameter);
  checkTokens("(defskill f :input ($a bool) :precondition (p [[$a]]) :action (x))",
              TokenType::Parameter);
  checkTokens("(defskill f :success [[done]] :action (x))", TokenType::Tag, ide::kDefinition);
  checkTokens("(defconst two 2) (defresource arm :capacity [[two]])", TokenType::Value);
  checkTokens("(defconst two 2) (defskill m :body ((^ [1,[[two]]])))", TokenType::Value);
  checkTokens("(defresource arm) (defskill f :resources ([[arm]]) :action (x))",
              TokenType::Resource);
}

TEST_CASE("words, signs and comments are coloured by what they are") {
  checkTokens("([[defskill]] m :body (([[if]] [[true]] [[break]])))", TokenType::Keyword);
  checkTokens("(defsv a [[:init]] 1 [[:max]] 2)", TokenType::Field);
  checkTokens("(defsv a :init [[1]] :max [[2]])", TokenType::Number);
  checkTokens("(defevent e) [[; a note]]\n[[; more]]", TokenType::Comment);
  checkTokens("(defskill m :body (([[//]] ((f)) ((g)))))", TokenType::Operator);
  checkTokens("(defskill m :body ((printf [[\"a; b\"]])))", TokenType::String);
}

TEST_CASE("the tokens of every range are those of the whole") {
  const MarkedProgram program("; c\n(defsv lamp :states (On Off) :init Off)\n"
                              "(defevent e :effects (lamp On)) (defskill m :body ((^ [1,2])))\n");
  auto all = ide::tokens(program.view());
  auto end = static_cast<syntax::Offset>(program.view().text().size());
  for (syntax::Offset first = 0; first < end; ++first)
    for (syntax::Offset last = first; last < end; ++last) {
      std::vector<ide::Token> expected;
      for (const auto& token : all)
        if (token.range.end >= first && token.range.begin <= last) expected.push_back(token);
      if (ide::tokens(program.view(), {first, last}) != expected) FAIL(first << " " << last);
    }
}
