#include "tina/ktz_text.h"

#include <charconv>
#include <istream>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace proskill::tina {

namespace {

template <class Number> std::optional<Number> number(std::string_view text) {
  Number value{};
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || read.ec != std::errc{} || read.ptr != text.data() + text.size())
    return std::nullopt;
  return value;
}

class Numbering {
public:
  explicit Numbering(std::vector<std::string>& to) : names(to) {}
  std::uint32_t of(std::string_view name) {
    auto [entry, added] = known.try_emplace(std::string(name), names.size());
    if (added) names.emplace_back(name);
    return entry->second;
  }

private:
  std::vector<std::string>& names;
  std::unordered_map<std::string, std::uint32_t> known;
};

/// The next word of a line; blanks within braces belong to it.
std::string_view next(std::string_view& line) {
  const auto start = line.find_first_not_of(" \t\r");
  if (start == std::string_view::npos) return {};
  std::size_t end = start;
  for (bool quoted = false; end < line.size(); ++end) {
    if (line[end] == '{') quoted = true;
    if (line[end] == '}') quoted = false;
    if (!quoted && (line[end] == ' ' || line[end] == '\t' || line[end] == '\r')) break;
  }
  const auto token = line.substr(start, end - start);
  line.remove_prefix(end);
  return token;
}

class Reader {
public:
  bool read(std::string_view line) {
    auto rest = line;
    const auto first = next(rest);
    if (first == "state") return state(next(rest));
    if (graph.states.empty()) return head(first, next(rest));
    if (first.empty()) return true;
    if (first == "props") return eachWord(rest, [&](auto token) { return property(token); });
    if (first == "trans") return eachWord(rest, [&](auto token) { return edge(token); });
    return false;
  }

  /// The missing part; empty if there is none.
  [[nodiscard]] std::string missing() const {
    if (graph.states.empty()) return "it has no states";
    if (nodes && *nodes != graph.states.size()) return "some of its states are missing";
    if (edges && *edges != edgeCount) return "some of its edges are missing";
    for (const auto& state : graph.states)
      for (const auto& [label, target] : state.edges)
        if (target >= graph.states.size()) return "an edge leads to a state that is missing";
    return {};
  }

  KtzGraph graph;

private:
  bool head(std::string_view first, std::string_view second) {
    if (second == "nodes") nodes = number<std::size_t>(first);
    if (second == "edges") edges = number<std::size_t>(first);
    return true;
  }

  bool state(std::string_view name) {
    graph.states.emplace_back();
    return number<std::size_t>(name) == graph.states.size() - 1;
  }

  template <class Take> static bool eachWord(std::string_view rest, Take take) {
    for (auto token = next(rest); !token.empty(); token = next(rest))
      if (!take(token)) return false;
    return true;
  }

  bool property(std::string_view token) {
    std::int64_t value = 1;
    const auto star = token.find('*', token.find('}') == token.npos ? 0 : token.find('}'));
    if (star != std::string_view::npos) {
      const auto read = number<std::int64_t>(token.substr(star + 1));
      if (!read) return false;
      value = *read;
      token = token.substr(0, star);
    }
    if (token.starts_with("L.")) return true; // a property of the graph, not of the model
    if (token.starts_with("S.")) token.remove_prefix(2);
    graph.states.back().has.emplace_back(properties.of(token), value);
    return true;
  }

  bool edge(std::string_view token) {
    const auto slash = token.rfind('/');
    if (slash == std::string_view::npos) return false;
    const auto target = number<std::uint32_t>(token.substr(slash + 1));
    if (!target) return false;
    auto label = token.substr(0, slash);
    if (label.starts_with("E.")) label.remove_prefix(2);
    graph.states.back().edges.emplace_back(labels.of(label), *target);
    ++edgeCount;
    return true;
  }

  Numbering properties{graph.properties};
  Numbering labels{graph.labels};
  std::optional<std::size_t> nodes;
  std::optional<std::size_t> edges;
  std::size_t edgeCount = 0;
};

} // namespace

std::expected<KtzGraph, std::string> readKtzText(std::istream& in) {
  Reader reader;
  std::string line;
  for (std::size_t count = 1; std::getline(in, line); ++count)
    if (!reader.read(line))
      return std::unexpected("line " + std::to_string(count) +
                             " is not understood: " + line.substr(0, 200));
  if (auto missing = reader.missing(); !missing.empty()) return std::unexpected(missing);
  return std::move(reader.graph);
}

} // namespace proskill::tina
