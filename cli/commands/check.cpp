#include "cli/commands/commands.h"

#include "cli/commands/fix.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/paint.h"
#include "disk/disk.h"
#include "ide/snapshot/fiacre_file.h"
#include "report/check/check_report.h"
#include "report/program_settings.h"
#include "report/text/render.h"
#include "runtime/check/platform_check.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <unistd.h>

namespace proskill::cli {

namespace {

namespace fs = std::filesystem;

enum class Format : std::uint8_t { Text, Short, Json, Sarif };

struct CheckArguments {
  std::vector<std::string> files;
  Format format = Format::Text;
  ColourChoice colour = ColourChoice::Auto;
  bool fragment = false;
  bool fix = false;
  bool style = false;
};

/// An error in the settings with its place: `FILE:3:14: unknown setting …`
std::string placed(const fs::path& file, const report::SettingsMistake& mistake) {
  const auto [line, column] = syntax::LineIndex(mistake.text).position(mistake.at.begin);
  return file.generic_string() + ":" + std::to_string(line + 1) + ":" + std::to_string(column + 1) +
         ": " + mistake.description;
}

/// Inserts a diagnostic after those at earlier places of the program.
void insertInOrder(std::vector<syntax::Diagnostic>& all, syntax::Diagnostic diagnostic) {
  const auto placeOf = [](const syntax::Diagnostic& each) {
    return std::pair(each.location.file, each.location.range.begin);
  };
  const auto after = std::ranges::upper_bound(all, placeOf(diagnostic), {}, placeOf);
  all.insert(after, std::move(diagnostic));
}

/// Loads the programs of the given files. A file that another one includes is checked as part of
/// that program.
class Loader {
public:
  explicit Loader(const CheckArguments& arguments) : arguments(arguments) {}

  /// \return false if a file cannot be read, which was printed to standard error
  bool add(const std::string& file) {
    const fs::path canonical = disk.canonical(file);
    if (std::ranges::find(roots, canonical, &Root::canonical) != roots.end()) return true;
    if (ide::isFiacre(file)) return addFiacre(file, canonical);
    auto document = disk.document(file);
    if (!document) {
      fail("cannot read `" + file + "`: " + document.error());
      return false;
    }
    const auto extent = arguments.fragment ? analysis::Extent::Fragment : analysis::Extent::Whole;
    Root root{canonical, {}, analysis::load(disk, file, std::move(*document), extent), {}};
    for (std::size_t i = 1; i < root.program.files.size(); ++i)
      root.includes.insert(disk.canonical(root.program.files[i].path));
    roots.push_back(std::move(root));
    return true;
  }

  bool addFiacre(const std::string& file, const fs::path& canonical) {
    auto text = disk.read(file);
    if (!text) {
      fail("cannot read `" + file + "`: " + text.error());
      return false;
    }
    auto read = ide::readFiacre(file, std::move(*text));
    auto found = analysis::flow::weighed(std::move(read.diagnostics), settings(canonical));
    roots.push_back({canonical, {}, std::move(read.program), std::move(found)});
    return true;
  }

  std::vector<report::CheckedProgram> check() {
    for (std::size_t i = 0; i < roots.size(); ++i) roots[i].included = includedByOther(i);
    std::vector<report::CheckedProgram> checked;
    for (Root& root : roots) {
      if (root.included) continue;
      auto diagnostics = root.found ? std::move(*root.found) : inspected(root);
      checked.push_back({std::move(root.program), std::move(diagnostics)});
    }
    return checked;
  }

  /// Whether all files of settings were valid.
  [[nodiscard]] bool understood() const { return !mistaken; }

private:
  struct Root {
    fs::path canonical;
    std::set<fs::path> includes;
    analysis::Program program;
    std::optional<std::vector<syntax::Diagnostic>> found; ///< findings in a Fiacre model
    bool included = false;
  };

  std::vector<syntax::Diagnostic> inspected(const Root& root) {
    const auto weights = settings(root.canonical);
    const auto analysis = analysis::analyse(root.program);
    auto all = analysis::flow::inspect(root.program, analysis, weights);
    const auto read = [this](const fs::path& path) { return disk.read(path); };
    const bool isSound = analysis::flow::hasFlow(root.program, analysis);
    for (auto& finding : runtime::checkNamedPlatform(root.program, isSound, weights, read))
      insertInOrder(all, std::move(finding.diagnostic));
    return all;
  }

  analysis::flow::Settings settings(const fs::path& root) {
    auto [result, file, mistake] = report::settingsFor(disk, root);
    if (mistake) fail(placed(file, *mistake));
    mistaken |= mistake.has_value();
    result.style |= arguments.style;
    return result;
  }

