#pragma once

#include "lsp/protocol/client.h"
#include "lsp/protocol/registry.h"
#include "lsp/verification/verdict_store.h"
#include "lsp/verification/verification_settings.h"

#include <condition_variable>
#include <list>
#include <thread>

namespace proskill::lsp {

/// Verifies programs for the server: live after an idle moment, and on request. The work is done by
/// processes of their own (`runWorker`); all of them have ended when this is gone.
class Verification {
public:
  struct Outside {
    std::vector<std::string> worker;            ///< the command that runs `runVerifyWorker`
    std::function<void(std::string_view)> send; ///< a message's body to the client
    std::function<void()> changed; ///< verdicts came or went: diagnostics, lenses, hints are new
    std::function<void(std::string_view)> log;
  };

  explicit Verification(Outside outside);
  ~Verification();
  Verification(const Verification&) = delete;
  Verification& operator=(const Verification&) = delete;

  /// Once the client is known. Nothing is verified before.
  void start(const ClientFeatures& client, VerificationSettings settings);
  /// Settings of a workspace, the `verify` section alone.
  void configure(const Json& section);
  /// After every edit. \param inView the text that was edited or opened, if one was
  void textsChanged(std::shared_ptr<const ide::Snapshot> snapshot,
                    const std::optional<std::filesystem::path>& inView);
  /// The client says which text a user looks at.
  /// Lines from 0, the last one within.
  struct Lines {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  /// \param lines of it that can be seen, where that is known
  void setView(const std::filesystem::path& path, std::optional<Lines> lines);

  [[nodiscard]] std::shared_ptr<const ide::Verdicts> verdicts() const { return board.verdicts(); }

  /// `proskill/verify` and `proskill/trace`.
  void addMethods(Registry& registry);

private:
  using Time = std::chrono::steady_clock::time_point;
  using Programs = std::shared_ptr<const ide::AnalysedProgram>;

  void live(const std::stop_token& stop);
  void checkLive(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                 const VerificationSettings& settings, const rpc::Cancellation& cancellation);
  void checkProgram(const Programs& program, const ide::Snapshot& snapshot,
                    const VerificationSettings& settings, const rpc::Cancellation& cancellation);
  std::expected<Verified, worker::WorkerFailure>
  run(const Programs& program, const ide::OpenTexts& open, const worker::WorkerJob& job,
      const LimitSettings& limits, const rpc::Cancellation& cancellation,
      const std::function<void(const worker::WorkerProgress&)>& progress);
  void checkInView(const Programs& program, const ide::Snapshot& snapshot,
                   const VerificationSettings& settings, const rpc::Cancellation& cancellation);
  void record(const Programs& program, Verified verified);
  void noticeEdit(const ide::Snapshot& now);
  void announce(const ProgramState& state);
  void log(std::string_view line) const {
    if (outside.log) outside.log(line);
  }

  [[nodiscard]] Answer verifyRequested(const Request& request);
  [[nodiscard]] Answer traceRequested(const Request& request) const;
  [[nodiscard]] VerificationSettings settingsNow() const;
  void view(const std::filesystem::path& path);
  [[nodiscard]] std::optional<std::filesystem::path> inView();

  Outside outside;
  VerdictStore board;
  mutable std::mutex mutex;
  std::condition_variable wake;
  VerificationSettings settings;
  syntax::Encoding encoding = syntax::Encoding::Utf16;
  bool verdictChanges = false; ///< the client puts them together
  bool started = false;
  std::shared_ptr<const ide::Snapshot> snapshot;
  std::map<std::filesystem::path, Lines> visible; ///< of texts in view, what can be seen
  std::list<std::filesystem::path> viewed; ///< open texts that a user looked at, the last one first
  bool edited = false;                     ///< since `noticeEdit`
  std::optional<Time> due;                 ///< of live verification
  rpc::Cancellation running;               ///< of live verification
  Programs runningOn;
  /// By the root: the verdicts that the client was told. Of the board's calls alone.
  std::map<std::filesystem::path, std::shared_ptr<const ide::ProgramVerdicts>> announced;
  std::map<std::filesystem::path, std::int64_t> runningVersions;
  std::jthread thread; ///< last: it uses all of the above
};

} // namespace proskill::lsp
