#include "bridge/bt/import.h"
#include "fuzz/one_text.h"
#include "fuzz/targets.h"

namespace proskill::fuzz {

/// A tree with leaves that the file may speak about.
constexpr std::string_view kTree = R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
<ReactiveSequence><IsNear/><Move name="goes"/></ReactiveSequence>
</BehaviorTree></root>)";

void leaves(std::string_view bytes) {
  const auto read = bridge::Leaves::read(bytes);
  if (!read) return errorsHavePlaces(read.error());
  const auto imported = bridge::bt::importTree(OneText(kTree), "tree.xml", *read, {});
  if (!imported) return errorsHavePlaces(imported.error());
  isProgram(imported->text);
}

} // namespace proskill::fuzz
