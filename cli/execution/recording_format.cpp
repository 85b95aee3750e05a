#include "cli/execution/recording_format.h"

#include "groot/log.h"

#include <filesystem>

namespace proskill::cli {

namespace {

std::expected<record::WriteRun, std::string> logOfTree(report::RunSubject subject) {
  auto tree = groot::treeOf(subject.program, subject.executable);
  if (!tree) return std::unexpected("a .btlog file is not possible: " + tree.error());
  return
      [tree = std::move(*tree), subject](const report::RecordingSink& sink, std::uint64_t start) {
        const auto add = [append = sink.append](std::string_view bytes) { append(bytes, ""); };
        return groot::logOf(tree, subject.executable, add, start);
      };
}

} // namespace

std::expected<record::WriteRun, std::string> recordingFormat(const std::string& file,
                                                             report::RunSubject subject) {
  if (std::filesystem::path(file).extension() == ".btlog") return logOfTree(subject);
  return record::formatOf(file, subject);
}

} // namespace proskill::cli
