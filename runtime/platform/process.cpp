#include "runtime/platform/process.h"

#include "process/child.h"
#include "runtime/platform/descriptor.h"
#include "runtime/platform/line_buffer.h"
#include "runtime/platform/messages.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <csignal>
#include <deque>

namespace proskill::runtime {

namespace {

using Kind = Message::Kind;

/// A longer line is a fault of the program.
constexpr std::size_t kLongestLine = std::size_t{1} << 20;
/// A program that leaves more bytes unread is considered hung.
constexpr std::size_t kMostUnread = std::size_t{4} << 20;
/// Time that a program has to end after its connection is lost.
constexpr Nanoseconds kLastMoment = kSecond;

enum class State : std::uint8_t {
  Starting, ///< started, but not ready
  Ready,
  Ending,  ///< the connection is lost, and the process is about to end
  Waiting, ///< for the next start
  Gone,    ///< for good
};

class Process final : public Platform {
public:
  Process(const Executable& of, ProcessSettings with)
      : executable(of),
        settings(std::move(with)),
        runs(of.actions.size()),
        restartsLeft(settings.restarts) {
    watch.add(timer.get());
  }
  ~Process() override {
    if (child) child->signal(SIGKILL);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// \return why it could not be started; empty on success
  std::string begin() {
    auto started = process::Child::startGroup(settings.command, settings.directory);
    if (!started)
      return fmt::format("`{}` cannot be started: {}", settings.command.front(), started.error());
    child.emplace(std::move(*started));
    watch.add(child->descriptor());
    lines.clear();
    waitsToSend = false;
    outgoing = helloMessage(executable, settings);
    state = State::Starting;
    setTimer(settings.startup);
    send();
    return "";
  }

  /// Waits until it is ready. \return why it is not; empty on success
  std::string awaitReady(const std::function<bool()>& givenUp) {
    restartsLeft = 0; // a program that fails at first is an error of the user, so it is not
                      // restarted
    while (state == State::Starting || state == State::Ending) {
      if (givenUp()) return "asked to end before " + settings.name + " was ready";
      constexpr int kMilliseconds = 100;
      pollfd all{watch.get(), POLLIN, 0};
      ::poll(&all, 1, kMilliseconds);
      while (proceed()) {
      }
    }
    restartsLeft = settings.restarts;
    if (state == State::Ready) return "";
    const auto last =
        std::ranges::find(reports.rbegin(), reports.rend(), ReportKind::Fault, &Report::kind);
    return last->text;
  }

  /// The skill that it cannot perform, if it named one when it failed.
  [[nodiscard]] const std::string& unsuited() const { return unsuitedSkill; }

  void start(const Start& start, Nanoseconds date) override {
    runs[start.action] = {.number = start.run, .isRunning = true};
    say(startMessage(executable, start, date));
    if (state == State::Gone) failRuns();
  }

  bool stop(std::uint32_t action, RunNumber run, Nanoseconds date) override {
    static_cast<void>(date);
    runs[action].isAsked = true;
    say(stopMessage(run));
    return false;
  }

  void abandon(std::uint32_t action, RunNumber run, Nanoseconds date) override {
    static_cast<void>(date);
    runs[action].isRunning = false;
    say(abandonMessage(run));
  }

  [[nodiscard]] std::optional<Nanoseconds> next() const override {
    // pending reports must not wait for the next message
    return reports.empty() ? std::nullopt : std::optional<Nanoseconds>(0);
  }
  [[nodiscard]] bool mayReport() const override { return state != State::Gone; }
  void addDescriptors(std::vector<int>& all) const override { all.push_back(watch.get()); }

  bool poll(Nanoseconds date, Report& report) override {
    while (reports.empty() && proceed()) {
    }
    if (reports.empty()) return false;
    report = std::move(reports.front());
    reports.pop_front();
    report.date = date;
    return true;
  }

  void close() override {
    isClosing = true;
    if (state == State::Waiting || state == State::Gone) return giveUp();
    say(endMessage());
  }
  [[nodiscard]] bool isClosed() const override { return state == State::Gone; }

private:
  struct Run {
    RunNumber number = 0;
    bool isRunning = false;
    bool isAsked = false; ///< was asked to stop
  };

  /// Processes what was received; returns false if there was nothing.
  bool proceed() {
    if (timer.wentOff()) return onTimer();
    switch (state) {
    case State::Starting:
    case State::Ready: return readLine() || exchange();
    case State::Ending: return endIfOver();
    case State::Waiting:
    case State::Gone: return false;
    }
    return false;
  }

  bool onTimer() {
    switch (state) {
    case State::Starting:
      lose(fmt::format("{} is not ready after {:g} s", settings.name, inSeconds(settings.startup)));
      return true;
    case State::Ending:
      lossReason = settings.name + " has closed its connection, goes on, and is killed";
      child->signal(SIGKILL);
      return true;
    case State::Waiting: {
      const auto why = begin();
      if (!why.empty()) {
        fault(why);
        failRuns();
        giveUp();
      }
      return true;
    }
    case State::Ready:
    case State::Gone: break;
    }
    return true;
  }

  bool readLine() {
    std::string_view line;
    switch (lines.next(line)) {
    case LineBuffer::Next::Nothing: return false;
    case LineBuffer::Next::TooLong:
      fault(fmt::format("the platform sent a line of more than {} bytes; it is ignored",
                        kLongestLine));
      return true;
    case LineBuffer::Next::Line: break;
    }
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) return true;
    const auto message = readMessage(line);
    if (message) {
      obey(*message);
      return true;
    }
    constexpr std::size_t kShown = 60;
    const auto shown = line.substr(0, syntax::characterStart(line, std::min(line.size(), kShown)));
    fault(fmt::format("the platform sent a line that is ignored: {}: `{}{}`", message.error(),
                      syntax::printable(shown), shown.size() < line.size() ? "…" : ""));
    return true;
  }

