#pragma once

#include "bridge/rl/read/skillset.h"
#include "bridge/text/token_reader.h"

/// Composites of skills (`.rlc`), as they are written.
namespace proskill::bridge::rl {

enum class TermKind : std::uint8_t {
  Name,
  Call,  ///< of a composite or a declared method
  Skill, ///< of a skillset or a robot
  Ros,
  Sequence,
  Choice,
  Parallel,
  Race,
  And,
  Or,
  If ///< condition, branch, condition, branch, …, the last branch
};

struct Term {
  TermKind kind = TermKind::Name;
  Word owner; ///< of a skill: its skillset or robot; of ROS: the topic
  Word name;  ///< of ROS: `publish`, `service` or `action`
  Place place;
  std::vector<Term> parts; ///< of a call: the arguments
};

struct Composite {
  Word name;
  std::vector<Variable> parameters;
  std::optional<Term> body; ///< nothing: a method that is declared only
};

inline constexpr std::size_t kDeepestTerm = 100;

/// Reads what follows `def`, or `dec` and `decl`. Errors are the reader's.
[[nodiscard]] Composite readComposite(TokenReader& reader, bool hasBody);

} // namespace proskill::bridge::rl
