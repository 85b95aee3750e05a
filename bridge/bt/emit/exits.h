#pragma once

#include "syntax/tree/ast.h"

#include <memory>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace proskill::bridge::bt {

struct Counted;

/// A call with the `if` after it that tests its status, a loop that counts its rounds, or any other
/// statement alone.
struct Step {
  const syntax::Statement* statement = nullptr; ///< of a loop that counts: its first one
  const syntax::Statement* decision = nullptr;
  std::shared_ptr<const Counted> counted{};
};
using Steps = std::span<const Step>;

[[nodiscard]] inline bool isLabel(const Step& step) {
  return !step.counted && step.statement->kind == syntax::StatementKind::Label;
}

[[nodiscard]] std::vector<Step> stepsOf(const syntax::Block& block);

/// The part of a step that follows a call with this status; null: the next statement.
/// \pre the step has a decision
[[nodiscard]] const syntax::Block* afterCall(const Step& step, std::string_view status);

/// Ways out of statements.
using Exits = std::set<std::string, std::less<>>;
inline constexpr auto kNext = "next";
inline constexpr auto kSuccess = "success";
inline constexpr auto kFailure = "failure";
inline constexpr auto kBreak = "break";
[[nodiscard]] std::string exitTo(std::string_view label);

/// All ways out, or those that take no time.
enum class Within : std::uint8_t { AnyTime, NoTime };

[[nodiscard]] Exits exitsOf(const Step& step, Within within = Within::AnyTime);
[[nodiscard]] Exits exitsOf(const syntax::Block& block, Within within = Within::AnyTime);
/// Without jumps to labels among the steps.
[[nodiscard]] Exits exitsOf(Steps steps, Within within = Within::AnyTime);
/// All jumps in the steps, also those to labels among them.
[[nodiscard]] Exits jumpsOf(Steps steps);

} // namespace proskill::bridge::bt