  /// Sends what the pipe accepts, and receives.
  /// \return false if nothing was received
  bool exchange() {
    const auto done = child->exchange(outgoing, std::chrono::milliseconds(0));
    sent(done.sent);
    lines.add(done.received);
    if (done.ended) lose("");
    return done.ended || !done.received.empty();
  }

  // --- Messages received

  void obey(const Message& message) {
    if (message.kind == Kind::Ready) return onReady(message);
    if (message.kind == Kind::Log) return note(message.text);
    if (message.kind == Kind::Failed && message.run == 0) {
      unsuitedSkill = message.name;
      return lose(settings.isOurs ? message.text : settings.name + " gives up: " + message.text);
    }

    if (state == State::Starting) return fault("the platform sent a message before it was ready");
    if (message.kind == Kind::Event) return signal(message.name, false);
    if (message.kind == Kind::Interrupt) return signal(message.name, true);
    onEnd(message);
  }

  void onReady(const Message& message) {
    if (message.protocol != kProtocol)
      return lose(fmt::format("{} speaks version {} of the protocol, not {}", settings.name,
                              message.protocol, kProtocol));
    if (state != State::Starting) return fault("the platform sent `ready` twice");
    state = State::Ready;
    setTimer(0);
    say(std::exchange(waiting, {}));
  }

  void signal(const std::string& name, bool interrupts) {
    const auto& all = executable.model.signals;
    const auto found = std::ranges::find_if(all, [&](const codegen::Signal& each) {
      return each.name == name && each.interrupts == interrupts;
    });
    if (found == all.end())
      return fault(fmt::format("the platform reports {} `{}`, which is not known",
                               interrupts ? "an interrupt of" : "an event",
                               syntax::printable(name)));
    reports.push_back(
        {.kind = ReportKind::Signal, .signal = static_cast<std::uint32_t>(found - all.begin())});
  }

  void onEnd(const Message& message) {
    const auto found = std::ranges::find(runs, message.run, &Run::number);
    if (found == runs.end() || message.run == 0)
      return fault(fmt::format("the platform refers to run {}, which is not running; it is ignored",
                               message.run));
    const auto action = static_cast<std::uint32_t>(found - runs.begin());
    const bool counts = std::exchange(found->isRunning, false);
    Report report{.kind = ReportKind::Result, .action = action, .run = message.run};
    if (message.kind == Kind::Result) setResult(report, message.name);
    if (message.kind == Kind::Failed) report.text = "its action failed: " + message.text;
    if (message.kind == Kind::Stopped && !found->isAsked)
      report.text = "its action has stopped without being asked to";
    if (!counts) report.text = "ignored a result of a run that has already ended";
    reports.push_back(std::move(report));
  }

  void setResult(Report& report, const std::string& name) const {
    const auto& all = executable.model.performed[report.action].results;
    const auto found = std::ranges::find(all, name, resultName);
    if (found == all.end())
      report.text = fmt::format("its action has no result `{}`", syntax::printable(name));
    else
      report.result = static_cast<std::uint32_t>(found - all.begin());
  }

