#include "bridge/gen/read/types.h"

#include <fmt/format.h>

#include <utility>

namespace proskill::bridge::gen {
namespace {

constexpr std::size_t kDeepest = 100;

} // namespace

bool Types::declaration() {
  if (reader.isAt("module")) {
    module();
  } else if (reader.takeIf("typedef")) {
    names(type());
    reader.takeIf(";");
  } else if (reader.takeIf("const")) {
    declarator(type());
    reader.expect("=");
    skipExpression();
    reader.takeIf(";");
  } else if (reader.takeIf("native")) {
    known[reader.word("a name").text] = {};
    reader.takeIf(";");
  } else if (reader.isAt("struct") || reader.isAt("union") || reader.isAt("enum")) {
    type();
    reader.takeIf(";");
  } else {
    return false;
  }
  return true;
}

void Types::module() {
  reader.expect("module");
  reader.word("a name");
  if (++depth > kDeepest) return reader.fail("less deep modules");
  reader.expect("{");
  reader.untilBrace([&] {
    if (declaration()) return;
    const auto names = exceptions();
    if (names.empty()) reader.fail("a declaration");
    inModules.insert(inModules.end(), names.begin(), names.end());
  });
  reader.takeIf(";");
  --depth;
}

std::vector<Word> Types::exceptions() {
  std::vector<Word> names;
  if (!reader.takeIf("exception")) return names;
  do {
    names.push_back(reader.word("the name of an exception"));
    if (reader.isAt("{")) members();
  } while (reader.takeIf(","));
  reader.takeIf(";");
  return names;
}

void Types::names(const Type& type) {
  do {
    const auto [name, own] = declarator(type);
    known[name.text] = own;
  } while (reader.takeIf(","));
}

Type Types::members() {
  Type all;
  reader.expect("{");
  reader.untilBrace([&] {
    const auto common = type();
    do {
      auto [name, own] = declarator(common);
      all.members[name.text] = std::move(own);
    } while (reader.takeIf(","));
    reader.takeIf(";");
  });
  return all;
}

std::pair<Word, Type> Types::declarator(const Type& type) {
  std::pair<Word, Type> result{reader.word("a name"), type};
  if (skipBrackets()) result.second.element = std::exchange(result.second.scalar, "string");
  return result;
}

bool Types::skipBrackets() {
  const bool isThere = reader.isAt("[");
  while (reader.isAt("[")) skipGroup();
  return isThere;
}

Type Types::structure() {
  const bool isStruct = reader.takeIf("struct");
  if (!isStruct) reader.skip(); // `union` or `enum`
  const auto name = reader.word("a name");
  if (reader.takeIf("switch")) skipGroup();
  Type result;
  if (++depth > kDeepest)
    reader.fail("less deep structures");
  else if (isStruct && reader.isAt("{"))
    result = members();
  else if (reader.isAt("{"))
    skipGroup();
  --depth;
  known[name.text] = result;
  return result;
}

Type Types::type() {
  if (reader.isAt("struct") || reader.isAt("union") || reader.isAt("enum")) return structure();
  if (reader.isAt("sequence") || reader.isAt("string") || reader.isAt("wstring") ||
      reader.isAt("optional") || reader.isAt("fixed"))
    return sequence();
  return base();
}

/// A type with parameters in angle brackets, if any.
Type Types::sequence() {
  reader.skip();
  std::size_t open = reader.isAt("<") ? 1 : 0;
  while (open > 0 && !reader.isAtEnd()) {
    reader.skip();
    open += reader.isAt("<") ? 1 : 0;
    open -= reader.isAt(">") ? 1 : 0;
    if (open == 0) reader.skip();
  }
  return {};
}

Type Types::base() {
  const bool isUnsigned = reader.takeIf("unsigned");
  if (reader.takeIf("short")) return {isUnsigned ? "nat" : "int", {}};
  if (reader.takeIf("long")) {
    reader.takeIf("long");
    return {isUnsigned ? "nat" : "int", {}};
  }
  if (isUnsigned) reader.fail("`short` or `long`");
  if (reader.takeIf("float") || reader.takeIf("double")) return {"float", {}};
  if (reader.takeIf("boolean")) return {"bool", {}};
  if (reader.takeIf("octet")) return {"nat", {}};
  return named();
}

Type Types::named() {
  reader.takeIf("::");
  auto name = reader.word("a type");
  while (reader.takeIf("::")) name = reader.word("a type");
  const auto found = known.find(name.text);
  return found == known.end() ? Type() : found->second;
}

void Types::skipGroup() {
  std::size_t open = 0;
  do {
    open += reader.isAt("(") || reader.isAt("{") || reader.isAt("[") ? 1 : 0;
    open -= reader.isAt(")") || reader.isAt("}") || reader.isAt("]") ? 1 : 0;
    reader.skip();
  } while (open > 0 && !reader.isAtEnd());
  if (open > 0) reader.fail("the end of what is in parentheses or braces");
}

void Types::skipExpression() {
  while (!reader.isAtEnd() && !reader.isAt(",") && !reader.isAt(")") && !reader.isAt(";"))
    if (reader.isAt("(") || reader.isAt("{") || reader.isAt("["))
      skipGroup();
    else
      reader.skip();
}

} // namespace proskill::bridge::gen
