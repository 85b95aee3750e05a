#include "tina/outputs.h"

#include <algorithm>
#include <charconv>
#include <regex>

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

/// Passes only the beginning of each line: searches match there, and must stay fast.
template <class Visit> void eachShortLine(std::string_view text, Visit visit) {
  constexpr std::size_t kMost = 300;
  eachLine(text, [&](std::string_view line) { visit(std::string(line.substr(0, kMost))); });
}

/// A number; the maximum if it is too large.
std::uint64_t count(const std::string& digits) {
  std::uint64_t value = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return read.ec == std::errc{} ? value : UINT64_MAX;
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
  static const std::regex kCounts(R"((\d+)\s+class\S*\s*,\s*(\d+)\s+marking\S*\s*,)"
                                  R"(\s*(\d+)\s+domain\S*\s*,\s*(\d+)\s+transition)");
  static const std::regex kDigest(R"(^(states|transitions)\s+(\d+))");
  std::optional<verify::Exploration> counts;
  std::optional<std::uint64_t> states;
  eachShortLine(output, [&](const std::string& line) {
    std::smatch match;
    if (std::regex_search(line, match, kCounts)) {
      counts = {.classes = count(match[1]),
                .markings = count(match[2]),
                .domains = count(match[3]),
                .transitions = count(match[4]),
                .complete = true};
    } else if (std::regex_search(line, match, kDigest)) {
      if (match[1] == "states")
        states = count(match[2]);
      else if (states && !counts)
        counts = {.classes = *states, .transitions = count(match[2]), .complete = true};
    }
  });
  return counts;
}

bool saysUnfinished(std::string_view output) {
  static const std::regex kWords(
      R"(\b(aborted|interrupted|incomplete|unbounded|exceeded|not completed)\b)",
      std::regex::icase);
  bool found = false;
  eachShortLine(output,
                [&](const std::string& line) { found = found || std::regex_search(line, kWords); });
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
