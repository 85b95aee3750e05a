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

/// Internals of the parser, shared by its files.
namespace proskill::fiacre {

/// Thrown at a syntax error; the enclosing construct continues further down the text.
struct CannotRead {};

/// A recursive-descent parser. Each group of constructs has its own file.
class Parser {
public:
  explicit Parser(std::string_view text, PathSteps known = {});

  Parsed program();
  std::optional<Expr> wholeExpr();

private:
  // Tokens: parser.cpp
  [[nodiscard]] const Token& peek(std::size_t ahead = 0) const;
  [[nodiscard]] bool isAt(std::string_view text, std::size_t ahead = 0) const;
  /// `[]`, `()`: two adjacent symbols.
  [[nodiscard]] bool isAtPair(std::string_view open, std::string_view close) const;
  [[nodiscard]] bool isAtName() const;
  bool accept(std::string_view text);
  void expect(std::string_view text);
  std::string name(std::string_view what, NameKind kind, bool declares = false);
  std::vector<std::string> names(std::string_view what, NameKind kind, bool declares = false);
  /// Records a mention at the current token.
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
  std::size_t namesBeforeColon();

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
  Statement patternAssignment();
  [[nodiscard]] bool isAtAssignedPattern() const;
  Expr matched();
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
  using PortSet = std::optional<std::vector<std::string>>; ///< nullopt: `*`
  bool acceptPortSet(std::string_view closing, PortSet& ports);

  // Properties: parse_properties.cpp
  void property();
  void assertion();
  /// Whether a word that begins a pattern is next.
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

  /// Counts the nesting depth of constructs, which the stack limits.
  class Deeper;
  /// Computes the height of a tree from its parts.
  class Height;
  class Within;

  std::string_view text;
  std::vector<Token> tokens;
  std::size_t at = 0;
  std::size_t depth = 0;
  std::size_t height = 0;     ///< of the expression or formula parsed last; 0: a leaf
  bool constantsOnly = false; ///< a `[` ends an interval's bound and is not an index
  Parsed parsed;
  std::uint32_t path = 0; ///< of the current atom
  PathSteps steps;
  bool inPattern = false;     ///< `any` is an expression
  bool joinsPatterns = false; ///< patterns may occur in formulas
  bool hasPatterns = false;   ///< and one did occur
  std::string_view separator; ///< a word that does not join formulas in this context
  std::string actor;          ///< of new origins
  std::map<std::string, std::int64_t, std::less<>> constants;
  std::map<std::string, Port, std::less<>> channels;
  /// Formulas of properties, which other formulas may name.
  std::map<std::string, Ltl, std::less<>> formulas;
  std::size_t copied = 0;                           ///< number of nodes copied from named formulas
  std::vector<std::pair<std::string, Token>> paths; ///< names with which paths begin
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
  /// Adds the tree parsed last as a part.
  void addPart() { tallest = std::max(tallest, parser.height); }
  /// The parts so far become children of one node, which may become a part in turn.
  void addNode();

private:
  Parser& parser;
  std::size_t tallest = 0;
};

/// During its lifetime, names are looked up in the scope of a path.
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
