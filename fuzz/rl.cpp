#include "bridge/rl/emit.h"
#include "bridge/rl/import.h"
#include "fuzz/one_text.h"
#include "fuzz/targets.h"

namespace proskill::fuzz {

void rl(std::string_view bytes) {
  const auto imported = bridge::rl::importSkillsets(OneText(bytes), "robot.rl", {});
  if (!imported) return errorsHavePlaces(imported.error());
  isProgram(imported->text);
  if (imported->text.contains(":body")) return; // RL has no composites
  const auto program = analysis::load(OneText(imported->text), "program.proskill");
  const auto emitted = bridge::rl::emitSkillset(program, "robot");
  expect(emitted.has_value(), "an imported skillset can be written again");
  const auto again = bridge::rl::importSkillsets(OneText(emitted->text), "robot.rl", {});
  expect(again.has_value(), "a skillset that was written can be imported");
}

} // namespace proskill::fuzz
