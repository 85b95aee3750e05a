#include "tests/lsp/support/byte_places.h"

#include <fmt/format.h>

#include <stdexcept>

namespace proskill::test {

namespace {

bool isPosition(const Json& json) {
  return json.is_object() && json.size() == 2 && json.contains("line") &&
         json.contains("character");
}

bool isRange(const Json& json) {
  return json.is_object() && json.size() == 2 && json.contains("start") && json.contains("end");
}

bool isFold(const Json& json) {
  return json.is_object() && json.contains("startLine") && json.contains("endLine");
}

syntax::EditorPosition positionOf(const Json& json) {
  return {json["line"].get<std::uint32_t>(), json["character"].get<std::uint32_t>()};
}

[[noreturn]] void complain(const std::string& what, const Json& json) {
  throw std::runtime_error(what + ": " + json.dump());
}

/// The text that the positions in an object refer to.
std::string uriWithin(const Json& object, const std::string& uri) {
  for (const auto* name : {"uri", "targetUri"})
    if (object.contains(name) && object[name].is_string()) return object[name];
  // the ranges of an incoming call are in the caller's text
  for (const auto* name : {"textDocument", "from"}) {
    const auto& nested = rpc::memberAt(object, {name, "uri"});
    if (nested.is_string()) return nested;
  }
  return uri;
}

} // namespace

syntax::Offset BytePlaces::byteOf(syntax::EditorPosition position, const std::string& uri) const {
  auto found = documents.find(uri);
  if (found == documents.end()) throw std::runtime_error("a place in no text: " + uri);
  const auto& document = found->second;
  auto at = syntax::fromEditor(document.text(), document.lines(), position, encoding);
  if (syntax::toEditor(document.text(), document.lines(), at, encoding) != position)
    throw std::runtime_error(fmt::format("{}: line {}, character {} is no place in the text", uri,
                                         position.line, position.character));
  return at;
}

Json BytePlaces::convertObject(const Json& object, const std::string& uri) const {
  const auto within = uriWithin(object, uri);
  Json result = Json::object();
  for (const auto& [name, value] : object.items())
    result[name] = convert(value, name.starts_with("file:") ? name : within);
  // a link's origin is in the requested text, its target elsewhere
  if (object.contains("originSelectionRange"))
    result["originSelectionRange"] = convert(object["originSelectionRange"], uri);
  if (isFold(object))
    for (const auto* side : {"start", "end"}) {
      const auto line = std::string(side) + "Line";
      const auto character = std::string(side) + "Character";
      if (!object.contains(character)) continue;
      result[character] =
          byteOf({object[line].get<std::uint32_t>(), object[character].get<std::uint32_t>()}, uri);
    }
  if (object.contains("range") && object.contains("selectionRange")) {
    const auto& outer = result["range"];
    const auto& inner = result["selectionRange"];
    if (inner[0] < outer[0] || inner[1] > outer[1]) complain("a name outside of its thing", object);
  }
  return result;
}

Json BytePlaces::convert(const Json& answer, const std::string& uri) const {
  if (isPosition(answer)) return byteOf(positionOf(answer), uri);
  if (isRange(answer) && isPosition(answer["start"]) && isPosition(answer["end"])) {
    auto begin = byteOf(positionOf(answer["start"]), uri);
    auto end = byteOf(positionOf(answer["end"]), uri);
    if (end < begin) complain("a range that ends before it begins", answer);
    return {begin, end};
  }
  if (answer.is_object()) return convertObject(answer, uri);
  if (!answer.is_array()) return answer;
  Json result = Json::array();
  for (const auto& item : answer) result.push_back(convert(item, uri));
  return result;
}

Json BytePlaces::convertTokens(const Json& data, const std::string& uri) const {
  constexpr std::size_t kNumbers = 5; // line, character, length, type, modifiers
  if (data.size() % kNumbers != 0) complain("numbers that are no tokens", data.size());
  Json result = Json::array();
  syntax::EditorPosition at;
  syntax::Offset previous = 0;
  for (std::size_t i = 0; i < data.size(); i += kNumbers) {
    auto number = [&](std::size_t which) { return data[i + which].get<std::uint32_t>(); };
    at = {at.line + number(0), number(0) > 0 ? number(1) : at.character + number(1)};
    auto begin = byteOf(at, uri);
    auto end = byteOf({at.line, at.character + number(2)}, uri);
    if (begin < previous || end <= begin) complain("tokens that overlap", {begin, end});
    previous = end;
    result.push_back({begin, end, number(3), number(4)});
  }
  return result;
}

} // namespace proskill::test
