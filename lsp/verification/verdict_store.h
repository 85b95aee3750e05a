#pragma once

#include "ide/snapshot/include_graph.h"
#include "lsp/verification/verified.h"
#include "worker/run_worker.h"

#include <functional>
#include <mutex>
#include <set>

namespace proskill::lsp {

enum class VerificationState : std::uint8_t { Waiting, Checking, Done, Errors, Failed, Off };

/// The verdicts of a program, and the state of its verification.
struct ProgramState {
  std::shared_ptr<const ide::AnalysedProgram> program; ///< the last one requested
  std::shared_ptr<const Verified> verified;            ///< null: never yet
  VerificationState state = VerificationState::Waiting;
  bool stale = false; ///< `verified` is for older texts
  std::string message;
  std::optional<worker::WorkerProgress> progress; ///< while it is checked
};

/// The last verdicts of each program, by the path of its root. Any thread may use it; every change
/// is reported, in order.
class VerdictStore {
public:
  using Told = std::function<void(const ProgramState& state)>;

  /// \param tell of every change; never called by two threads at once
  explicit VerdictStore(Told tell) : tell(std::move(tell)) {}

  /// What features may show.
  [[nodiscard]] std::shared_ptr<const ide::Verdicts> verdicts() const;
  [[nodiscard]] std::optional<ProgramState> of(const std::filesystem::path& root) const;

  /// These change the state of a program; what was verified stays, and is stale where it is not for
  /// just these texts.
  void set(const std::shared_ptr<const ide::AnalysedProgram>& program, VerificationState state,
           std::string message = {});
  void setProgress(const std::shared_ptr<const ide::AnalysedProgram>& program,
                   const worker::WorkerProgress& progress);
  /// What is decided so far, while the rest is still being verified.
  void setDecided(const std::shared_ptr<const ide::AnalysedProgram>& program, Verified soFar,
                  const ide::OpenTexts& open);
  /// \param open the texts as they are now: they may have changed while it was verified
  void setVerified(const std::shared_ptr<const ide::AnalysedProgram>& program, Verified verified,
                   const ide::OpenTexts& open);

  /// After an edit: verdicts become stale where a text of theirs has another content, and current
  /// again where it is undone. Says whether any did. Programs of which no text is open are
  /// forgotten, and files that are parts of other programs now.
  bool noticeEdit(const ide::OpenTexts& open, const ide::IncludeGraph& includes);

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

/// Whether an open text of the program has changed.
[[nodiscard]] bool hasChanged(const analysis::Program& program,
                              const std::map<std::filesystem::path, std::int64_t>& wereOpen,
                              const ide::OpenTexts& open);

} // namespace proskill::lsp
