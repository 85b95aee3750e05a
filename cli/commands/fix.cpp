#include "cli/commands/fix.h"

#include "disk/output.h"

#include <algorithm>
#include <map>
#include <vector>

namespace proskill::cli {

namespace {

namespace fs = std::filesystem;

struct Edit {
  syntax::Range range;
  std::string text;
};

struct Edited {
  const std::string* before = nullptr;
  std::vector<Edit> edits;
};

/// Codes of the flow analysis, and of models in Fiacre, that are fixed without asking, since the
/// fix keeps the meaning. Other findings are for users to decide.
constexpr std::string_view kWithoutAsking[] = {"PS0702", "PS0901", "PS1005",
                                               "PS1103", "PS1201", "PS1302"};

bool isForPerson(const syntax::Diagnostic& diagnostic) {
  const std::string_view id = syntax::info(diagnostic.code).id;
  return id >= "PS0500" && std::ranges::find(kWithoutAsking, id) == std::end(kWithoutAsking);
}

std::string apply(const Edited& file) {
  std::string text = *file.before;
  for (auto edit = file.edits.rbegin(); edit != file.edits.rend(); ++edit)
    text.replace(edit->range.begin, edit->range.length(), edit->text);
  return text;
}

} // namespace

std::expected<FixCount, std::string> applyFixes(std::span<const report::CheckedProgram> programs) {
  std::map<fs::path, Edited> files;
  FixCount count;
  for (const report::CheckedProgram& checked : programs)
    for (const syntax::Diagnostic& diagnostic : checked.diagnostics) {
      if (diagnostic.fixes.size() != 1 || isForPerson(diagnostic)) continue;
      const syntax::Fix& fix = diagnostic.fixes.front();
      const analysis::File& file = checked.program.files[fix.location.file];
      Edited& edited = files[file.path];
      edited.before = &file.document.text();
      auto clashes = [&](const Edit& other) { return other.range.touches(fix.location.range); };
      if (std::ranges::any_of(edited.edits, clashes)) continue;
      edited.edits.push_back({fix.location.range, fix.text});
      ++count.findings;
    }
  for (auto& [path, edited] : files) {
    std::ranges::sort(edited.edits, {}, [](const Edit& edit) { return edit.range.begin; });
    if (auto failed = disk::writeFile(path, apply(edited)))
      return std::unexpected(std::move(*failed));
    ++count.files;
  }
  return count;
}

} // namespace proskill::cli
