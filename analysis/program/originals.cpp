#include "analysis/program/originals.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace proskill::analysis {
namespace {

constexpr std::size_t kNone = ~std::size_t{0};

/// A number at the beginning of a text, which is removed.
std::optional<std::uint32_t> takeNumber(std::string_view& text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number == 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// Reads `:LINE:COLUMN WHAT`.
std::optional<Original> restOf(std::string_view text) {
  text.remove_prefix(1);
  const auto line = takeNumber(text);
  if (!line || !text.starts_with(':')) return std::nullopt;
  text.remove_prefix(1);
  const auto column = takeNumber(text);
  if (!column || (!text.empty() && text.front() != ' ')) return std::nullopt;
  if (!text.empty()) text.remove_prefix(1);
  return Original{{}, *line, *column, std::string(text)};
}

/// The original that a comment names, if it does.
std::optional<Original> originalIn(std::string_view comment) {
  constexpr std::string_view kHead = "; from ";
  if (!comment.starts_with(kHead)) return std::nullopt;
  const auto text = comment.substr(kHead.size());
  for (auto colon = text.find(':', 1); colon != text.npos; colon = text.find(':', colon + 1)) {
    auto found = restOf(text.substr(colon));
    if (!found) continue;
    found->file = std::string(text.substr(0, colon));
    return found;
  }
  return std::nullopt;
}

std::size_t endOfString(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at)
    if (text[at] == '\\') ++at;
  return at;
}

} // namespace

Originals::Originals(std::string_view text) {
  if (text.find("; from ") == text.npos) return;
  std::vector<std::size_t> open; // lists: their parts, or kNone
  std::size_t around = kNone;
  std::optional<Original> above;
  const auto size = static_cast<syntax::Offset>(text.size());
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    if (c == ';') {
      const auto end = std::min(text.find('\n', at), text.size());
      auto comment = text.substr(at, end - at);
      if (comment.ends_with('\r')) comment.remove_suffix(1);
      if (auto found = originalIn(comment)) above = std::move(found);
      at = end;
      continue;
    }
    if (c == '(') {
      open.push_back(kNone);
      if (auto origin = std::exchange(above, std::nullopt)) {
        open.back() = parts.size();
        parts.push_back({{static_cast<syntax::Offset>(at), size}, around, *std::move(origin)});
        around = open.back();
      }
    } else if (c == ')' && !open.empty()) {
      if (open.back() != kNone) {
        parts[open.back()].range.end = static_cast<syntax::Offset>(at + 1);
        around = parts[open.back()].parent;
      }
      open.pop_back();
    } else if (c == '"') {
      at = endOfString(text, at);
    }
    above.reset();
  }
}

const Original* Originals::at(syntax::Offset offset) const {
  const auto after = std::ranges::upper_bound(parts, offset, {},
                                              [](const Part& part) { return part.range.begin; });
  auto part = after == parts.begin() ? kNone : static_cast<std::size_t>(after - parts.begin()) - 1;
  while (part != kNone && !parts[part].range.contains(offset)) part = parts[part].parent;
  return part == kNone ? nullptr : &parts[part].original;
}

std::optional<Original> ProgramOriginals::of(Location location) {
  const auto& file = program.files[location.file];
  auto originals = known.find(location.file);
  if (originals == known.end())
    originals = known.try_emplace(location.file, file.document.text()).first;
  const Original* found = originals->second.at(location.range.begin);
  if (!found) return std::nullopt;
  Original seen = *found;
  seen.file = (file.path.parent_path() / found->file).lexically_normal();
  return seen;
}

std::string toString(const Original& original) {
  auto text = original.file.generic_string() + ":" + std::to_string(original.line) + ":" +
              std::to_string(original.column);
  return original.what.empty() ? text : text + " " + original.what;
}

} // namespace proskill::analysis
