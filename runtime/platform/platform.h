#pragma once

#include "runtime/machine/executable.h"

#include <string>
#include <vector>

namespace proskill::runtime {

/// Each start of an action has a number of its own, so that a late word on one is never taken for a
/// word on the next.
using RunNumber = std::uint64_t;

/// An action that is to be performed.
struct Start {
  std::uint32_t action = 0; ///< in Executable::actions
  RunNumber run = 0;
  const codegen::ActionCall* call = nullptr; ///< null where the skill has no `:action`
};

enum class ReportKind : std::uint8_t {
  Result, ///< an action has ended
  Signal, ///< an event, or an interrupt from outside
  Fault,  ///< the platform does not do what it should; `text` says what
  Note,   ///< something that changes nothing: `text`
  Lost,   ///< the platform has ended and will say no more
};

inline constexpr std::uint32_t kUnknownResult = UINT32_MAX;

/// What a platform has to say.
struct Report {
  ReportKind kind = ReportKind::Result;
  Nanoseconds date = 0;
  std::uint32_t action = 0;
  RunNumber run = 0;
  std::uint32_t result = kUnknownResult; ///< in codegen::Performed::results
  std::uint32_t signal = 0;              ///< in codegen::Model::signals
  std::string text;
};

/// Who performs the actions, and where events and interrupts come from.
class Platform {
public:
  virtual ~Platform() = default;
  virtual void start(const Start& start, Nanoseconds date) = 0;
  /// Asks a running action to stop; it is asked once. True where it has ended by that, so that
  /// there will be no report of its end.
  [[nodiscard]] virtual bool stop(std::uint32_t action, RunNumber run, Nanoseconds date) = 0;
  /// The skill of an action that did not stop in time has ended: nothing that is said of the run
  /// counts any more.
  virtual void abandon(std::uint32_t action, RunNumber run, Nanoseconds date) {
    static_cast<void>(action);
    static_cast<void>(run);
    static_cast<void>(date);
  }
  /// When it will have something to say by itself. Nothing: never, or it cannot know.
  [[nodiscard]] virtual std::optional<Nanoseconds> next() const = 0;
  /// What it has to say at this date, one after the other. False where that is all.
  virtual bool poll(Nanoseconds date, Report& report) = 0;
  /// Whether it may say something that next() does not announce.
  [[nodiscard]] virtual bool mayReport() const { return false; }
  /// The run is over: nothing is asked of it any more. It may have things to say until it is
  /// closed.
  virtual void close() {}
  [[nodiscard]] virtual bool isClosed() const { return true; }
  /// What can be read when it has something to say.
  virtual void addDescriptors(std::vector<int>& all) const { static_cast<void>(all); }
};

} // namespace proskill::runtime
