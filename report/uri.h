#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace proskill::report {

/// The path of a `file:` URI, decoded; nothing for other schemes (`untitled:`, `git:`).
/// RFC 3986, RFC 8089.
[[nodiscard]] std::optional<std::filesystem::path> toPath(std::string_view uri);
[[nodiscard]] std::string toUri(const std::filesystem::path& path);
/// The `file:` URI of an absolute path; for other paths a relative reference (RFC 3986, section
/// 4.2).
[[nodiscard]] std::string toUriReference(const std::filesystem::path& path);
/// The path of a text that is part of a file, such as a cell of a notebook. Its URI has a scheme of
/// its own and a fragment (`vscode-notebook-cell:/w/a.ipynb#W0s`). No file has this name, but
/// includes are resolved next to it. It contains neither quotes nor escapes.
[[nodiscard]] std::optional<std::filesystem::path> toCellPath(std::string_view uri);

/// A canonical spelling of a URI: clients write the same file with `%3A` or `:`, and in other ways.
[[nodiscard]] std::string normalised(std::string_view uri);

} // namespace proskill::report
