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
      "Who verifies: the engine, Tina, or both, which are compared");
  auto& tools = arguments.tools;
  command.add_option("--frac", tools.frac, "Where `frac` is; else PROSKILL_FRAC, else the PATH");
  command.add_option("--sift", tools.sift, "Where `sift` is, likewise");
  command.add_option("--tina", tools.tina, "Where `tina` is, to be used in place of `sift`");
  command.add_option("--selt", tools.selt, "Where `selt` is, likewise");
  command.add_option("--ktzio", tools.ktzio, "Where `ktzio` is, likewise");
  command.add_option("--cc", tools.cc, "A compiler of C; else CC, else `cc` on the PATH");
  command.add_option("--fraclib", tools.fraclib, "The directory FRACLIB; else the variable");
  command.add_option("--keep", arguments.keep,
                     "Run Tina in this fresh directory, and leave its files there");
  command.add_option("--difference", arguments.difference,
                     "both: write what differs into this file");
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
