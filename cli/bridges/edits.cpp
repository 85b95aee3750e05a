#include "cli/bridges/edits.h"

#include "syntax/document.h"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <vector>

namespace proskill::cli {
namespace {

constexpr std::string_view kDigests = "; digests of the import: ";
constexpr std::string_view kWhiteSpace = " \t\n\v\f\r";

/// A definition with the comments before it.
struct Part {
  std::string digest;
  std::string name; ///< `defskill drive`, or the text of a definition without a name
  syntax::Position position;
};

/// The text with one space for each white space.
std::string wordsOf(std::string_view text) {
  std::string words;
  std::istringstream stream{std::string(text)};
  for (std::string word; stream >> word;) words += word + ' ';
  return words;
}

std::string digestOf(std::string_view text) { return syntax::digestOf(wordsOf(text)).substr(0, 8); }

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

std::set<std::string> digestsIn(const std::string& program) {
  std::set<std::string> digests;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(kDigests)) continue;
    std::istringstream words(line.substr(kDigests.size()));
    for (std::string word; words >> word;) digests.insert(word);
  }
  return digests;
}

struct Addition {
  syntax::Position position;
  std::string_view what;
};

/// What follows the last definition, without the digests.
std::vector<Addition> additionsAtEnd(const std::string& program) {
  std::vector<Addition> additions;
  const auto document = syntax::Document::parse(program);
  const auto end = document.forms().empty() ? 0 : document.forms().back().range.end;
  auto rest = program;
  for (const auto& comment : document.comments()) {
    if (comment.begin < end) continue;
    rest.replace(comment.begin, comment.length(), comment.length(), ' ');
    if (!std::string_view(program).substr(comment.begin).starts_with(kDigests))
      additions.push_back({document.lines().position(comment.begin), "a comment"});
  }
  if (const auto text = rest.find_first_not_of(kWhiteSpace, end); text != std::string::npos)
    additions.push_back({document.lines().position(static_cast<syntax::Offset>(text)), "text"});
  return additions;
}

/// What was added, edited or removed since an import that wrote these digests.
bridge::Errors editsSince(const std::set<std::string>& before, const std::string& existing,
                          const std::string& imported, const std::filesystem::path& path) {
  auto known = before;
  std::set<std::string> names;
  for (const auto& part : partsOf(imported)) {
    known.insert(part.digest);
    names.insert(part.name);
  }
  bridge::Errors edits;
  const auto lost = [&](const syntax::Position& at, const std::string& what) {
    edits.push_back(
        {{path, at.line + 1, at.column + 1}, what + ", which another import would undo"});
  };
  std::set<std::string> kept; // once each, even if there are copies
  for (const auto& part : partsOf(existing)) {
    const bool isKnown = known.contains(part.digest);
    const bool isEdited = !isKnown && names.contains(part.name);
    if (isKnown || isEdited) kept.insert(isKnown ? part.digest : part.name);
    if (!isKnown)
      lost(part.position,
           fmt::format("`{}` was {} here", part.name, isEdited ? "edited" : "added"));
  }
  for (const auto& [at, what] : additionsAtEnd(existing))
    lost(at, fmt::format("{} was added here", what));
  if (kept.size() < before.size())
    lost({}, fmt::format("{} of its definitions were removed", before.size() - kept.size()));
  return edits;
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
  const auto words = wordsOf(existing);
  if (words.empty() || words == wordsOf(imported)) return {};
  const auto before = digestsIn(existing);
  if (before.empty())
    return {{{path},
             "the file has no digests of an import, so it is unknown whether it was edited. "
             "Replace it by `--force`"}};
  auto edits = editsSince(before, existing, imported, path);
  if (!edits.empty())
    edits.back().message += fmt::format(
        ". Move additions to a program that includes `{}`, or undo all of it by `--force`",
        path.filename().string());
  return edits;
}

} // namespace proskill::cli
