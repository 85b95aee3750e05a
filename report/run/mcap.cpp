#include "report/run/mcap.h"

namespace proskill::report::mcap {

namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);

enum class Opcode : std::uint8_t {
  Header = 1,
  Footer = 2,
  Schema = 3,
  Channel = 4,
  Message = 5,
  DataEnd = 15
};

/// Little-endian.
template <class Number> void addNumber(std::string& to, Number number) {
  for (std::size_t i = 0; i < sizeof number; ++i)
    to += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i) & 0xff);
}

void addText(std::string& to, std::string_view text) {
  addNumber(to, static_cast<std::uint32_t>(text.size()));
  to += text;
}

void begin(std::string& to, Opcode opcode, std::uint64_t length) {
  to += static_cast<char>(opcode);
  addNumber(to, length);
}

void addRecord(std::string& to, Opcode opcode, std::string_view content) {
  begin(to, opcode, content.size());
  to += content;
}

} // namespace

void addHead(std::string& to) {
  to += kMagic;
  std::string content;
  addText(content, "");
  addText(content, "proskill");
  addRecord(to, Opcode::Header, content);
}

void addSchema(std::string& to, std::uint16_t id, std::string_view name, std::string_view schema) {
  std::string content;
  addNumber(content, id);
  addText(content, name);
  addText(content, "jsonschema");
  addText(content, schema);
  addRecord(to, Opcode::Schema, content);
}

void addChannel(std::string& to, std::uint16_t id, std::uint16_t schema, std::string_view topic) {
  std::string content;
  addNumber(content, id);
  addNumber(content, schema);
  addText(content, topic);
  addText(content, "json");
  addNumber(content, std::uint32_t{0}); // no metadata
  addRecord(to, Opcode::Channel, content);
}

void addMessage(std::string& to, std::uint16_t channel, std::uint32_t sequence, std::uint64_t time,
                std::string_view json) {
  begin(to, Opcode::Message, 2 + 4 + 8 + 8 + json.size());
  addNumber(to, channel);
  addNumber(to, sequence);
  addNumber(to, time); // when it was recorded, and when it was sent
  addNumber(to, time);
  to += json;
}

std::string tail() {
  std::string made;
  addRecord(made, Opcode::DataEnd, std::string(4, '\0'));        // no checksum
  addRecord(made, Opcode::Footer, std::string(8 + 8 + 4, '\0')); // no summary
  made += kMagic;
  return made;
}

} // namespace proskill::report::mcap
