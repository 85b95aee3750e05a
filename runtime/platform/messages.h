#pragma once

#include "runtime/platform/platform.h"

#include <expected>
#include <string>
#include <string_view>

/// The protocol between the executor and a program that performs the actions: JSON objects, one a
/// line. docs/platforms.md and docs/platform-protocol.schema.json describe it.
namespace proskill::runtime {

inline constexpr int kProtocol = 1;

// What the executor says; each is a line with its end.

/// \param speed of the clock: 1 in real time
[[nodiscard]] std::string helloMessage(const Executable& executable, double speed);
[[nodiscard]] std::string startMessage(const Executable& executable, const Start& start,
                                       Nanoseconds date);
[[nodiscard]] std::string stopMessage(RunNumber run);
[[nodiscard]] std::string abandonMessage(RunNumber run);
[[nodiscard]] std::string endMessage();

/// What the program says.
struct Message {
  enum class Kind : std::uint8_t { Ready, Result, Stopped, Failed, Event, Interrupt, Log };
  Kind kind = Kind::Log;
  RunNumber run = 0; ///< 0 in a `Failed` of the program as a whole
  /// Result: of the result; Event; Interrupt: of the skill; Failed: of the skill that it is about,
  /// or empty
  std::string name;
  std::string text;          ///< Failed, Log
  std::int64_t protocol = 0; ///< Ready
};

/// What is wrong with the line is in words.
[[nodiscard]] std::expected<Message, std::string> readMessage(std::string_view line);

/// What the protocol calls a result: its tag, or its status where it has none.
[[nodiscard]] const std::string& resultName(const codegen::Performed::Result& result);

} // namespace proskill::runtime
