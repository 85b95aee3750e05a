#include "ide/fiacre/fiacre_rename.h"

#include "fiacre/syntax/words.h"
#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"
#include "syntax/text/edit.h"
#include "syntax/text/quote.h"

#include <fmt/format.h>

#include <set>
#include <utility>

namespace proskill::ide {

using syntax::Range;

namespace {

std::string renamed(std::string_view text, const std::vector<Range>& places,
                    std::string_view newName) {
  std::vector<syntax::TextEdit> edits;
  for (const auto place : places) edits.push_back({place, std::string(newName)});
  return syntax::applyEdits(text, edits);
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// An error in the renamed model that the original does not have, apart from the name in the
/// message; empty if there is none.
std::string newlyWrong(std::string_view before, const std::string& after, std::string_view oldName,
                       std::string_view newName) {
  const auto known = readFiacre("before.fcr", std::string(before)).diagnostics;
  const auto found = readFiacre("after.fcr", after).diagnostics;
  if (found.size() <= known.size()) return {};
  std::multiset<std::string> old;
  for (const auto& each : known)
    old.insert(replaced(each.message, syntax::backquoted(oldName), syntax::backquoted(newName)));
  for (const auto& each : found) {
    const auto same = old.find(each.message);
    if (same == old.end()) return each.message;
    old.erase(same);
  }
  std::unreachable();
}

} // namespace

std::expected<Range, std::string> renameableInFiacre(std::string_view text, syntax::Offset at) {
  for (const auto& use : FiacreText(text).uses(at, true))
    if (use.range.begin <= at && at <= use.range.end) return use.range;
  return std::unexpected("not a name that is declared in this text");
}

std::expected<std::vector<Range>, std::string>
renameInFiacre(std::string_view text, syntax::Offset at, std::string_view newName) {
  if (!fiacre::isIdentifier(newName))
    return std::unexpected(fmt::format("`{}` is not a name: use letters, digits and `_`", newName));
  if (fiacre::isKeyword(newName))
    return std::unexpected(fmt::format("`{}` is a keyword of Fiacre", newName));
  const FiacreText read(text);
  std::vector<Range> places;
  for (const auto& use : read.uses(at, true)) places.push_back(use.range);
  if (places.empty()) return std::unexpected("not a name that is declared in this text");
  const auto after = renamed(text, places, newName);
  if (FiacreText(after).meanings() != read.meanings())
    return std::unexpected(fmt::format("`{}` is used: a name would get another meaning", newName));
  const auto oldName = text.substr(places.front().begin, places.front().length());
  if (const auto wrong = newlyWrong(text, after, oldName, newName); !wrong.empty())
    return std::unexpected(fmt::format("the model would have an error: {}", wrong));
  return places;
}

} // namespace proskill::ide
