#include "cli/commands/generated.h"

#include "cli/commands/front_limits.h"
#include "cli/output/checked_program.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "cli/terminal/number.h"

#include <fmt/format.h>

#include <utility>

namespace proskill::cli {

namespace {

/// frac needs an edition that it interprets as we do: see docs/semantics.md.
codegen::Edition editionFor(const VerifyArguments& arguments) {
  if (arguments.backend.backend != Backend::Engine) return codegen::Edition::Tina;
  return arguments.expanded ? codegen::Edition::Expanded : codegen::Edition::Compact;
}

/// Reads a program and generates its model. The error is the exit code of one that was printed.
std::expected<Generated, int> readAndGenerate(const VerifyArguments& arguments) {
  auto program = loadChecked(arguments.file, arguments.colour);
  if (!program) return std::unexpected(kFailed);
  codegen::Options options;
  options.mainSkill = arguments.mainSkill;
  options.edition = editionFor(arguments);
  options.automata = arguments.automata;
  options.fairRuns = arguments.fairRuns;
  auto model = codegen::generate(*program, options);
  if (!model) return std::unexpected(failGeneration(*program, model.error()));
  return Generated{std::move(*program), std::move(*model)};
}

} // namespace

std::expected<Generated, int> generated(const VerifyArguments& arguments) {
  if (arguments.ranks) return readAndGenerate(arguments);
  FrontLimits limits{.begun = arguments.begun, .seconds = arguments.timeLimit, .bytes = {}};
  if (arguments.memoryLimit) limits.bytes = bytesOfMiB(*arguments.memoryLimit);
  std::expected<Generated, int> made = std::unexpected(kInconclusive);
  const auto met = withinLimits(limits, [&] { made = readAndGenerate(arguments); });
  if (met)
    fail(fmt::format("nothing was decided: {} while the model was generated; `{}` raises it",
                     met->limit, met->option));
  return made;
}

} // namespace proskill::cli
