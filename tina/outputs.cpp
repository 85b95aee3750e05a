#include "tina/outputs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace proskill::tina {

namespace {

constexpr std::string_view kBlank = " \t\r\n";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) + 1 - first);
}

/// Calls `visit` with each line, without its end.
template <class Visit> void eachLine(std::string_view text, Visit visit) {
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    visit(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

std::string_view withoutComment(std::string_view line) { return line.substr(0, line.find('#')); }

std::string_view word(std::string_view text) {
  const auto start = text.find_first_not_of(kBlank);
  if (start == std::string_view::npos) return {};
  const auto end = std::min(text.find_first_of(kBlank, start), text.size());
  return text.substr(start, end - start);
}

bool isDefinition(std::string_view statement) {
  const auto first = word(statement);
  return first == "op" || first == "infix" || first == "prefix" || first == "postfix";
}

/// `name@3.5` or `name$2` without its date. A name in braces is kept as it is.
std::optional<std::string> withoutDate(std::string_view token) {
  const auto quoted = token.front() == '{' ? token.find('}') : 0;
  if (quoted == std::string_view::npos) return std::nullopt;
  const auto mark = token.find_first_of("@$", quoted);
  const auto name = token.substr(0, mark);
  if (name.empty()) return std::nullopt;
  if (mark == std::string_view::npos) return std::string(name);
  const auto date = token.substr(mark + 1);
  double value = 0;
  const auto read = std::from_chars(date.data(), date.data() + date.size(), value);
  if (read.ec != std::errc{} || read.ptr != date.data() + date.size() || value < 0)
    return std::nullopt;
  return std::string(name);
}

/// Passes only the beginning of each line: what is looked for is there, and a line may be as long
/// as an output.
template <class Visit> void eachShortLine(std::string_view text, Visit visit) {
  constexpr std::size_t kMost = 300;
  eachLine(text, [&](std::string_view line) { visit(line.substr(0, kMost)); });
}

constexpr std::string_view kDigits = "0123456789";

/// The length of the characters at the front that are among these.
std::size_t lengthOf(std::string_view among, std::string_view text) {
  return std::min(text.find_first_not_of(among), text.size());
}

/// A number; the maximum if it is too large.
std::uint64_t count(std::string_view digits) {
  std::uint64_t value = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return read.ec == std::errc{} ? value : UINT64_MAX;
}

/// The number at the front, and removes it.
std::optional<std::uint64_t> takeNumber(std::string_view& text) {
  const auto digits = text.substr(0, lengthOf(kDigits, text));
  if (digits.empty()) return std::nullopt;
  text.remove_prefix(digits.size());
  return count(digits);
}

/// Removes blanks from the front; false if there are none.
bool takeBlanks(std::string_view& text) {
  const auto blanks = lengthOf(kBlank, text);
  text.remove_prefix(blanks);
  return blanks > 0;
}

bool takeComma(std::string_view& text) {
  takeBlanks(text);
  if (!text.starts_with(',')) return false;
  text.remove_prefix(1);
  takeBlanks(text);
  return true;
}

/// The number of `12 classes(s)`, with any word that begins like the noun, and removes all of it.
std::optional<std::uint64_t> takeCount(std::string_view& text, std::string_view noun) {
  const auto number = takeNumber(text);
  if (!number || !takeBlanks(text) || !text.starts_with(noun)) return std::nullopt;
  text.remove_prefix(std::min(text.find_first_of(" \t\r,"), text.size()));
  return number;
}

/// `1 classes(s), 2 marking(s), 3 domain(s), 4 transition(s)` at the front.
std::optional<verify::Exploration> countsAtFront(std::string_view text) {
  const auto next = [&](std::string_view noun) {
    return takeComma(text) ? takeCount(text, noun) : std::nullopt;
  };
  const auto classes = takeCount(text, "class");
  const auto markings = classes ? next("marking") : std::nullopt;
  const auto domains = markings ? next("domain") : std::nullopt;
  const auto transitions = domains ? next("transition") : std::nullopt;
  if (!transitions) return std::nullopt;
  return verify::Exploration{.classes = *classes,
                             .markings = *markings,
                             .domains = *domains,
                             .transitions = *transitions,
                             .complete = true};
}

/// The same anywhere in the line.
std::optional<verify::Exploration> countsIn(std::string_view line) {
  for (auto at = line.find_first_of(kDigits); at < line.size();
       at = line.find_first_of(kDigits, at + lengthOf(kDigits, line.substr(at))))
    if (auto counts = countsAtFront(line.substr(at))) return counts;
  return std::nullopt;
}

/// The number after the first word of a line, if that is this one.
std::optional<std::uint64_t> numberAfter(std::string_view first, std::string_view line) {
  if (!line.starts_with(first)) return std::nullopt;
  line.remove_prefix(first.size());
  return takeBlanks(line) ? takeNumber(line) : std::nullopt;
}

bool isPartOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Whether a text has these words, between others.
bool hasWords(std::string_view text, std::string_view words) {
  for (auto at = text.find(words); at != std::string_view::npos; at = text.find(words, at + 1)) {
    const auto end = at + words.size();
    const bool begins = at == 0 || !isPartOfWord(text[at - 1]);
    if (begins && (end == text.size() || !isPartOfWord(text[end]))) return true;
  }
  return false;
}

} // namespace

LtlFile readLtl(std::string_view text) {
  std::string bare;
  eachLine(text, [&](std::string_view line) {
    bare += withoutComment(line);
    bare += '\n';
  });
  LtlFile file;
  for (std::size_t at = 0, end = 0; at < bare.size(); at = end + 1) {
    end = std::min(bare.find(';', at), bare.size());
    const auto statement = trimmed(std::string_view(bare).substr(at, end - at));
    if (statement.empty()) continue;
    if (isDefinition(statement))
      file.definitions += std::string(statement) + ";\n";
    else
      file.queries.emplace_back(statement);
  }
  return file;
}

std::optional<verify::Exploration> readCounts(std::string_view output) {
  std::optional<verify::Exploration> counts;
  std::optional<std::uint64_t> states;
  eachShortLine(output, [&](std::string_view line) {
    if (const auto here = countsIn(line))
      counts = here;
    else if (const auto number = numberAfter("states", line))
      states = number;
    else if (const auto transitions = numberAfter("transitions", line);
             transitions && states && !counts)
      counts = {.classes = *states, .transitions = *transitions, .complete = true};
  });
  return counts;
}

bool saysUnfinished(std::string_view output) {
  constexpr auto kWords = std::to_array<std::string_view>(
      {"aborted", "interrupted", "incomplete", "unbounded", "exceeded", "not completed"});
  bool found = false;
  eachShortLine(output, [&](std::string_view line) {
    std::string lower(line);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    found = found || std::ranges::any_of(
                         kWords, [&](std::string_view words) { return hasWords(lower, words); });
  });
  return found;
}

std::optional<std::vector<bool>> readVerdicts(std::string_view output, std::size_t expected) {
  std::vector<bool> verdicts;
  eachLine(output, [&](std::string_view line) {
    line = trimmed(line);
    for (const std::string_view truth : {"TRUE", "FALSE"}) {
      if (!line.ends_with(truth)) continue;
      const auto before = line.substr(0, line.size() - truth.size());
      if (before.empty() || std::string_view(" \t:=").find(before.back()) != std::string_view::npos)
        verdicts.push_back(truth == "TRUE");
    }
  });
  if (verdicts.size() != expected) return std::nullopt;
  return verdicts;
}

std::optional<std::vector<std::string>> readScenario(std::string_view text) {
  std::vector<std::string> names;
  bool sound = true;
  eachLine(text, [&](std::string_view line) {
    if (trimmed(line).starts_with('#')) return;
    for (auto token = word(line); !token.empty(); token = word(line)) {
      line.remove_prefix(static_cast<std::size_t>(token.data() + token.size() - line.data()));
      auto name = withoutDate(token);
      sound = sound && name;
      if (name) names.push_back(std::move(*name));
    }
  });
  if (!sound || names.empty()) return std::nullopt;
  return names;
}

std::vector<std::string> readCounterexample(std::string_view output) {
  std::vector<std::string> names;
  eachLine(output, [&](std::string_view line) {
    line = trimmed(line);
    if (!line.starts_with('-') || !line.ends_with("->")) return;
    const auto name = word(line.substr(1, line.size() - 3));
    if (!name.empty() && !name.starts_with("L.")) names.emplace_back(name);
  });
  return names;
}

} // namespace proskill::tina
