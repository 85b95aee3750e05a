#pragma once

#include "fiacre/syntax/formula.h"
#include "fiacre/syntax/parse.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The parser's own pieces, shared by its files.
namespace proskill::fiacre {

/// Thrown where a construct cannot be read on; what it is part of is resumed further down the text.
struct CannotRead {};

/// A recursive descent over the tokens of a text. A file for each group of constructs.
class Parser {
public:
  explicit Parser(std::string_view text, PathSteps known = {});

  Parsed program();
  std::optional<Expr> wholeExpr();

private:
  // The tokens: parser.cpp
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
  [[nodiscard]] bool isAt(std::string_view text, std::size_t ahead = 0) const;
  /// `[]`, `()`: two signs that touch.
  [[nodiscard]] bool isAtPair(std::string_view open, std::string_view close) const;
  [[nodiscard]] bool isAtName() const;
  bool accept(std::string_view text);
  void expect(std::string_view text);
  std::string name(std::string_view what, NameKind kind, bool declares = false);
  std::vector<std::string> names(std::string_view what, NameKind kind, bool declares = false);
  /// Notes the token at hand.
  void mention(NameKind kind, bool declares = false);
  [[noreturn]] void fail(std::string message);
  void report(std::string message, const Token& at);
  template <class Element> auto list(std::string_view separator, Element element) {
    std::vector<decltype(element())> all;
    do all.push_back(element());
    while (accept(separator));
    return all;
  }
  OriginId origin(std::uint32_t begin, std::string words = {});
  [[nodiscard]] std::uint32_t lastEnd() const;

  // Declarations: parse.cpp
  [[nodiscard]] bool isAtDeclaration(std::size_t ahead = 0) const;
  [[nodiscard]] std::optional<NameKind> declared() const;
  [[nodiscard]] bool endsEntry(std::size_t ahead) const;
  void declaration();
  void resume();
  void constant();
  void typeDeclaration();
  void channel();
  void eventPort();
  void task();
  void external();
  void entry();
  void attachment();
  void finish();

  // Types, ports and bounds of time: parse_types.cpp
  Type type();
  Type records();
  Type unions();
  Type range();
  Expr constantExpr(std::size_t level);
  std::int64_t natural(std::string_view what);
  std::optional<std::int64_t> value(const Expr& expr) const;
  Interval interval();
  std::int64_t time();
  std::vector<Port> ports(bool probed = false);
  bool acceptNoValue();
  bool acceptChannel(Port& port);
  void portType(Port& port);
  std::vector<Parameter> parameters();
  std::vector<Variable> variables();
  std::vector<Type> typesInParentheses();

  // Expressions: parse_expressions.cpp
  Expr expr();
  Expr binary(std::size_t level);
  Expr prefix();
  Expr postfix();
  Expr primary();
  Expr number();
  Expr parenthesised();
  Expr record();
  Expr call(const std::string& callee);
  std::vector<Expr> exprs(std::string_view close);
  Expr lvalue();

  // Statements: parse_statements.cpp
  Statement statements();
  Statement statement();
  Statement plain();
  Statement startingWithName();
  Statement assignment(std::vector<Expr> targets);
  Statement conditional();
  Statement cases();
  Statement selection();
  Statement loop();
  Statement startTask();
  [[nodiscard]] bool isAtStart() const;

  // Processes, functions, components: parse_processes.cpp
  void function();
  Statement functionBody();
  void process();
  void from(Process& process);
  void component();
  std::vector<Priority> priorities();
  Instance instance();
  std::vector<Instance> composition();
  using PortSet = std::optional<std::vector<std::string>>; ///< nothing: `*`
  bool acceptPortSet(std::string_view closing, PortSet& ports);

  // Properties: parse_properties.cpp
  void property();
  void assertion();
  /// A word that begins a pattern.
  [[nodiscard]] bool isAtPattern(std::size_t ahead = 0) const;
  Pattern pattern();
  Pattern betweenTwo(Observable first);
  void scopes(Pattern& pattern);
  bool times(Pattern& pattern);
  void once(bool known);
  Ltl formula();
  Ltl formulaOrPatterns();
  Ltl joinedPattern(const Token& first, std::optional<Ltl> begun);
  Ltl formulaChain(std::size_t level);
  Ltl formulaUntil();
  Ltl formulaPrefix();
  Ltl formulaPrimary();
  Ltl namedFormula(const Ltl& formula);
  Observable observable();
  Observable observableUpTo(std::string_view word);
  Observable momentary(Ltl formula, const Token& first);
  Observable atom();
  std::optional<std::uint32_t> step();

  /// Counts how deep constructs are within each other, which the stack bounds.
  class Deeper;
  /// The height of a tree from those of its parts.
  class Height;
  class Within;

  std::string_view text;
  std::vector<Token> tokens;
  std::size_t at = 0;
  std::size_t depth = 0;
  std::size_t height = 0;     ///< of the expression or formula that was read last; 0: a leaf
  bool constantsOnly = false; ///< a `[` ends an interval's bound, and indexes nothing
  Parsed parsed;
  std::uint32_t path = 0; ///< of the atom that is read
  PathSteps steps;
  bool joinsPatterns = false; ///< patterns may stand among formulas
  bool hasPatterns = false;   ///< and one did
  std::string_view separator; ///< a word that does not join formulas here
  std::string actor;          ///< of the origins that are made
  std::map<std::string, std::int64_t, std::less<>> constants;
  std::map<std::string, Port, std::less<>> channels;
  /// Formulas that are properties by themselves; others name them.
  std::map<std::string, Ltl, std::less<>> formulas;
  std::size_t copied = 0;                           ///< nodes of those that others named
  std::vector<std::pair<std::string, Token>> paths; ///< names that paths begin with
};

class Parser::Deeper {
public:
  explicit Deeper(Parser& in);
  ~Deeper() { --parser.depth; }
  Deeper(const Deeper&) = delete;
  Deeper& operator=(const Deeper&) = delete;

private:
  Parser& parser;
};

class Parser::Height {
public:
  explicit Height(Parser& in) : parser(in) {}
  /// The tree that was read last is a part.
  void addPart() { tallest = std::max(tallest, parser.height); }
  /// The parts so far are below one node, which may become a part in turn.
  void addNode();

private:
  Parser& parser;
  std::size_t tallest = 0;
};

/// While it lives, names are looked for where a path leads.
class Parser::Within {
public:
  Within(Parser& in, PathTaken taken) : parser(in) {
    parser.parsed.paths.push_back(std::move(taken));
    parser.path = static_cast<std::uint32_t>(parser.parsed.paths.size() - 1);
  }
  ~Within() { parser.path = 0; }
  Within(const Within&) = delete;
  Within& operator=(const Within&) = delete;

private:
  Parser& parser;
};

} // namespace proskill::fiacre
