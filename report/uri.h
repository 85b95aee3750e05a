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
/// A `file:` URI of an absolute path, a relative reference (RFC 3986, section 4.2) of another one.
[[nodiscard]] std::string toUriReference(const std::filesystem::path& path);
/// A path for a text that is part of a file, as a cell of a notebook is: its URI is of a scheme of
/// its own and has a fragment (`vscode-notebook-cell:/w/a.ipynb#W0s`). There is no file of that
/// name, but what it includes is looked for beside it. It has neither quotes nor escapes.
[[nodiscard]] std::optional<std::filesystem::path> toCellPath(std::string_view uri);

/// One spelling for each URI: clients write the same file with `%3A` or `:`, and in other ways.
[[nodiscard]] std::string normalised(std::string_view uri);

} // namespace proskill::report
