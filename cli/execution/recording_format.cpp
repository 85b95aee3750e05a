#include "cli/execution/recording_format.h"

#include "groot/log.h"

#include <filesystem>

namespace proskill::cli {

namespace {

std::expected<WriteRun, std::string> logOfTree(report::RunSubject subject) {
  auto tree = groot::treeOf(subject.program, subject.executable);
  if (!tree) return std::unexpected("a .btlog file is not possible: " + tree.error());
  return
      [tree = std::move(*tree), subject](const report::RecordingSink& sink, std::uint64_t start) {
        const auto add = [append = sink.append](std::string_view bytes) { append(bytes, ""); };
        return groot::logOf(tree, subject.executable, add, start);
      };
}

} // namespace

std::expected<WriteRun, std::string> recordingFormat(const std::string& file,
                                                     report::RunSubject subject) {
  const auto extension = std::filesystem::path(file).extension();
  if (extension == ".btlog") return logOfTree(subject);
  if (extension == ".mcap")
    return [subject](report::RecordingSink sink, std::uint64_t start) {
      return report::runMcap(std::move(sink), subject, start);
    };
  return [subject](const report::RecordingSink& sink, std::uint64_t) {
    return report::runRecording(sink.append, subject);
  };
}

std::uint64_t startOfRun(RunTime time) {
  using std::chrono::nanoseconds;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return time == RunTime::Simulated
             ? 0
             : static_cast<std::uint64_t>(std::chrono::duration_cast<nanoseconds>(now).count());
}

} // namespace proskill::cli
