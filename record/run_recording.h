#pragma once

#include "record/recorder.h"
#include "report/run/run_report.h"

#include <functional>
#include <memory>
#include <string>

namespace proskill::record {

/// Makes the observer that writes a run. \param start in nanoseconds since 1970; 0: in simulated
/// time
using WriteRun = std::function<std::unique_ptr<runtime::Observer>(report::RecordingSink sink,
                                                                  std::uint64_t start)>;

/// The format of a recording, by the extension of its file: `.mcap`, or else a trace.
[[nodiscard]] WriteRun formatOf(const std::string& file, report::RunSubject subject);

/// Records a run in a file while it happens.
class RunRecording final : public runtime::Observer {
public:
  /// \param complain gets the reason if the recording ends early, once
  RunRecording(disk::GrowingFile file, RunTime time, const WriteRun& write,
               std::function<void(const std::string& why)> complain);
  ~RunRecording() override { finish(); }

  void onStep(const runtime::Machine& machine, verify::TransitionId step, runtime::Nanoseconds date,
              runtime::Nanoseconds lag) override;
  void onRemark(const runtime::Remark& remark) override;
  /// Completes the file. \pre nothing follows
  void finish();

private:
  [[nodiscard]] report::RecordingSink sink();
  void report(const std::optional<std::string>& wrong) const;

  Recorder recorder;
  std::function<void(const std::string& why)> complain;
  std::unique_ptr<runtime::Observer> run; ///< null: finished
};

} // namespace proskill::record
