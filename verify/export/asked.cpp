#include "verify/export/asked.h"

#include <utility>

namespace proskill::verify {

std::optional<std::string> whyNotAsked(const Goal& goal) {
  switch (goal.kind) {
  case GoalKind::Events:
  case GoalKind::Condition:
  case GoalKind::Deadlock:
  case GoalKind::Error: return std::nullopt;
  case GoalKind::Run: return "it is about whole runs";
  case GoalKind::Stuck: return "it is about whether time can pass";
  case GoalKind::Lost: return "it is about what remains possible";
  case GoalKind::Longest:
  case GoalKind::Shortest: return "it is about a duration";
  case GoalKind::Unsupported: return goal.reason;
  }
  std::unreachable();
}

} // namespace proskill::verify
