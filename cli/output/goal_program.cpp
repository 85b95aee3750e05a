#include "cli/output/goal_program.h"

#include "bridge/text/names.h"
#include "disk/disk.h"
#include "report/text/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <unistd.h>

namespace proskill::cli {
namespace {

constexpr auto kFile = "<goal>"; // a program may be called `goal`
constexpr auto kShown = "goal";
constexpr auto kProperty = "goal_of_the_plan";
constexpr std::string_view kBefore = "(defproperty goal_of_the_plan (reachable ";
constexpr std::string_view kAfter = "\n))\n"; // the goal may end in a comment

/// What lies outside of the goal is shown at its next end.
syntax::Range inText(syntax::Range range, std::size_t length) {
  const auto moved = [&](syntax::Offset offset) {
    const auto from = std::max<std::size_t>(offset, kBefore.size()) - kBefore.size();
    return static_cast<syntax::Offset>(std::min(from, length));
  };
  return {moved(range.begin), moved(range.end)};
}

/// The errors of the goal, as of a file with its text alone.
std::vector<syntax::Diagnostic> errorsIn(const analysis::Program& program, std::size_t length) {
  std::vector<syntax::Diagnostic> errors;
  for (auto& found : analysis::check(program)) {
    if (found.severity != syntax::Severity::Error || found.location.file != 0) continue;
    found.location.range = inText(found.location.range, length);
    found.related.clear();
    found.fixes.clear();
    errors.push_back(std::move(found));
  }
  return errors;
}

} // namespace

const syntax::Expr& GoalProgram::goal() const {
  return program.properties.find(kProperty)->node().operands.front();
}

bridge::Errors GoalProgram::inGoal(bridge::Errors errors) {
  for (auto& [place, message] : errors) {
    if (place.file != kFile) continue;
    place.file = kShown;
    if (place.line == 1) place.column -= kBefore.size();
  }
  return errors;
}

std::optional<GoalProgram> loadGoal(const std::string& root, const std::string& goal,
                                    ColourChoice colour) {
  const disk::DiskFileSystem disk;
  const auto text =
      fmt::format("{}{}{}(include {})\n", kBefore, goal, kAfter, bridge::asString(root));
  auto program = analysis::load(disk, kFile, syntax::Document::parse(text));
  const auto errors = errorsIn(program, goal.size());
  if (errors.empty()) return GoalProgram{std::move(program)};
  analysis::Program alone;
  alone.files.push_back({kShown, syntax::Document::parse(goal)});
  render(std::cerr, alone, errors, report::Paint{wantsColour(colour, STDERR_FILENO)});
  return std::nullopt;
}

} // namespace proskill::cli
