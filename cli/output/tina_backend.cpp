#include "cli/output/tina_backend.h"

#include "cli/terminal/choice.h"
#include "cli/terminal/progress.h"

#include <fmt/format.h>

#include <cstdlib>

namespace proskill::cli {

namespace {

std::optional<std::string> variable(const std::string& name) {
  const char* value = std::getenv(name.c_str());
  return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
}

/// `PROSKILL_FRAC` for `frac`.
std::string variableOf(std::string tool) {
  for (char& c : tool) c = static_cast<char>(c - 'a' + 'A');
  return "PROSKILL_" + tool;
}

std::string list(const std::vector<std::string>& missing) {
  std::string text = "Tina is not complete here:";
  for (const auto& item : missing) text += "\n  - " + item;
  return text;
}

tina::Options optionsOf(const BackendArguments& arguments, tina::Tools tools,
                        const verify::Options& options, ProgressLine& progress) {
  tina::Options made{
      .tools = std::move(tools), .limits = options.limits, .cancelled = options.cancelled};
  if (!arguments.keep.empty()) made.keep = arguments.keep;
  made.progress = [&progress](const tina::Progress& now) {
    std::string line(now.line);
    std::erase_if(line, [](unsigned char c) { return c < ' ' || c == 0x7f; });
    progress.say(fmt::format("{}, {:.0f} s  {:.60}", now.tool, now.seconds, line));
  };
  return made;
}

} // namespace

void addBackend(CLI::App& command, BackendArguments& arguments) {
  addChoice<Backend>(
      command, "--backend", arguments.backend,
      {{"engine", Backend::Engine}, {"tina", Backend::Tina}, {"both", Backend::Both}},
      "Verify with the built-in engine, with the Tina tools, or with both and compare",
      group::kBackends);
  auto& tools = arguments.tools;
  for (auto [name, path] : {std::pair("--frac", &tools.frac), std::pair("--sift", &tools.sift),
                            std::pair("--tina", &tools.tina), std::pair("--selt", &tools.selt),
                            std::pair("--ktzio", &tools.ktzio)})
    show(command.add_option(name, *path,
                            std::string("Path of `") + (name + 2) + "` (default: the variable " +
                                variableOf(name + 2) + ", else PATH)"),
         group::kBackends, "PROGRAM");
  show(command.add_option("--cc", tools.cc, "Path of a C compiler (default: CC, else `cc`)"),
       group::kBackends, "PROGRAM");
  show(command.add_option("--fraclib", tools.fraclib,
                          "Directory of frac's headers (default: the variable FRACLIB)"),
       group::kBackends, "DIRECTORY");
  show(command.add_option("--keep", arguments.keep,
                          "Run the tools in this new directory, and keep their files"),
       group::kBackends, "DIRECTORY");
  show(command.add_option("--difference", arguments.difference,
                          "both: write a report of differences to this file (default "
                          "proskill-difference.md)"),
       group::kBackends, "FILE");
}

std::expected<TinaRun, std::string> runTina(const BackendArguments& arguments,
                                            const codegen::Model& model,
                                            const std::vector<std::string>& properties,
                                            const verify::Options& options) {
  auto tools = tina::findTools(arguments.tools, variable);
  if (!tools) return std::unexpected(list(tools.error()));
  ProgressLine progress;
  const auto asked = ide::askedOf(model, properties);
  auto outcome = tina::verify(model.fiacre, model.provenance, asked.questions,
                              optionsOf(arguments, *tools, options, progress));
  if (!outcome) return TinaRun{*tools, std::unexpected(std::move(outcome.error()))};
  auto report = ide::reportOf(model, asked, outcome->result);
  return TinaRun{*tools, TinaReport{std::move(report), std::move(*outcome)}};
}

} // namespace proskill::cli
