#include "rpc/rpc.h"

#include "rpc/json_writer.h"
#include "syntax/text/utf8.h"
#include <algorithm>
#include <charconv>

namespace proskill::rpc {

namespace {

JsonWriter envelope(const Json& content) {
  JsonWriter text;
  text.reserve(sizeOf(content) + 100);
  text.open('{').member("jsonrpc", "2.0");
  return text;
}

bool isIdentifier(const Json& id) { return id.is_number_integer() || id.is_string(); }

MalformedMessage malformed(std::string message, Json id = nullptr) {
  return {{ErrorCode::InvalidRequest, std::move(message)}, std::move(id)};
}

Json memberOrNull(const Json& json, const char* name) {
  auto found = json.find(name);
  return found == json.end() ? Json() : *found;
}

std::expected<Message, MalformedMessage> call(const Json& json, Json id) {
  Message message;
  message.kind = json.contains("id") ? MessageKind::Request : MessageKind::Notification;
  message.method = json["method"].get<std::string>();
  message.params = memberOrNull(json, "params");
  if (message.kind == MessageKind::Request && !isIdentifier(id))
    return std::unexpected(malformed("`id` is neither a number nor a string"));
  message.id = std::move(id);
  if (!message.params.is_null() && !message.params.is_structured())
    return std::unexpected(malformed("`params` is neither an object nor an array", message.id));
  return message;
}

/// The UTF-16 unit of an escape such as `\ud83d`; nullopt if there is none.
std::optional<unsigned> escapedUnit(std::string_view text) {
  constexpr std::size_t kLength = 6;
  unsigned unit = 0;
  if (text.size() < kLength || !text.starts_with("\\u")) return std::nullopt;
  const auto read = std::from_chars(text.data() + 2, text.data() + kLength, unit, 16);
  return read.ptr == text.data() + kLength ? std::optional(unit) : std::nullopt;
}

/// The first character of a JSON text: number of its bytes, and the text that replaces them. An
/// invalid or incomplete character becomes U+FFFD.
std::pair<std::size_t, std::string_view> wholeCharacter(std::string_view text) {
  if (text.front() != '\\') {
    const auto length = syntax::sequenceLength(text);
    return length > 0 ? std::pair(length, text.substr(0, length))
                      : std::pair(std::size_t{1}, syntax::kReplacement);
  }
  constexpr std::size_t kEscape = 6;
  const auto isIn = [](std::optional<unsigned> unit, unsigned first) {
    return unit && *unit >= first && *unit < first + 0x400;
  };
  const auto unit = escapedUnit(text);
  if (!isIn(unit, 0xD800) && !isIn(unit, 0xDC00)) return {2, text.substr(0, 2)};
  const bool isPair = isIn(unit, 0xD800) && isIn(escapedUnit(text.substr(kEscape)), 0xDC00);
  return isPair ? std::pair(2 * kEscape, text.substr(0, 2 * kEscape))
                : std::pair(kEscape, syntax::kReplacement);
}

std::string withWholeCharacters(std::string_view body) {
  std::string result;
  while (!body.empty()) {
    const auto [length, text] = wholeCharacter(body);
    result += text;
    body.remove_prefix(std::min(length, body.size()));
  }
  return result;
}

std::expected<Message, MalformedMessage> messageOf(const Json& json) {
  if (!json.is_object()) return std::unexpected(malformed("the message must be an object"));
  auto id = memberOrNull(json, "id");
  if (memberOrNull(json, "jsonrpc") != "2.0")
    return std::unexpected(malformed("`jsonrpc` is not \"2.0\"", isIdentifier(id) ? id : Json()));
  auto method = memberOrNull(json, "method");
  if (method.is_string()) return call(json, std::move(id));
  if (!method.is_null() || !json.contains("id"))
    return std::unexpected(malformed("`method` must be a string", isIdentifier(id) ? id : Json()));
  Message message;
  message.kind = MessageKind::Response;
  message.id = std::move(id);
  message.result = memberOrNull(json, "result");
  message.error = memberOrNull(json, "error");
  return message;
}

} // namespace

std::expected<Message, MalformedMessage> parseMessage(std::string_view body) {
  auto json = Json::parse(body, nullptr, false);
  if (!json.is_discarded()) return messageOf(json);
  json = Json::parse(withWholeCharacters(body), nullptr, false);
  if (json.is_discarded())
    return std::unexpected(
        MalformedMessage{{ErrorCode::ParseError, "the message is not valid JSON"}, {}});
  auto message = messageOf(json);
  if (message) message->isRepaired = true;
  return message;
}

std::string request(const Json& id, std::string_view method, const Json& params) {
  auto text = envelope(params).member("id", id).member("method", method);
  if (!params.is_null()) text.member("params", params);
  return text.close('}').take();
}

std::string notification(std::string_view method, const Json& params) {
  return envelope(params).member("method", method).member("params", params).close('}').take();
}

std::string reply(const Json& id, const Json& result) {
  return envelope(result).member("id", id).member("result", result).close('}').take();
}

std::string replyError(const Json& id, const RpcError& error) {
  Json json{{"code", static_cast<int>(error.code)}, {"message", error.message}};
  if (!error.data.is_null()) json["data"] = error.data;
  return envelope(json).member("id", id).member("error", json).close('}').take();
}

const Json& memberAt(const Json& json, std::initializer_list<const char*> path) {
  static const Json nothing;
  const Json* value = &json;
  for (const auto* name : path) {
    if (!value->is_object()) return nothing;
    auto found = value->find(name);
    if (found == value->end()) return nothing;
    value = &*found;
  }
  return *value;
}

} // namespace proskill::rpc
