#pragma once

#include "report/run/run_report.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace proskill::report {

/// The steps and remarks of a run as JSON objects, in the form of report_json.h. The constant part
/// of a step is cached; dates and changes are added.
class RunLines {
public:
  explicit RunLines(RunSubject of);

  /// The machine's last step. The result is valid until the next call.
  [[nodiscard]] std::string_view step(const runtime::Machine& machine, verify::TransitionId step,
                                      runtime::Nanoseconds date, runtime::Nanoseconds lag);
  [[nodiscard]] std::string_view remark(const runtime::Remark& remark);
  /// A note in place of steps and remarks that are not shown, with the changes that they made.
  [[nodiscard]] std::string_view missed(std::uint64_t count, const std::vector<verify::Word>& from,
                                        const std::vector<verify::Word>& to,
                                        runtime::Nanoseconds date);

private:
  /// The parts before the dates and after the changes; the latter has no closing brace.
  struct Frame {
    std::string begin;
    std::string end;
  };
  /// Identifies a step by its paths.
  struct Path {
    std::vector<fiacre::OriginId> origins;
    std::vector<std::uint32_t> leaves;
    Frame frame;
  };
  /// Identifies a repeated remark by its kind, subject, command and place.
  using RemarkKey =
      std::tuple<runtime::RemarkKind, const char*, const codegen::ActionCall*, fiacre::OriginId>;

  [[nodiscard]] const Frame& frameOf(const runtime::Machine& machine, verify::TransitionId step);
  [[nodiscard]] const Frame& frameOf(const runtime::Remark& remark);
  [[nodiscard]] Frame frameOf(const ide::TraceStep& step) const;
  void addDates(runtime::Nanoseconds date);
  void addChanges(const std::vector<verify::Word>& from, const std::vector<verify::Word>& to);
  void addValue(std::size_t variable, std::int64_t value);

  RunSubject subject;
  std::vector<std::vector<Path>> paths; ///< by transition
  std::map<RemarkKey, Frame> remarks;
  Frame lastFrame; ///< of what is not cached
  /// By watched variable: `{"variable":"place"`, and the names of its values.
  std::vector<std::string> variables;
  std::vector<std::vector<std::string>> words;
  std::vector<std::string> stops; ///< by action: `,"stops":"fly"`
  runtime::Nanoseconds before = 0;
  std::string line;
};

} // namespace proskill::report
