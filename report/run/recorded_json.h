#pragma once

#include "analysis/program/program.h"
#include "runtime/conform/recorded_run.h"

#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>

/// The JSON of a recorded run. Each function throws a `WrongRecording` if it is none.
namespace proskill::report {

struct WrongRecording {
  std::string why;
};

/// \param trace a trace, whose steps do not matter
[[nodiscard]] runtime::RecordedHead recordedHead(const nlohmann::json& trace);

/// Passes on steps and the starts of actions. What a step says each time is read once: only its
/// date is read again.
class StepReader {
public:
  /// \pre the program outlives this
  explicit StepReader(const analysis::Program& of) : program(of) {}

  /// \return whether more is wanted
  [[nodiscard]] bool pass(const nlohmann::json& step, runtime::RunSink& to);
  /// \param step the text of a step \return likewise; nothing if it is not JSON
  [[nodiscard]] std::optional<bool> pass(std::string_view step, runtime::RunSink& to);

private:
  /// A step, the start of an action, or a remark that is not passed on.
  using Entry = std::variant<std::monostate, runtime::RecordedStep, runtime::RecordedCall>;

  [[nodiscard]] Entry entryOf(const nlohmann::json& value);
  [[nodiscard]] bool pass(Entry& entry, runtime::RunSink& to);
  void keep(const Entry& entry);
  [[nodiscard]] runtime::RecordedStep stepOf(const nlohmann::json& value);
  [[nodiscard]] static runtime::RecordedCall callOf(const nlohmann::json& remark);
  void locate(const nlohmann::json& step, fiacre::Origin& what);
  [[nodiscard]] std::optional<std::uint32_t> fileNamed(const std::string& path);

  const analysis::Program& program;
  std::map<std::string, std::optional<std::uint32_t>> files; ///< by path: those seen before
  std::unordered_map<std::string, Entry> entries;            ///< by their texts without dates
  std::string key;                                           ///< a member, to avoid allocations
  std::size_t count = 0;                                     ///< of the steps
};

} // namespace proskill::report
