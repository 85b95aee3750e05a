#pragma once

#include <string>
#include <string_view>

namespace proskill::cache {

/// 128 bits as 32 hexadecimal digits. Different texts have different ones for all practical
/// purposes; it is no protection against somebody who looks for two that have the same.
[[nodiscard]] std::string digestOf(std::string_view text);

/// The digest of the program that runs: another build may decide otherwise, or number differently.
/// Empty where it cannot be read.
[[nodiscard]] const std::string& digestOfThisProgram();

} // namespace proskill::cache
