#pragma once

#include "lsp/protocol/client.h"
#include "lsp/protocol/registry.h"
#include "lsp/verification/verdict_store.h"
#include "lsp/verification/verification_settings.h"

#include <condition_variable>
#include <list>
#include <set>
#include <thread>

namespace proskill::lsp {

/// Verifies programs for the server: live after a pause, and on request. Separate processes do the
/// work (`runWorker`); the destructor ends all of them.
class Verification {
public:
  struct Outside {
    std::vector<std::string> worker;            ///< the command that runs `runVerifyWorker`
    std::function<void(std::string_view)> send; ///< sends the body of a message to the client
    /// Verdicts have changed: diagnostics and lenses must be updated.
    std::function<void()> changed;
    /// Durations were measured: lenses and hints must be updated.
    std::function<void()> measured;
    std::function<void(std::string_view)> log;
  };

  explicit Verification(Outside outside);
  ~Verification();
  Verification(const Verification&) = delete;
  Verification& operator=(const Verification&) = delete;

  /// Call this once the client is known. Nothing is verified before.
  void start(const ClientFeatures& client, VerificationSettings settings);
  /// Applies the `verify` section of a workspace's settings.
  void configure(const Json& section);
  using Paths = std::set<std::filesystem::path>;

  /// Call this after every edit. \param lost open texts that are not known, and so not in the
  /// snapshot. \param inView the text that was edited or opened, if any
  void textsChanged(std::shared_ptr<const ide::Snapshot> snapshot, Paths lost,
                    const std::optional<std::filesystem::path>& inView);
  /// Call this after `textsChanged` if files have changed on the disk: a verification of what they
  /// were is useless.
  void filesChanged(const std::vector<std::filesystem::path>& files);
  /// The text that the user looks at, reported by the client. Lines from 0; the last one is
  /// included.
  struct Lines {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };
  /// \param lines the visible ones, if known
  void setView(const std::filesystem::path& path, std::optional<Lines> lines);

  [[nodiscard]] std::shared_ptr<const ide::Verdicts> verdicts() const { return store.verdicts(); }

  /// `proskill/verify` and `proskill/trace`.
  void addMethods(Registry& registry);

private:
  using Time = std::chrono::steady_clock::time_point;
  using Programs = std::shared_ptr<const ide::AnalysedProgram>;

  void live(const std::stop_token& stop);
  void checkTexts(const ide::Snapshot& snapshot, const std::vector<std::filesystem::path>& texts,
                  const VerificationSettings& settings, const rpc::Cancellation& cancellation);
  void checkLive(const ide::Snapshot& snapshot, const std::filesystem::path& path,
                 const VerificationSettings& settings, const rpc::Cancellation& cancellation);
  /// Whether the verdicts on a program are known.
  enum class Checked : std::uint8_t { No, Before, Now };
  Checked checkProgram(const Programs& program, const ide::Snapshot& snapshot,
                       const VerificationSettings& settings, const rpc::Cancellation& cancellation);
  std::expected<Verified, worker::WorkerFailure>
  run(const Programs& program, const ide::OpenTexts& open, const worker::WorkerJob& job,
      const LimitSettings& limits, const rpc::Cancellation& cancellation,
      const std::function<void(const worker::WorkerProgress&)>& progress);
  using RunAll = std::function<std::expected<Verified, worker::WorkerFailure>()>;
  /// Verifies what is in view of a large program, then the whole by `all`, and meanwhile what is
  /// scrolled into view.
  std::expected<Verified, worker::WorkerFailure> inViewFirst(const Programs& program,
                                                             const ide::Snapshot& snapshot,
                                                             const VerificationSettings& settings,
                                                             const rpc::Cancellation& cancellation,
                                                             const RunAll& all);
  void checkInView(const Programs& program, const ide::Snapshot& snapshot, double seconds,
                   const VerificationSettings& settings, const rpc::Cancellation& cancellation,
                   const std::stop_token& stop);
  [[nodiscard]] std::pair<std::vector<std::string>, rpc::Cancellation>
  takeInView(const analysis::Program& program, const rpc::Cancellation& cancellation,
             const std::stop_token& stop);
  [[nodiscard]] std::vector<std::string> namesInView(const analysis::Program& program) const;
  void forgetInView(const std::vector<std::string>& names);
  void recordInView(const Programs& program, Verified found, const ide::OpenTexts& open);
  void noticeScrolling();
  [[nodiscard]] bool hasScrolled(const std::stop_token& stop);
  void record(const Programs& program, Verified verified);
  void measure(const Programs& program, const ide::OpenTexts& open,
               const VerificationSettings& settings, const rpc::Cancellation& cancellation);
  void cancelRunning();
  void beginWork(const Programs& program, const ide::OpenTexts& open);
  void endWork();
  void noticeEdit(const ide::Snapshot& now, const Paths& lostNow);
  [[nodiscard]] bool hasLostText(const ide::AnalysedProgram& program);
  void announce(const ProgramState& state);
  void log(std::string_view line) const {
    if (outside.log) outside.log(line);
  }

  [[nodiscard]] Answer verifyRequested(const Request& request);
  [[nodiscard]] Answer traceRequested(const Request& request);
  std::expected<std::shared_ptr<const std::string>, worker::WorkerFailure>
  findTrace(const Verified& known, const std::string& name, const Request& request);
  [[nodiscard]] VerificationSettings settingsNow() const;
  void view(const std::filesystem::path& path);
  [[nodiscard]] std::vector<std::filesystem::path> textsByView();
  [[nodiscard]] bool isInBackground();

  Outside outside;
  VerdictStore store;
  mutable std::mutex mutex;
  std::condition_variable wake;
  VerificationSettings settings;
  syntax::Encoding encoding = syntax::Encoding::Utf16;
  VerdictNews verdictNews = VerdictNews::None; ///< what the client is sent
  bool started = false;
  std::shared_ptr<const ide::Snapshot> snapshot;
  Paths lost;                                     ///< open texts that are not known
  std::map<std::filesystem::path, Lines> visible; ///< visible lines of the texts in view
  /// Open texts that the user has viewed, the last one first.
  std::list<std::filesystem::path> viewed;
  bool edited = false;                ///< since the last call of `noticeEdit`
  std::optional<Time> due;            ///< of live verification
  std::optional<Time::duration> took; ///< by the last live verification, without durations
  rpc::Cancellation running;          ///< of live verification
  rpc::Cancellation runningInView;    ///< of the part of it that is in view
  std::set<std::string> askedInView;  ///< definitions that were in view during it
  std::set<std::string> takenInView;  ///< those of them that are being verified
  bool scrolled = false;              ///< to others, which are not being verified yet
  std::condition_variable_any scrolling;
  bool inBackground = false; ///< it is about a text that is not in view
  Programs runningOn;
  /// Roots of programs whose durations are not known yet. Only live verification uses it.
  std::set<std::filesystem::path> unmeasured;
  /// By root: the verdicts that were sent to the client. Only calls of the store use it.
  std::map<std::filesystem::path, std::shared_ptr<const ide::ProgramVerdicts>> announced;
  std::map<std::filesystem::path, std::int64_t> runningVersions;
  std::jthread thread; ///< the last member, since it uses all of the above
};

} // namespace proskill::lsp
