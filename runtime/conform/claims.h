#pragma once

#include "runtime/conform/recorded_run.h"

#include <map>
#include <optional>
#include <string>

namespace proskill::runtime {

/// Compares what a recording claims besides its steps with the program: initial values, messages,
/// and the calls of actions. Each function returns why a claim is wrong.
class Claims {
public:
  using Why = std::optional<std::string>;

  /// \pre the executable outlives this
  /// \param by whether messages have to be at the same places of the program
  Claims(const Executable& of, bool by) : executable(of), placesMatter(by) {}

  [[nodiscard]] Why initial(const RecordedHead& head);
  [[nodiscard]] Why step(const RecordedStep& step);
  /// An action starts in a step of its skill, with arguments that some call gives.
  [[nodiscard]] Why call(const RecordedCall& call) const;

private:
  [[nodiscard]] Why message(const RecordedStep& step) const;
  [[nodiscard]] bool isAt(const fiacre::Origin& origin, const fiacre::Origin& what) const;
  [[nodiscard]] Why textOf(const std::vector<MessagePart>& message) const;
  [[nodiscard]] Why textOf(const MessagePart& part) const;

  const Executable& executable;
  bool placesMatter;
  std::map<std::string, std::string> values; ///< by variable, before the step
  std::string lastActor;                     ///< of the last step
  std::optional<Nanoseconds> lastDate;       ///< nullopt: there is no step
};

} // namespace proskill::runtime
