#pragma once

#include "analysis/names/index.h"
#include "analysis/program/program.h"
#include "bridge/bt/emit/exits.h"

namespace proskill::bridge::bt {

/// What is repeated a number of times, until a statement of it leaves the loop. It is written as
/// `Repeat` or `RetryUntilSuccessful`, or, if something is done between two rounds, as Nav2's
/// `RecoveryNode`.
struct Counted {
  std::vector<Step> round;
  std::int64_t times = 0;               ///< of the rounds, or of the recoveries
  std::vector<Step> recovery{};         ///< between two rounds
  const syntax::Block* spent = nullptr; ///< what follows the last round; null: the next statement
};

/// Finds loops that count their rounds by a variable which nothing else reads or sets.
class CountedLoops {
public:
  explicit CountedLoops(const analysis::Program& program);

  /// The steps of a block, of which each such loop is one.
  [[nodiscard]] std::vector<Step> grouped(std::vector<Step> steps) const;

private:
  /// The loop that begins with a step, and the number of its steps; nothing if there is none.
  [[nodiscard]] std::optional<Counted> loopAtBegin(Steps steps, std::size_t& length) const;
  [[nodiscard]] std::optional<Counted> repetition(Steps steps, std::size_t count,
                                                  std::string_view counter) const;
  [[nodiscard]] std::optional<Counted> recovery(Steps steps, std::size_t count,
                                                std::string_view counter) const;
  [[nodiscard]] std::optional<Counted> whileLoop(const Step& step, std::string_view counter) const;
  /// The variable that a step sets to 0, if nothing but a loop uses it.
  [[nodiscard]] std::string_view counterOf(const Step& step) const;
  [[nodiscard]] bool canHold(std::string_view counter, std::int64_t number) const;

  const analysis::Program& program;
  analysis::Index index;
};

} // namespace proskill::bridge::bt
