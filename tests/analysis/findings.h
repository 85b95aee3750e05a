#pragma once

#include "analysis/program/program.h"

#include <map>
#include <string>

namespace proskill::test {

/// What the flow of values tells is tested in tests/flow and left out here.
constexpr std::string_view kFirstOfFlow = "PS0500";

/// What is wrong with a program: code and marked text of each finding, `PS0201 takeof`, one after
/// the other, separated by commas. Warnings and hints are told by a letter after the code.
[[nodiscard]] std::string findings(std::string text,
                                   analysis::Extent extent = analysis::Extent::Whole);

/// The same for the files of a program whose root is `main.proskill`; what is not in the root has
/// its file before it: `lib.proskill: PS0201 takeof`.
[[nodiscard]] std::string findings(std::map<std::string, std::string> files);

/// The findings of a text, whole, but for those of the flow of values.
[[nodiscard]] std::vector<syntax::Diagnostic> diagnose(std::string text);

/// What a program that is under test takes for granted: `battery` (Good Low Critical), `level` (1
/// to 3), the events `drained` and `charged`, the skills `takeoff` (height, duration) and `survey`,
/// which can be interrupted.
extern const std::string kWorld;

/// `kWorld` and a mission with these statements.
[[nodiscard]] std::string mission(const std::string& statements);

} // namespace proskill::test
