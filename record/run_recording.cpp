#include "record/run_recording.h"

#include <chrono>
#include <filesystem>

namespace proskill::record {

namespace {

/// The start of a run that begins now, in nanoseconds since 1970, to match other recordings of the
/// robot; 0 in simulated time.
std::uint64_t startOfRun(RunTime time) {
  using std::chrono::nanoseconds;
  if (time == RunTime::Simulated) return 0;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(std::chrono::duration_cast<nanoseconds>(now).count());
}

} // namespace

WriteRun formatOf(const std::string& file, report::RunSubject subject) {
  if (std::filesystem::path(file).extension() == ".mcap")
    return [subject](report::RecordingSink sink, std::uint64_t start) {
      return report::runMcap(std::move(sink), subject, start);
    };
  return [subject](const report::RecordingSink& sink, std::uint64_t) {
    return report::runRecording(sink.append, subject);
  };
}

RunRecording::RunRecording(disk::GrowingFile file, RunTime time, const WriteRun& write,
                           std::function<void(const std::string& why)> whenEnded)
    : recorder(std::move(file), time),
      complain(std::move(whenEnded)),
      run(write(sink(), startOfRun(time))) {}

report::RecordingSink RunRecording::sink() {
  return {
      [this](std::string_view bytes, std::string_view end) { report(recorder.add(bytes, end)); },
      [this](std::uint64_t at, std::string_view bytes) { report(recorder.replace(at, bytes)); }};
}

void RunRecording::report(const std::optional<std::string>& wrong) const {
  if (wrong) complain(*wrong + "; the recording ends here");
}

void RunRecording::onStep(const runtime::Machine& machine, verify::TransitionId step,
                          runtime::Nanoseconds date, runtime::Nanoseconds lag) {
  run->onStep(machine, step, date, lag);
}

void RunRecording::onRemark(const runtime::Remark& remark) { run->onRemark(remark); }

void RunRecording::finish() {
  if (!run) return;
  run.reset(); // what it adds at its end is still recorded
  report(recorder.finish());
  if (const auto lost = recorder.lost()) complain(*lost + ": the recording is lost");
}

} // namespace proskill::record
