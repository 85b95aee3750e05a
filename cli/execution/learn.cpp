#include "cli/execution/learn.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/progress.h"
#include "disk/disk.h"
#include "ide/verdicts/verification.h"
#include "runtime/conform/durations.h"
#include "syntax/text/utf8.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
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
                                      const DurationsBySkill& measured) {
  std::vector<Widened> all;
  for (const auto& [skill, durations] : measured) {
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

/// Verifies within a time. The error is an exit code.
std::expected<std::unique_ptr<Verified>, int> verified(const analysis::Program& program,
                                                       const std::string& main, double seconds) {
  auto model = codegen::generate(program, {.mainSkill = main});
  if (!model) return std::unexpected(failGeneration(program, model.error()));
  auto made = std::make_unique<Verified>();
  made->model = std::move(*model);
  ProgressLine progress;
  verify::Options options;
  options.limits = {.seconds = seconds, .bytes = std::uint64_t{2} << 30, .classes = {}};
  options.progress = progress.callback();
  auto report = ide::verifyModel(made->model, {}, options, {}, ide::kNoTraces);
  if (!report) return std::unexpected(failUnsupported(report.error()));
  made->rows = std::move(report->rows);
  return made;
}

/// What the new intervals change. Only what is decided with both is compared.
struct Comparison {
  struct Changed {
    const ide::VerdictRow* row = nullptr;
    ide::Verdict before{};
  };
  std::vector<Changed> changed;
  std::vector<const ide::VerdictRow*> undecided;
};

Comparison compared(const Verified& before, const Verified& after) {
  constexpr auto kOpen = ide::Verdict::Inconclusive;
  std::map<std::string_view, ide::Verdict> known;
  for (const auto& row : before.rows) known.emplace(row.check->name, row.verdict);
  Comparison made;
  for (const auto& row : after.rows) {
    const auto found = known.find(row.check->name);
    if (found == known.end()) continue;
    if (found->second == kOpen || row.verdict == kOpen)
      made.undecided.push_back(&row);
    else if (found->second != row.verdict)
      made.changed.push_back({&row, found->second});
  }
  return made;
}

std::string intervalsText(const std::vector<Widened>& edits) {
  std::string text;
  for (const auto& edit : edits)
    text += fmt::format("{}{} for `{}`", text.empty() ? "" : " and ", edit.interval, edit.skill);
  return syntax::printable(text);
}

std::string propertiesText(std::size_t count, std::string_view none = "0") {
  return fmt::format("{} {}", count == 0 ? std::string(none) : std::to_string(count),
                     count == 1 ? "property" : "properties");
}

void sayChanges(const Comparison& comparison, const std::vector<Widened>& edits, double seconds,
                report::Paint paint) {
  const auto& [changed, undecided] = comparison;
  std::cout << fmt::format("with {} {} {}\n", intervalsText(edits),
                           propertiesText(changed.size(), "no"),
                           changed.size() == 1 ? "changes" : "change");
  for (const auto& [row, before] : changed)
    std::cout << fmt::format(
        "  {} {}: {} → {}\n",
        row->good() ? paint(report::Colour::Green, "✓") : paint(report::Colour::Red, "✗"),
        syntax::printable(row->check->description), toString(before), toString(row->verdict));
  if (undecided.empty()) return;
  std::cout << fmt::format("{} not decided in {:g} s (--time-limit):\n",
                           undecided.size() == 1 ? "1 property was"
                                                 : propertiesText(undecided.size()) + " were",
                           seconds);
  for (const auto* row : undecided)
    std::cout << fmt::format("  ? {}\n", syntax::printable(row->check->description));
}

} // namespace

int learn(const analysis::Program& program, const std::string& file,
          const DurationsBySkill& measured, const LearnOptions& options) {
  const auto edits = widenedIntervals(program, measured);
  if (edits.empty()) {
    std::cout << "every action kept its interval: there is nothing to learn\n";
    return kDone;
  }
  std::cout.flush(); // before the verification, which may take long
  const auto other = edited(program, file, edits);
  const auto begin = std::chrono::steady_clock::now();
  const auto before = verified(program, options.mainSkill, options.seconds / 2);
  if (!before) return before.error();
  const std::chrono::duration<double> used = std::chrono::steady_clock::now() - begin;
  const auto after =
      verified(other, options.mainSkill, std::max(0.0, options.seconds - used.count()));
  if (!after) return after.error();
  const auto comparison = compared(**before, **after);
  sayChanges(comparison, edits, options.seconds,
             report::Paint{wantsColour(options.colour, STDOUT_FILENO)});
  return kDone;
}

} // namespace proskill::cli
