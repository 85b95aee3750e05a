#include "bridge/rl/import.h"

#include "bridge/rl/compose.h"
#include "bridge/rl/read/read.h"
#include "bridge/rl/translate.h"

#include <fmt/format.h>

namespace proskill::bridge::rl {
namespace {

std::string verdictLine(bool exact, bool isLibrary) {
  if (!isLibrary)
    return "verdicts are about the composites as docs/import.md defines their operators, which "
           "have no published meaning; skills take any time, and events may occur whenever their "
           "guards hold";
  if (exact)
    return "verdicts are exact for these skillsets: any skill may be called at any time and takes "
           "any time, and events may occur whenever their guards hold";
  return "verdicts are over-approximate: what holds or is unreachable in the program is so for the "
         "skillsets; a violation may be one of the program alone";
}

} // namespace

std::expected<Imported, Errors> importSkillsets(const analysis::FileSystem& files,
                                                const std::filesystem::path& root,
                                                const std::filesystem::path& folder) {
  const auto parsed = read(files, root);
  if (!parsed) return std::unexpected(parsed.error());
  Translation translation(folder, parsed->skillsets.size() > 1);
  for (const auto& skillset : parsed->skillsets) translation.add(skillset);
  addComposites(translation, parsed->skillsets, parsed->composites);
  if (!translation.errors.empty()) return std::unexpected(std::move(translation.errors));
  const auto head = fmt::format("The skillsets of {}, by `proskill import rl`.",
                                root.filename().generic_string());
  Imported imported{write(head, translation.program()), translation.notes.empty(), {}};
  imported.summary = translation.omitted();
  const auto add = [&](const std::vector<Note>& notes, std::string_view what) {
    for (const auto& [place, message] : notes)
      imported.summary.push_back(fmt::format("{}: {}: {}", asText(place, {}), what, message));
  };
  add(translation.unverified, "not verified");
  add(translation.notes, "approximated");
  if (imported.exact && translation.interrupts > 0)
    imported.summary.emplace_back("that a skill can be interrupted is also reachable between its "
                                  "call and its start, which RL does not distinguish");
  imported.summary.push_back(verdictLine(imported.exact, parsed->composites.empty()));
  return imported;
}

} // namespace proskill::bridge::rl
