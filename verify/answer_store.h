#pragma once

#include "verify/explore/search.h"
#include "verify/verify.h"

#include <map>
#include <optional>
#include <utility>

namespace proskill::verify {

/// The stored answer to a question about a model.
struct KnownAnswer {
  bool holds = false;
  /// If the property is violated: a run of the system without reductions. `Evidence::monitor` is
  /// not used.
  Evidence evidence;
};

/// Stored answers to questions about one model; they outlive a verification. The caller guarantees
/// that a store is used only with its model and with the build of the engine that filled it. A
/// stored violation is replayed before it is used; if the replay fails, the question is explored.
class AnswerStore {
public:
  AnswerStore() = default;
  virtual ~AnswerStore() = default;
  AnswerStore(const AnswerStore&) = delete;
  AnswerStore& operator=(const AnswerStore&) = delete;

  [[nodiscard]] virtual std::optional<KnownAnswer> find(const Question& question) = 0;
  virtual void keep(const Question& question, const KnownAnswer& answer) = 0;
};

/// Answers that last as long as the process.
class AnswersInMemory : public AnswerStore {
public:
  [[nodiscard]] std::optional<KnownAnswer> find(const Question& question) override {
    const auto found = answers.find({question.property, question.fair});
    return found == answers.end() ? std::nullopt : std::optional(found->second);
  }
  void keep(const Question& question, const KnownAnswer& answer) override {
    answers[{question.property, question.fair}] = answer;
  }

private:
  std::map<std::pair<std::size_t, bool>, KnownAnswer> answers;
};

} // namespace proskill::verify
