#pragma once

#include "runtime/platform/json.h"
#include "runtime/platform/platform.h"
#include "runtime/platform/process.h"

#include <expected>
#include <string>
#include <string_view>

/// Protocol between the executor and a program that performs the actions: JSON objects, one per
/// line. See docs/platforms.md and docs/platform-protocol.schema.json.
namespace proskill::runtime {

inline constexpr int kProtocol = 1;

// Messages of the executor, each with its line end.

[[nodiscard]] std::string helloMessage(const Executable& executable,
                                       const ProcessSettings& settings);
[[nodiscard]] std::string startMessage(const Executable& executable, const Start& start,
                                       Nanoseconds date);
/// The arguments of a started action, as a list. Those that the model does not contain are null.
[[nodiscard]] nlohmann::ordered_json argumentsOf(const Start& start);
[[nodiscard]] std::string stopMessage(RunNumber run);
[[nodiscard]] std::string abandonMessage(RunNumber run);
[[nodiscard]] std::string endMessage();

/// Message of the program.
struct Message {
  enum class Kind : std::uint8_t { Ready, Result, Stopped, Failed, Event, Interrupt, Log };
  Kind kind = Kind::Log;
  RunNumber run = 0; ///< 0 if `Failed` concerns the whole program
  /// Result: its name; Event; Interrupt: the skill; Failed: the skill it concerns, or empty
  std::string name;
  std::string text;          ///< Failed, Log
  std::int64_t protocol = 0; ///< Ready
};

/// \return an error message if the line is invalid
[[nodiscard]] std::expected<Message, std::string> readMessage(std::string_view line);

/// The protocol's name of a result: its tag, or its status if it has no tag.
[[nodiscard]] const std::string& resultName(const codegen::Performed::Result& result);

} // namespace proskill::runtime
