#pragma once

#include "rpc/rpc.h"

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Writes JSON directly as text, for answers with thousands of parts. A `Json` tree would need an
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
  /// Writes a line number and remembers its position, so that it can be changed later.
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

  /// Inserts a comma if one is needed; the last character shows this, since strings end with a
  /// quotation mark.
  void separate() {
    if (!text.empty() && text.back() != '{' && text.back() != '[' && text.back() != ':')
      text += ',';
  }

  friend class MovableJson;

  std::string text;
  std::vector<std::uint32_t> lines; ///< positions of line numbers in the text
};

/// JSON about neighbouring places in a text, which can be moved to other lines.
class MovableJson {
public:
  MovableJson() = default;
  /// \param first the first line of these places when it was written
  MovableJson(JsonWriter json, std::uint32_t first)
      : text(std::move(json.text)), lines(std::move(json.lines)), first(first) {}

  [[nodiscard]] std::size_t size() const { return text.size(); }
  /// Writes the JSON with `now` as the first line of these places. Writes nothing if it is empty.
  void write(JsonWriter& json, std::uint32_t now) const;

private:
  std::string text;
  std::vector<std::uint32_t> lines;
  std::uint32_t first = 0;
};

/// A value that contains JSON text: a binary value, which does not occur in messages of the
/// protocol. `dump` writes its text unchanged.
[[nodiscard]] Json written(std::string_view json);

/// The approximate number of bytes that `dump` will write, for `reserve`.
[[nodiscard]] std::size_t sizeOf(const Json& json);
/// The text of a message or a part of one.
[[nodiscard]] std::string dump(const Json& json);

} // namespace proskill::rpc
