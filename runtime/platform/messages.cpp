#include "runtime/platform/messages.h"

#include "runtime/platform/json.h"

#include <algorithm>
#include <charconv>

namespace proskill::runtime {

namespace {

/// What is written keeps its order.
using Written = nlohmann::ordered_json;

std::string lineOf(const Written& message) {
  return message.dump(-1, ' ', false, Written::error_handler_t::replace) + '\n';
}

template <class Number> std::optional<Number> numberIn(std::string_view text) {
  Number number{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool all = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return all ? std::optional(number) : std::nullopt;
}

/// The text of a string literal.
std::string unescaped(std::string_view literal) {
  literal.remove_prefix(1);
  if (literal.ends_with('"')) literal.remove_suffix(1);
  std::string text;
  for (std::size_t i = 0; i < literal.size(); ++i) {
    if (literal[i] != '\\' || i + 1 == literal.size()) {
      text += literal[i];
      continue;
    }
    const char escaped = literal[++i];
    text += escaped == 'n' ? '\n' : escaped == 't' ? '\t' : escaped;
  }
  return text;
}

/// An argument as JSON. A value of a state variable becomes a string.
Written valueOf(const std::string& literal) {
  if (literal.empty()) return nullptr;
  if (literal == "true" || literal == "false") return literal == "true";
  if (literal.starts_with('"')) return unescaped(literal);
  if (const auto integer = numberIn<std::int64_t>(literal)) return *integer;
  if (const auto number = numberIn<double>(literal)) return *number;
  return literal;
}

RunNumber runOf(const Json& message) {
  const auto found = message.find("run");
  if (found == message.end() || !found->is_number_unsigned())
    throw Wrong{"`run` must be the number of a start"};
  return found->get<RunNumber>();
}

Message messageOf(const Json& json) {
  if (!json.is_object()) throw Wrong{"it is not a JSON object"};
  const auto& type = stringAt(json, "type");
  using Kind = Message::Kind;
  if (type == "result")
    return {.kind = Kind::Result, .run = runOf(json), .name = stringAt(json, "result")};
  if (type == "stopped") return {.kind = Kind::Stopped, .run = runOf(json)};
  if (type == "event") return {.kind = Kind::Event, .name = stringAt(json, "name")};
  if (type == "interrupt") return {.kind = Kind::Interrupt, .name = stringAt(json, "skill")};
  if (type == "log") return {.kind = Kind::Log, .text = stringAt(json, "text")};
  if (type == "failed")
    return {.kind = Kind::Failed,
            .run = json.contains("run") ? runOf(json) : 0,
            .name = json.contains("skill") ? stringAt(json, "skill") : "",
            .text = stringAt(json, "text")};
  if (type != "ready") throw Wrong{"there is no message `" + type + "`"};
  const auto protocol = json.find("protocol");
  if (protocol == json.end() || !protocol->is_number_integer())
    throw Wrong{"`protocol` must be a number"};
  return {.kind = Kind::Ready, .protocol = protocol->get<std::int64_t>()};
}

} // namespace

const std::string& resultName(const codegen::Performed::Result& result) {
  return result.tag.empty() ? result.status : result.tag;
}

std::string helloMessage(const Executable& executable, const ProcessSettings& settings) {
  const auto& model = executable.model;
  const auto& elsewhere = settings.elsewhere;
  Written hello{{"type", "hello"},
                {"protocol", kProtocol},
                {"mission", model.mainSkill},
                {"speed", settings.speed},
                {"skills", Written::array()},
                {"events", Written::array()},
                {"interrupts", Written::array()}};
  for (const auto& performed : model.performed) {
    if (std::ranges::find(elsewhere, performed.skill) != elsewhere.end()) continue;
    Written skill{{"name", performed.skill}, {"results", Written::array()}};
    for (const auto& result : performed.results)
      skill["results"].push_back({{"name", resultName(result)}, {"status", result.status}});
    hello["skills"].push_back(std::move(skill));
  }
  for (const auto& signal : model.signals)
    hello[signal.interrupts ? "interrupts" : "events"].push_back(signal.name);
  if (!settings.settings.empty()) hello["settings"] = Written::parse(settings.settings);
  return lineOf(hello);
}

std::string startMessage(const Executable& executable, const Start& start, Nanoseconds date) {
  Written message{{"type", "start"},
                  {"run", start.run},
                  {"skill", executable.model.performed[start.action].skill},
                  {"time", static_cast<double>(date) / static_cast<double>(kSecond)},
                  {"arguments", argumentsOf(start)}};
  if (start.call) message["command"] = start.call->command;
  return lineOf(message);
}

nlohmann::ordered_json argumentsOf(const Start& start) {
  auto list = Written::array();
  if (!start.call) return list;
  for (const auto& argument : start.call->arguments) list.push_back(valueOf(argument));
  return list;
}

std::string stopMessage(RunNumber run) { return lineOf({{"type", "stop"}, {"run", run}}); }
std::string abandonMessage(RunNumber run) { return lineOf({{"type", "abandon"}, {"run", run}}); }
std::string endMessage() { return lineOf({{"type", "end"}}); }

std::expected<Message, std::string> readMessage(std::string_view line) {
  const auto json = parsedText(line);
  if (json.is_discarded()) return std::unexpected("it is not JSON");
  try {
    return messageOf(json);
  } catch (const Wrong& wrong) {
    return std::unexpected(wrong.why);
  }
}

} // namespace proskill::runtime
