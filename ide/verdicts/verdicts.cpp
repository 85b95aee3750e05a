#include "ide/verdicts/verdicts.h"

#include <algorithm>

namespace proskill::ide {

namespace {

/// Compares texts, not parse results: undoing an edit restores the same text.
bool isSame(const analysis::File& before, const analysis::File& now) {
  return before.path == now.path &&
         (before.document.isSameAs(now.document) || before.document.text() == now.document.text());
}

} // namespace

bool areCurrent(const ProgramVerdicts& verdicts, const analysis::Program& now) {
  return std::ranges::equal(verdicts.program->program.files, now.files, isSame);
}

std::shared_ptr<const ProgramVerdicts> currentVerdicts(const Verdicts& all, const View& view) {
  auto found = all.find(view.program().files.front().path);
  if (found == all.end() || !areCurrent(*found->second, view.program())) return nullptr;
  return found->second;
}

const SkillDuration* durationOf(const ProgramVerdicts& verdicts, std::string_view skill) {
  const auto found = std::ranges::find(verdicts.durations, skill, &SkillDuration::skill);
  return found == verdicts.durations.end() ? nullptr : &*found;
}

bool mayTimeStop(const ProgramVerdicts& verdicts) {
  return std::ranges::any_of(verdicts.properties, [](const PropertyVerdict& property) {
    return property.kind == "time_progress" && property.bad();
  });
}

std::vector<const PropertyVerdict*> verdictsOn(const ProgramVerdicts& verdicts,
                                               std::string_view subject) {
  std::vector<const PropertyVerdict*> result;
  for (const auto& property : verdicts.properties)
    if (property.subject == subject) result.push_back(&property);
  return result;
}

} // namespace proskill::ide
