#include "cli/execution/stubs.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "runtime/stubs/stubs.h"
#include "syntax/text/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <iostream>

namespace proskill::cli {

namespace {

enum class StubLanguage : std::uint8_t { Python, C, Cpp };

struct StubArguments {
  StubLanguage language = StubLanguage::Python;
  std::string file;
  std::string directory;
  std::string mainSkill;
  ColourChoice colour = ColourChoice::Auto;
};

enum class Fate : std::uint8_t { Write, Keep, Refuse };

/// Files of users, and generated files that users have changed, are never overwritten.
Fate fateOf(const runtime::StubFile& file, const std::filesystem::path& path) {
  std::error_code none;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, none))) return Fate::Write;
  if (file.isUsers) return Fate::Keep;
  const auto text = disk::DiskFileSystem().read(path);
  return text && runtime::isUnchangedStub(*text) ? Fate::Write : Fate::Refuse;
}

int writeStubs(const std::vector<runtime::StubFile>& files,
               const std::filesystem::path& directory) {
  for (const auto& file : files)
    if (fateOf(file, directory / file.name) == Fate::Refuse)
      return fail(fmt::format("`{}` is not as it was generated: move your changes elsewhere, and "
                              "remove it",
                              (directory / file.name).generic_string()));
  std::error_code problem;
  std::filesystem::create_directories(directory, problem);
  if (problem)
    return fail(
        fmt::format("cannot create `{}`: {}", directory.generic_string(), problem.message()));
  for (const auto& file : files) {
    const auto path = directory / file.name;
    std::filesystem::create_directories(path.parent_path(), problem); // writing the file reports
                                                                      // errors
    const bool writes = fateOf(file, path) == Fate::Write;
    if (writes)
      if (const auto why = disk::writeFile(path, file.text)) return fail(*why);
    std::cout << (writes ? "written: " : "kept:    ") << syntax::printable(path.generic_string())
              << '\n';
  }
  return kDone;
}

std::vector<runtime::StubFile> stubsIn(StubLanguage language, const runtime::StubProgram& program) {
  switch (language) {
  case StubLanguage::Python: return runtime::pythonStubs(program);
  case StubLanguage::C: return runtime::cStubs(program);
  case StubLanguage::Cpp: return runtime::cppStubs(program);
  }
  return {};
}

int runStubs(const StubArguments& arguments) {
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  const auto read = runtime::stubProgram(*program, arguments.mainSkill);
  if (!read) return failGeneration(*program, read.error());
  return writeStubs(stubsIn(arguments.language, *read), arguments.directory);
}

void addStubOptions(CLI::App& command, StubArguments& arguments) {
  addChoice<StubLanguage>(
      command, "--language", arguments.language,
      {{"python", StubLanguage::Python}, {"c", StubLanguage::C}, {"cpp", StubLanguage::Cpp}},
      "The language of the functions");
  command.add_option("file", arguments.file, "Root file of the program")->required();
  command.add_option("directory", arguments.directory, "Output directory")->required();
  addMainSkill(command, arguments.mainSkill);
  addColour(command, arguments.colour);
}

} // namespace

void addStubs(CLI::App& app, int& exitCode) {
  auto& command = addCommand<StubArguments>(
      app, "stubs", "Write a typed function for each action of a program, to be filled in",
      addStubOptions, runStubs, exitCode);
  showBelow(command,
            {"proskill stubs mission.proskill robot",
             "proskill stubs --language cpp mission.proskill robot",
             "proskill run --platform robot/platform.json mission.proskill"},
            {{kDone, "the functions were written; your own code was not changed"},
             {kFailed, "the command line, a file or the program is wrong; nothing was written"}});
}

} // namespace proskill::cli
