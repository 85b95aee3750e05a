#pragma once

#include "ide/snapshot/include_graph.h"
#include "lsp/verification/verified.h"
#include "worker/run_worker.h"

#include <functional>
#include <mutex>
#include <set>

namespace proskill::lsp {

enum class VerificationState : std::uint8_t { Waiting, Checking, Done, Errors, Failed, Off };
/// As `proskill/verdicts` has it.
[[nodiscard]] std::string_view nameOf(VerificationState state);

/// The verdicts of a program, and the state of its verification.
struct ProgramState {
  std::shared_ptr<const ide::AnalysedProgram> program; ///< the last one requested
  std::shared_ptr<const Verified> verified;            ///< null: not verified yet
  VerificationState state = VerificationState::Waiting;
  bool stale = false; ///< `verified` is for older texts
  std::string message;
  std::optional<worker::WorkerProgress> progress; ///< during verification
};

/// The latest verdicts of each program, by path of its root. Thread-safe. Every change is reported,
/// in order.
class VerdictStore {
public:
  using Told = std::function<void(const ProgramState& state)>;

  /// \param onChange called for every change, by one thread at a time
  explicit VerdictStore(Told onChange) : tell(std::move(onChange)) {}

  /// The verdicts that features may show.
  [[nodiscard]] std::shared_ptr<const ide::Verdicts> verdicts() const;
  [[nodiscard]] std::optional<ProgramState> of(const std::filesystem::path& root) const;

  /// These functions change the state of a program. Its verdicts are kept; they become stale if
  /// they are not for exactly these texts.
  void set(const std::shared_ptr<const ide::AnalysedProgram>& program, VerificationState state,
           std::string message = {});
  void setProgress(const std::shared_ptr<const ide::AnalysedProgram>& program,
                   const worker::WorkerProgress& progress);
  /// Stores partial results while verification continues.
  void setDecided(const std::shared_ptr<const ide::AnalysedProgram>& program, Verified soFar,
                  const ide::OpenTexts& open);
  /// \param open the current texts, which may have changed during verification
  void setVerified(const std::shared_ptr<const ide::AnalysedProgram>& program, Verified verified,
                   const ide::OpenTexts& open);

  /// Adds durations to the verdicts on exactly this program.
  void setDurations(const std::shared_ptr<const ide::AnalysedProgram>& program,
                    std::vector<ide::SkillDuration> durations);

  /// Call this after an edit: verdicts become stale if one of their texts has changed, and current
  /// again if the change is undone. Returns whether any verdicts did. Forgets programs without open
  /// texts, and files that belong to other programs now. \param lost open texts that are not known:
  /// verdicts about them are stale
  bool noticeEdit(const ide::OpenTexts& open, const ide::IncludeGraph& includes,
                  const std::set<std::filesystem::path>& lost = {});

private:
  using Entries = std::map<std::filesystem::path, ProgramState>;

  void forget(ProgramState& state, std::string why);
  ProgramState& entry(const std::shared_ptr<const ide::AnalysedProgram>& program);
  void publish();

  Told tell;
  mutable std::mutex mutex;
  Entries entries;
  std::shared_ptr<const ide::Verdicts> published = std::make_shared<const ide::Verdicts>();
};

[[nodiscard]] bool containsAny(const analysis::Program& program,
                               const std::set<std::filesystem::path>& files);

/// Whether an open text of the program has changed.
[[nodiscard]] bool hasChanged(const analysis::Program& program,
                              const std::map<std::filesystem::path, std::int64_t>& wereOpen,
                              const ide::OpenTexts& open);

} // namespace proskill::lsp
