#include "cli/execution/commands.h"

#include "cli/output/checked_program.h"
#include "cli/output/stub_files.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "runtime/stubs/stubs.h"

#include <CLI/CLI.hpp>

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
  return writeStubFiles(stubsIn(arguments.language, *read), arguments.directory);
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
