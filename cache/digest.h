#pragma once

#include <string>
#include <string_view>

namespace proskill::cache {

/// A digest of 128 bits as 32 hexadecimal digits. Different texts have different digests for all
/// practical purposes, but the digest does not protect against deliberate collisions.
[[nodiscard]] std::string digestOf(std::string_view text);

/// The digest of the running executable, since another build may decide or number differently.
/// Empty if it cannot be read.
[[nodiscard]] const std::string& digestOfThisProgram();

} // namespace proskill::cache