  // --- The connection

  /// Sends a line; before the program is ready, lines are queued.
  void say(std::string line) {
    if (state == State::Gone || line.empty()) return;
    if (state != State::Ready && !isClosing) {
      waiting += line;
      return;
    }
    outgoing += line;
    send();
  }

  void send() {
    if (!child || (state != State::Starting && state != State::Ready)) return;
    const auto done = child->exchange(outgoing, std::chrono::milliseconds(0));
    sent(done.sent);
    lines.add(done.received);
    if (done.ended) return lose("");
    if (outgoing.size() > kMostUnread) lose(settings.name + " does not read its input");
  }

  void sent(std::size_t bytes) {
    outgoing.erase(0, bytes);
    const bool waits = !outgoing.empty();
    if (waits != waitsToSend)
      watch.change(child->descriptor(), waits ? EPOLLIN | EPOLLOUT : EPOLLIN);
    waitsToSend = waits;
    if (isClosing && !waits) child->endInput();
  }

  /// Handles the loss of the connection. Actions are reported as ended only when the process has
  /// ended.
  /// \param why empty: as the process ended
  void lose(const std::string& why) {
    while (why.empty() && state != State::Ending && readLine()) {
    } // messages that were sent before
    if (state == State::Ending) return;
    lossReason = why;
    watch.remove(child->descriptor());
    watch.add(child->endDescriptor());
    if (!why.empty()) child->signal(SIGKILL);
    state = State::Ending;
    setTimer(kLastMoment);
  }

  bool endIfOver() {
    const auto ending = child->endingIfOver();
    if (!ending) return false;
    child.reset(); // closing removes it from the watch
    setTimer(0);
    if (isClosing && *ending == "it ended with exit code 0") {
      giveUp();
      return true;
    }
    fault(!lossReason.empty() ? lossReason
                              : "the connection to " + settings.name + " is lost: " + *ending);
    const bool isLast = isClosing || restartsLeft == 0;
    if (isLast) giveUp(); // first, so that no further action starts
    failRuns();
    if (isLast) return true;
    --restartsLeft;
    state = State::Waiting;
    setTimer(std::max<Nanoseconds>(settings.restartDelay, 1));
    return true;
  }

  /// Reports the failure of all its actions, and drops the messages that it was to get.
  void failRuns() {
    waiting.clear();
    outgoing.clear();
    for (std::uint32_t i = 0; i < runs.size(); ++i) {
      if (!std::exchange(runs[i].isRunning, false)) continue;
      Report report{.kind = ReportKind::Result, .action = i, .run = runs[i].number};
      if (!runs[i].isAsked) report.text = "its action has ended with " + settings.name;
      reports.push_back(std::move(report));
    }
  }

  void giveUp() {
    state = State::Gone;
    if (!isClosing) reports.push_back({.kind = ReportKind::Lost});
  }

  void fault(std::string text) {
    reports.push_back({.kind = ReportKind::Fault, .text = std::move(text)});
  }
  void note(std::string text) {
    reports.push_back({.kind = ReportKind::Note, .text = std::move(text)});
  }

  static double inSeconds(Nanoseconds time) {
    return static_cast<double>(time) / static_cast<double>(kSecond);
  }
  void setTimer(Nanoseconds delay) { timer.set(std::chrono::nanoseconds(delay)); }

  const Executable& executable;
  ProcessSettings settings;
  std::vector<Run> runs; ///< by action: its latest run
  unsigned restartsLeft;
  Watch watch;
  Timer timer;
  std::optional<process::Child> child;
  State state = State::Gone;
  LineBuffer lines{kLongestLine};
  std::string outgoing;     ///< bytes being sent to the program
  std::string waiting;      ///< messages queued until it is ready
  bool waitsToSend = false; ///< and the watch was asked to report writability
  bool isClosing = false;
  std::string lossReason;
  std::string unsuitedSkill;
  std::deque<Report> reports;
};

} // namespace

std::expected<std::unique_ptr<Platform>, Unusable>
processPlatform(const Executable& executable, ProcessSettings settings,
                const std::function<bool()>& givenUp) {
  auto made = std::make_unique<Process>(executable, std::move(settings));
  auto why = made->begin();
  if (why.empty()) why = made->awaitReady(givenUp);
  if (!why.empty()) return std::unexpected(Unusable{std::move(why), made->unsuited()});
  return made;
}

} // namespace proskill::runtime
