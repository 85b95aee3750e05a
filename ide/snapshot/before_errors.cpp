#include "ide/snapshot/before_errors.h"

#include <string_view>

namespace proskill::ide {

namespace {

using Skill = analysis::Definition<syntax::Skill>;

std::string_view textOf(const analysis::Program& program, const Skill& skill) {
  const std::string_view text = program.files[skill.file].document.text();
  const auto range = skill.form->range;
  return text.substr(range.begin, range.end - range.begin);
}

const std::filesystem::path& pathOf(const analysis::Program& program, const Skill& skill) {
  return program.files[skill.file].path;
}

} // namespace

std::optional<syntax::Offset> SkillBeforeErrors::now(syntax::Offset then) const {
  const auto at = then - range.begin;
  if (at == 0) return std::nullopt;
  const auto around = edit.moved({at - 1, at + 1});
  if (!around || around->end - around->begin != 2) return std::nullopt; // text was inserted there
  return begin + around->begin + 1;
}

std::vector<SkillBeforeErrors> skillsBeforeErrors(const View& view, syntax::Range range) {
  std::vector<SkillBeforeErrors> result;
  const auto last = view.owner->beforeErrors();
  if (!last) return result;
  const auto& program = view.program();
  for (const auto& skill : program.skills.all) {
    if (skill.file != view.file || !skill.form->range.touches(range)) continue;
    const auto* then = last->program.skills.find(skill.name());
    if (!then || pathOf(last->program, *then) != pathOf(program, skill)) continue;
    result.push_back({{last, then->file},
                      then->form->range,
                      skill.form->range.begin,
                      syntax::replacementOf(textOf(last->program, *then), textOf(program, skill))});
  }
  return result;
}

} // namespace proskill::ide
