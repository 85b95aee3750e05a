#include "rpc/json_writer.h"

#include <algorithm>
#include <charconv>

namespace proskill::rpc {

namespace {

bool isPlain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte < 0x80 && c != '"' && c != '\\';
}

} // namespace

JsonWriter& JsonWriter::value(std::string_view string) {
  separate();
  if (std::ranges::all_of(string, isPlain)) {
    text += '"';
    text += string;
    text += '"';
  } else {
    text += Json(string).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return *this;
}

JsonWriter& JsonWriter::digits(std::int64_t number) {
  char buffer[24];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr);
  return *this;
}

JsonWriter& JsonWriter::value(const Json& json) {
  switch (json.type()) {
  case Json::value_t::object:
    open('{');
    for (const auto& [name, part] : json.get_ref<const Json::object_t&>()) {
      value(std::string_view(name)).text += ':';
      value(part);
    }
    return close('}');
  case Json::value_t::array:
    open('[');
    for (const auto& part : json) value(part);
    return close(']');
  case Json::value_t::binary: {
    const auto& bytes = json.get_binary();
    return written({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  case Json::value_t::string: return value(std::string_view(json.get_ref<const std::string&>()));
  default: return written(json.dump());
  }
}

void MovableJson::write(JsonWriter& json, std::uint32_t now) const {
  if (text.empty()) return;
  json.separate();
  std::size_t done = 0;
  if (now != first)
    for (const std::size_t at : lines) {
      json.text.append(text, done, at - done);
      std::uint32_t line = 0;
      done = static_cast<std::size_t>(
          std::from_chars(text.data() + at, text.data() + text.size(), line).ptr - text.data());
      json.digits(line - first + now);
    }
  json.text.append(text, done);
}

Json written(std::string_view json) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(json.data()); // copied as one block
  return Json::binary(Json::binary_t::container_type(bytes, bytes + json.size()));
}

std::size_t sizeOf(const Json& json) {
  constexpr std::size_t kScalar = 12;
  std::size_t sum = kScalar;
  switch (json.type()) {
  case Json::value_t::object:
    for (const auto& [name, part] : json.get_ref<const Json::object_t&>())
      sum += name.size() + sizeOf(part);
    return sum;
  case Json::value_t::array:
    for (const auto& part : json) sum += sizeOf(part);
    return sum;
  case Json::value_t::binary: return json.get_binary().size() + 1;
  case Json::value_t::string: return json.get_ref<const std::string&>().size() + 3;
  default: return sum;
  }
}

std::string dump(const Json& json) {
  JsonWriter text;
  text.reserve(sizeOf(json));
  return text.value(json).take();
}

} // namespace proskill::rpc
