#include "cli/commands/commands.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/choice.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/help.h"
#include "cli/terminal/paint.h"
#include "cli/terminal/picture_kinds.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "viz/pictures.h"
#include "viz/render.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <unistd.h>

namespace proskill::cli {
namespace {

const Choices<viz::Format> kFormats{
    {"dot", viz::Format::Dot}, {"svg", viz::Format::Svg}, {"png", viz::Format::Png}};

struct GraphArguments {
  std::string file;
  std::optional<viz::Kind> kind;
  std::string name;
  std::optional<viz::Format> format;
  bool dark = false;
  bool forbidden = false;
  std::string output;
  std::string directory;
  ColourChoice colour = ColourChoice::Auto;
};

template <class Value> Choices<std::optional<Value>> optional(const Choices<Value>& choices) {
  return {choices.begin(), choices.end()};
}

/// The requested format, else that of the output's extension, else SVG.
viz::Format formatOf(const GraphArguments& arguments) {
  if (arguments.format) return *arguments.format;
  const auto extension = std::filesystem::path(arguments.output).extension().string();
  for (const auto& [name, format] : kFormats)
    if (extension == "." + name) return format;
  return viz::Format::Svg;
}

/// The pictures that the arguments select; by default the call graph, unless all are wanted.
std::vector<viz::Request> choose(const analysis::Program& program,
                                 const GraphArguments& arguments) {
  std::vector<viz::Request> chosen;
  if (arguments.kind && !arguments.name.empty()) {
    chosen = {{*arguments.kind, arguments.name, false}};
  } else if (arguments.kind) {
    chosen = viz::allPictures(program, *arguments.kind);
  } else if (!arguments.name.empty()) {
    chosen = viz::allPictures(program);
    std::erase_if(chosen, [&](const auto& request) { return request.name != arguments.name; });
  } else {
    chosen = arguments.directory.empty() ? viz::allPictures(program, viz::Kind::Calls)
                                         : viz::allPictures(program);
  }
  for (auto& request : chosen) request.forbidden = arguments.forbidden;
  return chosen;
}

std::expected<std::string, std::string> picture(const analysis::Program& program,
                                                const GraphArguments& arguments,
                                                const viz::Request& request) {
  const auto graph = viz::draw(program, request);
  if (!graph) return std::unexpected(graph.error());
  return viz::render(*graph, formatOf(arguments),
                     arguments.dark ? viz::Scheme::Dark : viz::Scheme::Light);
}

std::string nameOf(const viz::Request& request) {
  const auto& kind = wordOf(kPictureKinds, request.kind);
  return request.name.empty() ? kind : kind + "_" + request.name;
}

/// Writes one file per picture, and prints their paths.
int drawAll(const analysis::Program& program, const GraphArguments& arguments,
            const std::vector<viz::Request>& requests) {
  const std::filesystem::path directory(arguments.directory);
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    return fail(
        fmt::format("cannot create the directory {}: {}", arguments.directory, error.message()));
  for (const auto& request : requests) {
    const auto bytes = picture(program, arguments, request);
    if (!bytes) return fail(bytes.error());
    const auto path = directory / (nameOf(request) + "." + wordOf(kFormats, formatOf(arguments)));
    if (const auto failed = disk::writeOutput(path, *bytes)) return fail(*failed);
    std::cout << forOutput(path.string()) << '\n';
  }
  return kDone;
}

int drawOne(const analysis::Program& program, const GraphArguments& arguments,
            const viz::Request& request) {
  const bool standard = arguments.output.empty() || arguments.output == "-";
  if (standard && formatOf(arguments) == viz::Format::Png && isatty(STDOUT_FILENO) != 0)
    return fail("a PNG cannot be shown in a terminal; name a file with `-o`");
  const auto bytes = picture(program, arguments, request);
  if (!bytes) return fail(bytes.error());
  const auto failed = disk::writeOutput(arguments.output, *bytes);
  return failed ? fail(*failed) : kDone;
}

std::string listOf(const std::vector<viz::Request>& requests) {
  std::string names;
  for (const auto& request : requests) names += (names.empty() ? "" : ", ") + request.name;
  return names;
}

int runGraph(const GraphArguments& arguments) {
  if (disk::replaces(arguments.output, arguments.file))
    return fail("`-o` names the file that is read");
  const auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return kFailed;
  const auto requests = choose(*program, arguments);
  if (requests.empty())
    return fail(arguments.name.empty()
                    ? std::string("the program has nothing of this kind")
                    : fmt::format("there is no picture of `{}`", arguments.name));
  if (!arguments.directory.empty()) return drawAll(*program, arguments, requests);
  if (requests.size() > 1)
    return fail("say which one with `--name`, or draw all into a directory with `--out-dir`: " +
                listOf(requests));
  return drawOne(*program, arguments, requests.front());
}

} // namespace

void addGraph(CLI::App& app, int& exitCode) {
  auto arguments = std::make_shared<GraphArguments>();
  auto* command = app.add_subcommand("graph", "Draw state variables, skills, bodies and calls");
  command->add_option("file", arguments->file, "Root file of the program")->required();
  addChoice(*command, "--kind", arguments->kind, optional(kPictureKinds),
            "A state variable, an event, a skill, the body of a skill, or who calls whom",
            group::kSubject);
  show(command->add_option("--name", arguments->name,
                           "Which state variable, event, skill or environment to draw"),
       group::kSubject, "NAME");
  show(command->add_flag("--forbidden", arguments->forbidden,
                         "Draw the forbidden moves of state variables too"),
       group::kSubject);
  addChoice(*command, "--format", arguments->format, optional(kFormats),
            "Image format (default: by the name of the output, else svg)");
  auto* directory = show(command->add_option("--out-dir", arguments->directory,
                                             "Draw everything, one file each, into this directory"),
                         group::kOutput, "DIRECTORY");
  show(command
           ->add_option("-o,--output", arguments->output,
                        "Write to this file instead of standard output")
           ->excludes(directory),
       group::kOutput, "FILE");
  show(command->add_flag("--dark", arguments->dark, "Colours for a dark background"),
       group::kOutput);
  addColour(*command, arguments->colour);
  showBelow(*command,
            {"proskill graph --kind body --name land -o land.svg mission.proskill",
             "proskill graph --out-dir pictures mission.proskill"},
            {{kDone, "drawn"},
             {kFailed, "the program has errors, or the command line or the output is wrong"}});
  command->callback([arguments, &exitCode] { exitCode = runGraph(*arguments); });
}

} // namespace proskill::cli
