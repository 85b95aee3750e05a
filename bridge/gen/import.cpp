#include "bridge/gen/import.h"

#include "bridge/gen/read/read.h"
#include "bridge/gen/translate.h"

#include <fmt/format.h>

namespace proskill::bridge::gen {
namespace {

std::string verdictLine(bool exact) {
  if (exact)
    return "verdicts are exact for what the file declares: a service may end in any way that it "
           "declares, after any time that the file of leaves allows";
  return "verdicts are about the program, which differs from the components in these points";
}

} // namespace

std::expected<Imported, Errors> importComponents(const analysis::FileSystem& files,
                                                 const std::filesystem::path& root,
                                                 const Leaves& leaves,
                                                 const std::filesystem::path& folder) {
  const auto components = read(files, root);
  if (!components) return std::unexpected(components.error());
  Translation translation(leaves, folder, components->all.size() > 1);
  for (const auto& component : components->all) translation.add(component);
  const auto head = fmt::format("The services of {}, by `proskill import gen`.",
                                root.filename().generic_string());
  Imported imported{write(head, translation.program()),
                    translation.notes.empty() && components->missing.empty() &&
                        components->ignored.empty(),
                    translation.omitted()};
  for (const auto& [message, place] : components->missing)
    imported.summary.push_back(
        fmt::format("{}: {}: services of its interfaces are missing", asText(place, {}), message));
  for (const auto& [directive, place] : components->ignored)
    imported.summary.push_back(
        fmt::format("{}: approximated: `{}` is ignored: all branches are imported, and macros are "
                    "not replaced",
                    asText(place, {}), directive));
  for (const auto& name : leaves.unused())
    imported.summary.push_back(
        fmt::format("no service is called `{}`, of which the file of leaves speaks", name));
  for (const auto& [place, message] : translation.notes)
    imported.summary.push_back(fmt::format("{}: approximated: {}", asText(place, {}), message));
  imported.summary.push_back(verdictLine(imported.exact));
  return imported;
}

} // namespace proskill::bridge::gen
