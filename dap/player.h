#pragma once

#include "dap/source.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace proskill::dap {

/// Why a run stopped.
enum class Stop : std::uint8_t { Step, Breakpoint, Variable, Start, End, TooLong };

/// Moves forwards and backwards through steps. The position is the number of steps taken; the next
/// step has not happened yet.
class Player {
public:
  explicit Player(std::unique_ptr<StepSource> source);

  [[nodiscard]] const Trace& trace() const { return source->trace(); }
  [[nodiscard]] bool isSimulation() const { return source->isSimulation(); }
  [[nodiscard]] std::size_t position() const { return taken.size(); }
  /// The steps that were taken.
  [[nodiscard]] const std::vector<Step>& past() const { return taken; }
  /// The possible next steps; the first is the one of a plain step.
  [[nodiscard]] const std::vector<Step>& choices() const { return next; }
  /// All actors, in the order of their first steps.
  [[nodiscard]] const std::vector<std::string>& actors() const { return known; }
  /// The actor of the next step; at the end, the actor of the last one. Empty if there is none.
  [[nodiscard]] std::string actor() const;

  /// The value of each variable after `at` steps. \pre `at` <= position()
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> valuesAt(std::size_t at) const;

  void setBreakpoints(const std::filesystem::path& path, std::set<unsigned> lines);
  void setWatched(std::set<std::string> variables) { watched = std::move(variables); }
  [[nodiscard]] bool hasLine(const std::filesystem::path& path, unsigned line) const {
    return source->hasLine(path, line);
  }

  /// Takes a step; returns End if there is none. \pre choice < choices().size(), or there are none
  Stop step(std::size_t choice = 0);
  Stop stepBack();
  /// Continues until the next step is at a breakpoint, a watched variable has changed, or no step
  /// is left. Stops an endless simulation.
  Stop run();
  Stop runBack();
  /// Continues until the actor is about to act again.
  Stop runUntil(const std::string& wanted);
  void goTo(std::size_t position);

private:
  [[nodiscard]] bool atBreakpoint() const;
  [[nodiscard]] bool changedWatched() const;
  void look();

  std::unique_ptr<StepSource> source;
  std::vector<Step> taken;
  std::vector<Step> next;
  std::vector<std::string> known;
  std::set<std::pair<std::filesystem::path, unsigned>> breakpoints;
  std::set<std::string> watched;
};

} // namespace proskill::dap
