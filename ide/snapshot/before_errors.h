#pragma once

#include "ide/snapshot/snapshot.h"
#include "syntax/text/change.h"

#include <optional>
#include <vector>

namespace proskill::ide {

/// A skill of a program with errors, in the last version without errors.
struct SkillBeforeErrors {
  View view;                ///< of that version
  syntax::Range range;      ///< of the skill there
  syntax::Offset begin = 0; ///< of the skill in the current text
  /// Turns the former text of the skill into the current one; offsets are relative to its begin.
  syntax::Replacement edit;

  /// Where the text at an offset of that version is now; nothing if the character before or after
  /// the offset has changed.
  [[nodiscard]] std::optional<syntax::Offset> now(syntax::Offset then) const;
};

/// The skills of the file that touch the range and had the same name in that version. Empty for a
/// program without errors.
[[nodiscard]] std::vector<SkillBeforeErrors> skillsBeforeErrors(const View& view,
                                                                syntax::Range range);

} // namespace proskill::ide
