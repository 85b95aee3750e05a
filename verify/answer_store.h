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
  /// If the property is violated, or if a run shows the time that was asked for: a run of the
  /// system without reductions. `Evidence::monitor` is not used.
  Evidence evidence;
  std::optional<Duration> duration{}; ///< if the question asks for a time
};

/// Stored answers to questions about one model, and about parts of any model; they outlive a
/// verification. The caller guarantees that a store is used only with its model and with the build
/// of the engine that filled it. A stored violation is replayed before it is used; if the replay
/// fails, the question is explored.
class AnswerStore {
public:
  AnswerStore() = default;
  virtual ~AnswerStore() = default;
  AnswerStore(const AnswerStore&) = delete;
  AnswerStore& operator=(const AnswerStore&) = delete;

  [[nodiscard]] virtual std::optional<KnownAnswer> find(const Question& question) = 0;
  virtual void keep(const Question& question, const KnownAnswer& answer) = 0;

  /// Receives a name for each transition of the model. Called before what follows.
  virtual void begin(const std::vector<std::string>& /*stepNames*/) {}
  /// A run that violated the property in another version of the model, in this version's numbers.
  /// It proves nothing until it has been replayed.
  [[nodiscard]] virtual std::optional<Evidence> earlier(const Question& /*question*/) {
    return std::nullopt;
  }
  /// Whether a goal is known to be never reached in a part, which any model may contain.
  /// \param text everything on which that depends; see PartText
  [[nodiscard]] virtual bool isNeverIn(const std::string& /*text*/) { return false; }
  virtual void keepNeverIn(const std::string& /*text*/) {}
};

/// Answers that last as long as the process.
class AnswersInMemory : public AnswerStore {
public:
  [[nodiscard]] std::optional<KnownAnswer> find(const Question& question) override {
    const auto found = answers.find(question);
    return found == answers.end() ? std::nullopt : std::optional(found->second);
  }
  void keep(const Question& question, const KnownAnswer& answer) override {
    answers[question] = answer;
  }

private:
  std::map<Question, KnownAnswer> answers;
};

} // namespace proskill::verify
