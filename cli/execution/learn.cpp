#include "cli/execution/learn.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "disk/disk.h"
#include "ide/verdicts/verification.h"
#include "runtime/conform/durations.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <unistd.h>

namespace proskill::cli {

namespace {

/// An interval to be written at a place of the program.
struct Widened {
  std::string skill;
  std::string interval;
  analysis::Location at;
};

/// Files of the disk, some of them with other texts.
class EditedFiles final : public disk::DiskFileSystem {
public:
  [[nodiscard]] std::expected<std::string, std::string>
  read(const std::filesystem::path& path) const override {
    const auto found = texts.find(canonical(path));
    return found == texts.end() ? DiskFileSystem::read(path) : found->second;
  }
  std::map<std::filesystem::path, std::string> texts;
};

std::string runsText(std::size_t count) {
  return count == 1 ? "a run of its action" : fmt::format("{} runs of its action", count);
}

std::vector<Widened> widenedIntervals(const analysis::Program& program,
                                      const std::vector<runtime::RecordedRun>& runs) {
  std::vector<Widened> all;
  for (const auto& [skill, durations] : runtime::durationsOf(program, runs)) {
    const auto* definition = program.skills.find(skill);
    const auto& declared = definition->node().timeInterval;
    if (!declared) continue;
    auto interval = runtime::widened(*declared, durations);
    const auto seconds = [](runtime::Nanoseconds time) {
      return fmt::format("{:.6g}", static_cast<double>(time) / 1e9);
    };
    if (interval.empty()) continue;
    const auto range = durations.least == durations.most
                           ? seconds(durations.least)
                           : seconds(durations.least) + " to " + seconds(durations.most);
    const auto promised = program.files[definition->file].document.text().substr(
        declared->range.begin, declared->range.end - declared->range.begin);
    std::cout << syntax::printable(fmt::format("`{}` took {} s in {}; it promises {}", skill, range,
                                               runsText(durations.count), promised))
              << '\n';
    all.push_back({skill, std::move(interval), {definition->file, declared->range}});
  }
  return all;
}

/// The program with other intervals.
analysis::Program edited(const analysis::Program& program, const std::string& file,
                         std::vector<Widened> edits) {
  EditedFiles files;
  std::ranges::sort(edits, std::greater{}, [](const Widened& it) { return it.at.range.begin; });
  for (const auto& edit : edits) {
    const auto& from = program.files[edit.at.file];
    auto& text =
        files.texts.try_emplace(files.canonical(from.path), from.document.text()).first->second;
    text.replace(edit.at.range.begin, edit.at.range.end - edit.at.range.begin, edit.interval);
  }
  auto document = files.document(file);
  return analysis::load(files, file, std::move(*document));
}

/// A model with its verdicts, whose rows refer to it.
struct Verified {
  codegen::Model model;
  std::vector<ide::VerdictRow> rows;
};

/// The error is an exit code.
std::expected<std::unique_ptr<Verified>, int> verified(const analysis::Program& program,
                                                       const std::string& main) {
  auto model = codegen::generate(program, {.mainSkill = main});
  if (!model) return std::unexpected(failGeneration(program, model.error()));
  auto made = std::make_unique<Verified>();
  made->model = std::move(*model);
  verify::Options options;
  options.limits = {.seconds = 60, .bytes = std::uint64_t{2} << 30, .classes = {}};
  auto report = ide::verifyModel(made->model, {}, options, {}, ide::kNoTraces);
  if (!report) return std::unexpected(failUnsupported(report.error()));
  made->rows = std::move(report->rows);
  return made;
}

void sayChanges(const Verified& before, const Verified& after, const std::vector<Widened>& edits,
                report::Paint paint) {
  std::map<std::string_view, ide::Verdict> known;
  for (const auto& row : before.rows) known.emplace(row.check->name, row.verdict);
  std::vector<const ide::VerdictRow*> changed;
  for (const auto& row : after.rows)
    if (const auto found = known.find(row.check->name);
        found != known.end() && found->second != row.verdict)
      changed.push_back(&row);
  std::string intervals;
  for (const auto& edit : edits)
    intervals +=
        fmt::format("{}{} for `{}`", intervals.empty() ? "" : " and ", edit.interval, edit.skill);
  std::cout << fmt::format("with {} {} {}\n", syntax::printable(intervals),
                           changed.empty() ? "no" : std::to_string(changed.size()),
                           changed.size() == 1 ? "property changes" : "properties change");
  for (const auto* row : changed)
    std::cout << fmt::format("  {} {}: {} → {}\n",
                             row->good() ? paint(report::Colour::Green, "✓")
                                         : paint(report::Colour::Red, "✗"),
                             syntax::printable(row->check->description),
                             toString(known.at(row->check->name)), toString(row->verdict));
}

} // namespace

int learn(const analysis::Program& program, const std::string& file, const std::string& mainSkill,
          const std::vector<runtime::RecordedRun>& runs, ColourChoice colour) {
  const auto edits = widenedIntervals(program, runs);
  if (edits.empty()) {
    std::cout << "every action kept its interval: there is nothing to learn\n";
    return kDone;
  }
  const auto other = edited(program, file, edits);
  const auto before = verified(program, mainSkill);
  if (!before) return before.error();
  const auto after = verified(other, mainSkill);
  if (!after) return after.error();
  sayChanges(**before, **after, edits, report::Paint{wantsColour(colour, STDOUT_FILENO)});
  return kDone;
}

} // namespace proskill::cli
