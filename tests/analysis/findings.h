#pragma once

#include "analysis/program/program.h"

#include <map>
#include <string>

namespace proskill::test {

/// Findings of the flow analysis are excluded; tests/flow covers them.
constexpr std::string_view kFirstOfFlow = "PS0500";

/// The findings in a program: code and marked text of each, such as `PS0201 takeof`, separated by
/// commas. A letter after the code marks warnings and hints.
[[nodiscard]] std::string findings(std::string text,
                                   analysis::Extent extent = analysis::Extent::Whole);

/// The same for the files of a program whose root is `main.proskill`; findings in other files begin
/// with the file: `lib.proskill: PS0201 takeof`.
[[nodiscard]] std::string findings(std::map<std::string, std::string> files);

/// The complete findings of a text, without those of the flow analysis.
[[nodiscard]] std::vector<syntax::Diagnostic> diagnose(std::string text);

/// Definitions for programs under test: `battery` (Good Low Critical), `level` (1 to 3), the events
/// `drained` and `charged`, the skills `takeoff` (height, duration) and `survey`, which can be
/// interrupted.
extern const std::string kWorld;

/// `kWorld` and a mission with these statements.
[[nodiscard]] std::string mission(const std::string& statements);

} // namespace proskill::test
