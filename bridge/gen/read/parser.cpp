#include "bridge/gen/read/parser.h"

#include "bridge/gen/read/types.h"
#include "bridge/text/token_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace proskill::bridge::gen {
namespace {

/// The words of `#if X`: `if` and `X`.
std::pair<std::string_view, std::string_view> wordsOf(const Token& directive) {
  constexpr auto kBlanks = " \t\r";
  const auto trimmed = [&](std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text.substr(0, text.find_last_not_of(kBlanks) + 1);
  };
  const auto text = trimmed(std::string_view(directive.text).substr(1));
  const auto length = std::min(text.find_first_of(" \t\"<"), text.size());
  return {text.substr(0, length), trimmed(text.substr(length))};
}

/// `#include "file"` or `#include <file>`
std::expected<Word, Error> includeOf(const Token& directive) {
  const auto text = std::string_view(directive.text);
  const auto begin = text.find_first_of("\"<");
  const auto end = text.find_last_of("\">");
  if (begin == std::string_view::npos || end <= begin)
    return std::unexpected(Error{directive.place, "`#include` needs a file in quotes"});
  return Word{std::string(text.substr(begin + 1, end - begin - 1)), directive.place};
}

/// Sorts out the directives of the preprocessor. Those for the compiler of the component
/// (`#pragma`), and what makes a file be read once, do not matter.
class Directives {
public:
  explicit Directives(Parsed& to) : parsed(to) {}

  std::optional<Error> read(const Token& directive) {
    const auto [kind, rest] = wordsOf(directive);
    if (kind == "include") {
      auto include = includeOf(directive);
      if (!include) return include.error();
      parsed.includes.push_back(*std::move(include));
    } else if (kind == "define" && !rest.empty() && rest == guard) {
      parsed.ignored.pop_back();
    } else if (kind == "if" || kind == "ifdef" || kind == "ifndef" || kind == "elif" ||
               kind == "else" || (kind == "define" && rest.find(' ') != std::string_view::npos)) {
      parsed.ignored.push_back(
          {fmt::format("#{}{}{}", kind, rest.empty() ? "" : " ", rest), directive.place});
    }
    guard = kind == "ifndef" ? rest : "";
    return std::nullopt;
  }

private:
  Parsed& parsed;
  std::string guard = ""; ///< of the `#ifndef` just before
};

class Parser {
public:
  Parser(std::vector<Token> tokens, Parsed& parsed)
      : reader(std::move(tokens)), types(reader), parsed(parsed) {}

  std::optional<Error> run() {
    while (!reader.isAtEnd()) statement();
    append(parsed.exceptions, types.inModules);
    return reader.firstError();
  }

private:
  void statement() {
    if (reader.isAt("component") || reader.isAt("interface")) return component();
    if (types.declaration()) return;
    if (reader.isAt("exception")) return append(parsed.exceptions, types.exceptions());
    reader.fail("`component`, `interface` or a declaration of a type");
  }

  void component() {
    Component component;
    component.isInterface = reader.isAt("interface");
    reader.skip();
    component.name = reader.word("the name of a component");
    data = {};
    if (reader.takeIf("{")) reader.untilBrace([&] { member(component); });
    reader.takeIf(";");
    parsed.components.push_back(std::move(component));
  }

  void member(Component& component) {
    if (isServiceNext()) return component.services.push_back(service());
    if (reader.takeIf("ids")) {
      data = types.members();
    } else if (reader.takeIf("port")) {
      ++component.ports;
      port();
    } else if (reader.takeIf("task")) {
      ++component.tasks;
      reader.word("the name of a task");
      if (reader.isAt("{")) types.skipGroup();
    } else if (isOneOf({"provides", "provide", "extends", "extend"})) {
      append(component.provides, list("the name of an interface"));
    } else if (reader.isAt("exception")) {
      append(component.exceptions, types.exceptions());
    } else if (!types.declaration()) {
      property();
    }
    reader.takeIf(";");
  }

