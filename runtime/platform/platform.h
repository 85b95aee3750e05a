#pragma once

#include "runtime/machine/executable.h"

#include <string>
#include <vector>

namespace proskill::runtime {

/// Number of a start of an action. Numbers are never reused, so late messages on a run cannot be
/// taken for messages on the next.
using RunNumber = std::uint64_t;

/// The start of an action.
struct Start {
  std::uint32_t action = 0; ///< in Executable::actions
  RunNumber run = 0;
  const codegen::ActionCall* call = nullptr; ///< null if the skill has no `:action`
};

enum class ReportKind : std::uint8_t {
  Result, ///< an action has ended
  Signal, ///< an event, or an interrupt from outside
  Fault,  ///< the platform violates the protocol; `text` says how
  Note,   ///< a remark without effect: `text`
  Lost,   ///< the platform has ended and will report nothing more
};

inline constexpr std::uint32_t kUnknownResult = UINT32_MAX;

/// A report of the platform.
struct Report {
  ReportKind kind = ReportKind::Result;
  Nanoseconds date = 0;
  std::uint32_t action = 0;
  RunNumber run = 0;
  std::uint32_t result = kUnknownResult; ///< in codegen::Performed::results
  std::uint32_t signal = 0;              ///< in codegen::Model::signals
  std::string text;
};

/// Performs the actions, and reports events and interrupts.
class Platform {
public:
  virtual ~Platform() = default;
  virtual void start(const Start& start, Nanoseconds date) = 0;
  /// Asks a running action to stop; called once per run.
  /// \return true if the action has ended with this call; no report of its end will follow
  [[nodiscard]] virtual bool stop(std::uint32_t action, RunNumber run, Nanoseconds date) = 0;
  /// The skill of an action that did not stop in time has ended: further reports of the run are
  /// ignored.
  virtual void abandon(std::uint32_t action, RunNumber run, Nanoseconds date) {
    static_cast<void>(action);
    static_cast<void>(run);
    static_cast<void>(date);
  }
  /// Date of its next report. nullopt: never, or unknown.
  [[nodiscard]] virtual std::optional<Nanoseconds> next() const = 0;
  /// Takes the next report at this date.
  /// \return false if there is none
  virtual bool poll(Nanoseconds date, Report& report) = 0;
  /// Whether it may make reports that next() does not announce.
  [[nodiscard]] virtual bool mayReport() const { return false; }
  /// The run is over: no action will be started or stopped. It may still report until it is closed.
  virtual void close() {}
  [[nodiscard]] virtual bool isClosed() const { return true; }
  /// Adds the descriptors that are readable when it has a report.
  virtual void addDescriptors(std::vector<int>& all) const { static_cast<void>(all); }
};

} // namespace proskill::runtime
