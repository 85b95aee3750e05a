#pragma once

#include "rpc/rpc.h"

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Writes JSON directly as text, for answers with thousands of parts: a tree of `Json` needs an
/// allocation and a deallocation for each member of each part.
namespace proskill::rpc {

/// Inserts commas. The caller must match brackets and give keys to members.
class JsonWriter {
public:
  JsonWriter& open(char bracket) {
    separate();
    text += bracket;
    return *this;
  }
  JsonWriter& close(char bracket) {
    text += bracket;
    return *this;
  }
  /// \pre the name needs no escapes
  JsonWriter& key(std::string_view name) {
    separate();
    text += '"';
    text += name;
    text += "\":";
    return *this;
  }

  /// Invalid UTF-8 becomes replacement characters.
  JsonWriter& value(std::string_view string);
  JsonWriter& value(const char* string) { return value(std::string_view(string)); }
  JsonWriter& value(const std::string& string) { return value(std::string_view(string)); }
  JsonWriter& value(const Json& json);
  template <std::integral Number> JsonWriter& value(Number number) {
    if constexpr (std::same_as<Number, bool>)
      return written(number ? "true" : "false");
    else
      separate();
    return digits(static_cast<std::int64_t>(number));
  }
  /// An enumeration with the numbers of a protocol.
  template <class Number>
  requires std::is_enum_v<Number> JsonWriter& value(Number number) {
    return value(std::to_underlying(number));
  }
  /// A text that is already JSON.
  JsonWriter& written(std::string_view json) {
    separate();
    text += json;
    return *this;
  }
  /// The number of a line as the value of a key: its place is remembered, so that it can be written
  /// anew.
  JsonWriter& line(std::uint32_t number) {
    lines.push_back(static_cast<std::uint32_t>(text.size()));
    return value(number);
  }
  template <class Value> JsonWriter& member(std::string_view name, const Value& what) {
    return key(name).value(what);
  }

  void reserve(std::size_t bytes) { text.reserve(text.size() + bytes); }
  [[nodiscard]] const std::string& str() const { return text; }
  [[nodiscard]] std::string take() { return std::exchange(text, {}); }

private:
  JsonWriter& digits(std::int64_t number);

  /// Strings end with a quotation mark, so that the last character says what came before.
  void separate() {
    if (!text.empty() && text.back() != '{' && text.back() != '[' && text.back() != ':')
      text += ',';
  }

  friend class MovableJson;

  std::string text;
  std::vector<std::uint32_t> lines; ///< where the numbers of lines begin in it
};

/// JSON of things that are near each other in a text, and can be moved to other lines of it.
class MovableJson {
public:
  MovableJson() = default;
  /// Written where these things began in the line `first`.
  MovableJson(JsonWriter json, std::uint32_t first)
      : text(std::move(json.text)), lines(std::move(json.lines)), first(first) {}

  [[nodiscard]] std::size_t size() const { return text.size(); }
  /// As it would be where they begin in the line `now`. Writes nothing where nothing was written.
  void write(JsonWriter& json, std::uint32_t now) const;

private:
  std::string text;
  std::vector<std::uint32_t> lines;
  std::uint32_t first = 0;
};

/// A value that stands for text which is JSON already: one of the binary kind, which no message of
/// the protocol has. `dump` writes it as it is.
[[nodiscard]] Json written(std::string_view json);

/// About how many bytes `dump` will write, for `reserve`.
[[nodiscard]] std::size_t sizeOf(const Json& json);
/// The text of a message or a part of one.
[[nodiscard]] std::string dump(const Json& json);

} // namespace proskill::rpc
