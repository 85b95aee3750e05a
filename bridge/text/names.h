#pragma once

#include "bridge/text/place.h"

#include <map>
#include <set>
#include <string_view>

namespace proskill::bridge {

/// Names of ProSkill, each given once.
class NamePool {
public:
  /// The wish as a name, with a number at its end if it is taken.
  std::string take(std::string_view wish);

private:
  std::set<std::string, std::less<>> taken;
  std::map<std::string, std::size_t, std::less<>> next;
};

/// Any text as a name of ProSkill.
[[nodiscard]] std::string asName(std::string_view text);
/// Any text as a string of ProSkill, with its quotes.
[[nodiscard]] std::string asString(std::string_view text);
/// "1 port", "3 ports".
[[nodiscard]] std::string counted(std::size_t count, std::string_view one, std::string_view many);
/// A place as `FILE:LINE:COLUMN`, the file seen from a folder; as it is if that is empty.
[[nodiscard]] std::string asText(const Place& place, const std::filesystem::path& folder);
/// The line of a comment that says where a part of a program comes from: `from FILE:LINE:COLUMN`
/// and what is there. Tools read these lines: see analysis/program/originals.h.
[[nodiscard]] std::string asComment(const Place& place, std::string_view what,
                                    const std::filesystem::path& folder);

} // namespace proskill::bridge
