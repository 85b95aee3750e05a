#include "bridge/bt/emit/emit.h"
#include "bridge/bt/import.h"
#include "fuzz/one_text.h"
#include "fuzz/targets.h"

namespace proskill::fuzz {

void bt(std::string_view bytes) {
  const auto imported = bridge::bt::importTree(OneText(bytes), "tree.xml", bridge::Leaves(), {});
  if (!imported) return errorsHavePlaces(imported.error());
  isProgram(imported->text);
  const auto program = analysis::load(OneText(imported->text), "program.proskill");
  const auto emitted = bridge::bt::emitTree(program, {});
  if (!emitted) return errorsHavePlaces(emitted.error());
  const auto leaves = bridge::Leaves::read(emitted->leaves);
  expect(leaves.has_value(), "a file of leaves that was written can be read");
  const auto again = bridge::bt::importTree(OneText(emitted->tree.text), "tree.xml", *leaves, {});
  expect(again.has_value(), "a tree that was written can be imported");
}

} // namespace proskill::fuzz
