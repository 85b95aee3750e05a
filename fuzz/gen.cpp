#include "bridge/gen/import.h"
#include "fuzz/one_text.h"
#include "fuzz/targets.h"

namespace proskill::fuzz {

void gen(std::string_view bytes) {
  const auto imported = bridge::gen::importComponents(OneText(bytes), "robot.gen", {}, {});
  if (!imported) return errorsHavePlaces(imported.error());
  isProgram(imported->text);
}

} // namespace proskill::fuzz
