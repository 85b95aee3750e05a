#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Writes records of MCAP files, version 0 (https://mcap.dev/spec), without chunks and indexes.
/// Each function appends to a string.
namespace proskill::report::mcap {

/// Start of a file.
void addHead(std::string& to);
/// Schema record in JSON Schema. \param id not 0
void addSchema(std::string& to, std::uint16_t id, std::string_view name, std::string_view schema);
/// Channel record for JSON messages.
void addChannel(std::string& to, std::uint16_t id, std::uint16_t schema, std::string_view topic);
/// \param time in nanoseconds
void addMessage(std::string& to, std::uint16_t channel, std::uint32_t sequence, std::uint64_t time,
                std::string_view json);
/// End of a file.
[[nodiscard]] std::string tail();

} // namespace proskill::report::mcap