  bool isOneOf(std::initializer_list<std::string_view> words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return reader.takeIf(word); });
  }

  void port() {
    reader.takeIf("multiple");
    if (!isOneOf({"in", "out"})) reader.fail("`in` or `out`");
    types.declarator(types.type());
    if (reader.isAt("{")) types.skipGroup();
  }

  /// A property without influence on what services do, such as `version "1.0";`.
  void property() {
    reader.word("a part of a component");
    while (!reader.isAtEnd() && !reader.isAt(";") && !reader.isAt("}")) reader.skip();
  }

  [[nodiscard]] bool isServiceNext() const {
    return reader.isAt("attribute") || reader.isAt("function") || reader.isAt("activity");
  }

  Service service() {
    Service service;
    service.kind = reader.isAt("attribute")  ? ServiceKind::Attribute
                   : reader.isAt("function") ? ServiceKind::Function
                                             : ServiceKind::Activity;
    reader.skip();
    service.name = reader.word("the name of a service");
    reader.expect("(");
    while (!reader.isAtEnd() && !reader.isAt(")")) {
      service.parameters.push_back(parameter(service.kind));
      if (!reader.takeIf(",")) break;
    }
    reader.expect(")");
    if (reader.takeIf("{")) reader.untilBrace([&] { property(service); });
    reader.takeIf(";");
    return service;
  }

  Parameter parameter(ServiceKind kind) {
    Parameter parameter;
    parameter.isInput = reader.isAt("in") || reader.isAt("inout");
    if (!isOneOf({"in", "out", "inout"})) reader.fail("`in`, `out` or `inout`");
    if (kind == ServiceKind::Attribute)
      path(parameter);
    else {
      const auto [name, type] = types.declarator(types.type());
      parameter.name = name;
      parameter.scalar = type.scalar;
    }
    if (reader.takeIf("=")) types.skipExpression();
    return parameter;
  }

  /// A part of the internal data, which gives an attribute its name and its type.
  void path(Parameter& parameter) {
    const Type none;
    const Type* type = &data;
    do {
      parameter.name = reader.word("a part of `ids`");
      const auto found = type->members.find(parameter.name.text);
      type = found == type->members.end() ? &none : &found->second;
      parameter.scalar = types.skipBrackets() ? type->element : type->scalar;
    } while (reader.takeIf("."));
  }

  void property(Service& service) {
    reader.takeIf("async");
    if (reader.takeIf("codel"))
      service.codels.push_back(codel());
    else if (isOneOf({"throw", "throws"}))
      append(service.exceptions, list("the name of an exception"));
    else if (isOneOf({"interrupt", "interrupts"}))
      append(service.interrupts, list("the name of a service"));
    else if (reader.takeIf("before"))
      append(service.before, list("the name of a service"));
    else if (reader.takeIf("after"))
      append(service.after, list("the name of a service"));
    else
      property();
    reader.takeIf(";");
  }

  Codel codel() {
    Codel codel;
    if (reader.takeIf("<")) {
      do codel.states.push_back(reader.word("a state"));
      while (reader.takeIf(","));
      reader.expect(">");
    }
    codel.function = reader.word("the name of a codel");
    if (reader.isAt("("))
      types.skipGroup();
    else
      reader.fail("`(`");
    if (reader.takeIf("yield")) do
        codel.steps.push_back(step());
      while (reader.takeIf(","));
    else if (!codel.states.empty())
      reader.fail("`yield`");
    return codel;
  }

  Step step() {
    Step step{reader.word("a state"), false};
    if (step.state.text == "pause" && reader.takeIf("::")) step = {reader.word("a state"), true};
    return step;
  }

  /// Names in a list, each without its scope.
  std::vector<Word> list(std::string_view what) {
    std::vector<Word> words;
    do {
      reader.takeIf("::");
      auto word = reader.word(what);
      while (reader.takeIf("::")) word = reader.word(what);
      words.push_back(std::move(word));
    } while (reader.takeIf(","));
    return words;
  }

  TokenReader reader;
  Types types;
  Parsed& parsed;
  Type data; ///< `ids` of the component
};

} // namespace

std::expected<Parsed, Error> parse(std::string_view text, const std::filesystem::path& file) {
  auto tokens = tokensOf(text, file);
  if (!tokens) return std::unexpected(tokens.error());
  Parsed parsed;
  Directives directives(parsed);
  for (const auto& token : *tokens)
    if (token.kind == TokenKind::Directive)
      if (auto error = directives.read(token)) return std::unexpected(*std::move(error));
  std::erase_if(*tokens, [](const auto& token) { return token.kind == TokenKind::Directive; });
  if (auto error = Parser(std::move(*tokens), parsed).run()) return std::unexpected(*error);
  return parsed;
}

} // namespace proskill::bridge::gen
