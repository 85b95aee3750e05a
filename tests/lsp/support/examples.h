#pragma once

#include "syntax/text/source.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace proskill::test {

/// Texts by their names.
using Files = std::map<std::string, std::string>;

[[nodiscard]] std::string contents(const std::filesystem::path& path);

/// The names of the directories in examples/ that have programs in ProSkill.
[[nodiscard]] std::vector<std::string> examples();

/// The programs of one of them.
[[nodiscard]] Files example(const std::string& name);

/// Where words begin and end, and behind parentheses: between two of these answers hardly differ.
/// With `all`, wherever a character begins.
[[nodiscard]] std::vector<syntax::Offset> placesIn(const std::string& text, bool all);

} // namespace proskill::test
