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

/// The directories in examples/ with ProSkill programs.
[[nodiscard]] std::vector<std::string> examples();

/// The programs of one of them.
[[nodiscard]] Files example(const std::string& name);

/// Positions at the beginning and end of words, and after parentheses; answers hardly differ in
/// between. With `all`, at each character.
[[nodiscard]] std::vector<syntax::Offset> placesIn(const std::string& text, bool all);

} // namespace proskill::test
