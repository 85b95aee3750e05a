#include "ide/fiacre_rename.h"

#include "fiacre/words.h"
#include "ide/fiacre_file.h"
#include "ide/fiacre_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::ide {

using syntax::Range;

namespace {

std::string renamed(std::string_view text, const std::vector<Range>& places,
                    std::string_view newName) {
  std::string made;
  std::size_t at = 0;
  for (const auto& place : places) {
    made += text.substr(at, place.begin - at);
    made += newName;
    at = place.end;
  }
  made += text.substr(at);
  return made;
}

/// What is wrong with a text that is not wrong with the one before.
std::string newlyWrong(std::string_view before, const std::string& after) {
  const auto known = readFiacre("before.fcr", std::string(before)).diagnostics;
  const auto found = readFiacre("after.fcr", after).diagnostics;
  return found.size() <= known.size() ? "" : found.back().message;
}

} // namespace

std::expected<Range, std::string> renameableInFiacre(std::string_view text, syntax::Offset at) {
  for (const auto& use : FiacreText(text).uses(at, true))
    if (use.range.begin <= at && at <= use.range.end) return use.range;
  return std::unexpected("there is no name here that this text declares");
}

std::expected<std::vector<Range>, std::string>
renameInFiacre(std::string_view text, syntax::Offset at, std::string_view newName) {
  if (!fiacre::isIdentifier(newName))
    return std::unexpected(fmt::format("`{}` is no name: letters, digits and `_`", newName));
  if (fiacre::isReserved(newName))
    return std::unexpected(fmt::format("`{}` means something to Fiacre", newName));
  const FiacreText read(text);
  std::vector<Range> places;
  for (const auto& use : read.uses(at, true)) places.push_back(use.range);
  if (places.empty()) return std::unexpected("there is no name here that this text declares");
  const auto after = renamed(text, places, newName);
  if (FiacreText(after).meanings() != read.meanings())
    return std::unexpected(
        fmt::format("`{}` is taken: some name would mean something else than before", newName));
  if (const auto wrong = newlyWrong(text, after); !wrong.empty())
    return std::unexpected(fmt::format("the model would be wrong: {}", wrong));
  return places;
}

} // namespace proskill::ide