  /// Whether another file includes this one. If two include each other, the second is kept.
  [[nodiscard]] bool includedByOther(std::size_t i) const {
    return std::ranges::any_of(roots, [&](const Root& other) {
      return &other != &roots[i] && !other.included && other.includes.contains(roots[i].canonical);
    });
  }

  const CheckArguments& arguments;
  disk::DiskFileSystem disk;
  std::vector<Root> roots;
  bool mistaken = false;
};

/// Removes findings in files that an earlier program has, too.
void removeRepeated(std::vector<report::CheckedProgram>& programs) {
  std::set<std::tuple<std::string, syntax::Offset, syntax::Offset, std::string>> seen;
  for (report::CheckedProgram& checked : programs)
    std::erase_if(checked.diagnostics, [&](const syntax::Diagnostic& it) {
      const auto& path = checked.program.files[it.location.file].path;
      return !seen.insert({path.generic_string(), it.location.range.begin, it.location.range.end,
                           std::string(syntax::info(it.code).id) + it.message})
                  .second;
    });
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string summary(const report::FindingCounts& counts) {
  std::string found;
  for (const auto& [count, noun] :
       {std::pair(counts.errors, "error"), std::pair(counts.warnings, "warning"),
        std::pair(counts.hints, "hint")})
    if (count > 0) found += (found.empty() ? "" : ", ") + counted(count, noun);
  return (found.empty() ? "nothing to report" : found) + " in " + counted(counts.files, "file");
}

void write(const CheckArguments& arguments, const std::vector<report::CheckedProgram>& programs) {
  switch (arguments.format) {
  case Format::Text:
    for (const report::CheckedProgram& checked : programs)
      render(std::cout, checked.program, checked.diagnostics,
             report::Paint{wantsColour(arguments.colour, STDOUT_FILENO)});
    break;
  case Format::Short: writeCheckShort(std::cout, programs); break;
  case Format::Json: writeCheckJson(std::cout, programs); break;
  case Format::Sarif: writeCheckSarif(std::cout, programs); break;
  }
}

/// \return whether all files could be read
bool load(const CheckArguments& arguments, std::vector<report::CheckedProgram>& programs) {
  Loader loader(arguments);
  bool readable = true;
  for (const std::string& file : arguments.files) readable &= loader.add(file);
  programs = loader.check();
  if (programs.size() > 1) removeRepeated(programs);
  return readable && loader.understood();
}

/// Applies fixes and checks again. \return whether all files could be read and written
bool fix(const CheckArguments& arguments, std::vector<report::CheckedProgram>& programs) {
  auto fixed = applyFixes(programs);
  if (!fixed) {
    fail(fixed.error());
    return false;
  }
  std::cerr << "fixed " << counted(fixed->findings, "finding") << " in "
            << counted(fixed->files, "file") << '\n';
  return fixed->findings == 0 || load(arguments, programs);
}

int runCheck(const CheckArguments& arguments) {
  std::vector<report::CheckedProgram> programs;
  bool readable = load(arguments, programs);
  if (readable && arguments.fix) readable = fix(arguments, programs);
  write(arguments, programs);
  std::cout.flush();
  if (!std::cout) return fail("the report could not be written to standard output");
  const report::FindingCounts counts = report::countFindings(programs);
  const bool forPeople = arguments.format == Format::Text || arguments.format == Format::Short;
  if (forPeople && !programs.empty()) std::cerr << summary(counts) << '\n';
  if (!readable) return kFailed;
  return counts.errors + counts.warnings > 0 ? kFound : kDone;
}

} // namespace

void addCheck(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<CheckArguments>();
  auto* command = app.add_subcommand("check", "Find errors in programs");
  command
      ->add_option("file", arguments->files, "Root files of programs, or models in Fiacre (.fcr)")
      ->required();
  show(command->add_flag("--fragment", arguments->fragment,
                         "The files are parts of programs: names defined elsewhere are only hints"),
       group::kSubject);
  show(command->add_flag("--style", arguments->style, "Report hints on style too"),
       group::kSubject);
  show(command->add_flag("--fix", arguments->fix,
                         "Apply the fixes that are safe to the files, then report what is left"),
       group::kOutput);
  addChoice<Format>(*command, "--format", arguments->format,
                    {{"text", Format::Text},
                     {"short", Format::Short},
                     {"json", Format::Json},
                     {"sarif", Format::Sarif}},
                    "How to print findings; short: one line each");
  addColour(*command, arguments->colour);
  showBelow(*command, {"proskill check mission.proskill", "proskill check --fix *.proskill"},
            {{kDone, "no errors and no warnings"},
             {kFound, "errors or warnings were found"},
             {kFailed, "the command line is wrong, or a file cannot be read"}});
  command->callback([arguments, &exitCode] { exitCode = runCheck(*arguments); });
}

} // namespace proskill::cli
