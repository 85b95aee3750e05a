#include "cli/bridges/edits.h"

#include "syntax/document.h"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <vector>

namespace proskill::cli {
namespace {

constexpr std::string_view kDigests = "; digests of the import: ";
/// A definition with the comments before it.
struct Part {
  std::string digest;
  std::string name; ///< `defskill drive`, or the text of a definition without a name
  syntax::Position position;
};

std::string digestOf(std::string_view text) {
  std::string words;
  std::istringstream stream{std::string(text)};
  for (std::string word; stream >> word;) words += word + ' ';
  return syntax::digestOf(words).substr(0, 8);
}

std::vector<Part> partsOf(const std::string& program) {
  std::vector<Part> parts;
  const auto document = syntax::Document::parse(program);
  syntax::Offset end = 0;
  for (const auto& form : document.forms()) {
    const auto name = form.name.text.empty()
                          ? program.substr(form.range.begin, form.range.length())
                          : fmt::format("{} {}", form.keyword.text, form.name.text);
    const auto whole = std::string_view(program).substr(end, form.range.end - end);
    parts.push_back({digestOf(whole), name, document.lines().position(form.range.begin)});
    end = form.range.end;
  }
  return parts;
}

std::vector<std::string> digestsIn(const std::string& program) {
  std::vector<std::string> digests;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(kDigests)) continue;
    std::istringstream words(line.substr(kDigests.size()));
    for (std::string word; words >> word;) digests.push_back(word);
  }
  return digests;
}

/// The comments after the last definition, without the digests.
std::vector<syntax::Position> commentsAtEnd(const std::string& program) {
  std::vector<syntax::Position> comments;
  const auto document = syntax::Document::parse(program);
  const auto end = document.forms().empty() ? 0 : document.forms().back().range.end;
  for (const auto& comment : document.comments())
    if (comment.begin >= end &&
        !std::string_view(program).substr(comment.begin).starts_with(kDigests))
      comments.push_back(document.lines().position(comment.begin));
  return comments;
}

} // namespace

std::string withDigests(const std::string& imported) {
  constexpr std::size_t kInLine = 8;
  auto text = imported + '\n';
  const auto parts = partsOf(imported);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += i % kInLine == 0 ? std::string(kDigests) : " ";
    text += parts[i].digest;
    if (i % kInLine == kInLine - 1 || i + 1 == parts.size()) text += '\n';
  }
  return text;
}

bridge::Errors editsIn(const std::string& existing, const std::string& imported,
                       const std::filesystem::path& path) {
  const auto before = digestsIn(existing);
  std::set<std::string> known(before.begin(), before.end());
  std::set<std::string> names;
  for (const auto& part : partsOf(imported)) {
    known.insert(part.digest);
    names.insert(part.name);
  }
  bridge::Errors edits;
  const auto lost = [&](const syntax::Position& at, std::string what) {
    edits.push_back({{path, at.line + 1, at.column + 1}, std::move(what)});
  };
  std::size_t kept = 0;
  for (const auto& part : partsOf(existing)) {
    const bool isKnown = known.contains(part.digest);
    const bool isEdited = !isKnown && names.contains(part.name);
    if (isKnown || isEdited) ++kept;
    if (!isKnown)
      lost(part.position,
           fmt::format("`{}` was {} here", part.name, isEdited ? "edited" : "added"));
  }
  for (const auto& at : commentsAtEnd(existing)) lost(at, "a comment was added here");
  if (kept < before.size())
    lost({}, fmt::format("{} of its definitions were removed", before.size() - kept));
  return edits;
}

} // namespace proskill::cli
