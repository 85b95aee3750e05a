#pragma once

#include "verify/explore/search.h"
#include "verify/verify.h"

#include <optional>

namespace proskill::verify {

/// What was decided about a question to a model before.
struct KnownAnswer {
  bool holds = false;
  /// Where it does not hold: steps of the system with nothing reduced. Its monitor is not looked
  /// at.
  Evidence evidence;
};

/// Answers to questions to one model, which outlive a verification. Who makes one sees to it that
/// it is asked of that model alone, by that build of the engine. A violation is replayed before it
/// is believed: where it does not stand, the question is explored.
class AnswerStore {
public:
  AnswerStore() = default;
  virtual ~AnswerStore() = default;
  AnswerStore(const AnswerStore&) = delete;
  AnswerStore& operator=(const AnswerStore&) = delete;

  [[nodiscard]] virtual std::optional<KnownAnswer> find(const Question& question) = 0;
  virtual void keep(const Question& question, const KnownAnswer& answer) = 0;
};

} // namespace proskill::verify
