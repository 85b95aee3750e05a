#include "fiacre/syntax/parser.h"

#include "fiacre/syntax/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::fiacre {

namespace {

// The threads have stacks of 8 MiB. Measured with `ulimit -s`: checking an expression takes 1.1 KiB
// per level of its tree (3 KiB with the address sanitizer), reading it 4 KiB per nested construct
// (10 KiB). A parenthesis counts as two constructs.

/// Maximum height of the tree of an expression or formula.
constexpr std::size_t kTallest = 2'000;
/// Maximum depth of nested constructs.
constexpr std::size_t kDeepest = 500;

std::string shown(const Token& token) {
  return token.kind == TokenKind::End ? "the end of the text" : fmt::format("`{}`", token.text);
}

} // namespace

Parser::Parser(std::string_view read, PathSteps known) : text(read), steps(std::move(known)) {
  tokens = tokenize(text, parsed.problems);
}

Parser::Deeper::Deeper(Parser& in) : parser(in) {
  if (++parser.depth <= kDeepest) return;
  --parser.depth;
  parser.fail("this is nested too deeply");
}

void Parser::Height::addNode() {
  parser.height = ++tallest;
  if (tallest > kTallest) parser.fail("this expression has too many operators in a row");
}

const Token& Parser::peek(std::size_t ahead) const {
  return tokens[std::min(at + ahead, tokens.size() - 1)];
}

bool Parser::isAt(std::string_view wanted, std::size_t ahead) const {
  const Token& token = peek(ahead);
  return token.text == wanted && token.kind != TokenKind::End && token.kind != TokenKind::String;
}

bool Parser::isAtPair(std::string_view open, std::string_view close) const {
  return isAt(open) && isAt(close, 1) && peek().end() == peek(1).begin;
}

bool Parser::isAtName() const { return peek().kind == TokenKind::Name && !isKeyword(peek().text); }

bool Parser::accept(std::string_view wanted) {
  if (!isAt(wanted)) return false;
  ++at;
  return true;
}

void Parser::expect(std::string_view wanted) {
  if (!accept(wanted)) fail(fmt::format("`{}` is missing before {}", wanted, shown(peek())));
}

std::string Parser::name(std::string_view what, NameKind kind, bool declares) {
  const Token& token = peek();
  if (token.kind == TokenKind::Name && isKeyword(token.text))
    fail(fmt::format("{} is missing: `{}` is a keyword of Fiacre", what, token.text));
  if (token.kind != TokenKind::Name)
    fail(fmt::format("{} is missing before {}", what, shown(token)));
  mention(kind, declares);
  ++at;
  return std::string(token.text);
}

std::vector<std::string> Parser::names(std::string_view what, NameKind kind, bool declares) {
  return list(",", [&] { return name(what, kind, declares); });
}

void Parser::mention(NameKind kind, bool declares) {
  parsed.mentions.push_back({peek().begin, peek().end(), kind, declares, path});
}

void Parser::fail(std::string message) {
  report(std::move(message), peek());
  throw CannotRead();
}

void Parser::report(std::string message, const Token& token) {
  parsed.problems.push_back({std::move(message), token.begin, token.end()});
}

std::uint32_t Parser::lastEnd() const { return at == 0 ? 0 : tokens[at - 1].end(); }

OriginId Parser::origin(std::uint32_t begin, std::string words) {
  parsed.provenance.origins.push_back({0, begin, lastEnd(), actor, std::move(words)});
  return static_cast<OriginId>(parsed.provenance.origins.size() - 1);
}

} // namespace proskill::fiacre
