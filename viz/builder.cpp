#include "viz/builder.h"

#include <algorithm>

namespace proskill::viz {

std::size_t Builder::node(NodeRole role, std::string label, syntax::Range range,
                          std::vector<std::string> details) {
  graph.nodes.push_back({role, std::move(label), std::move(details), source(range), cluster});
  return graph.nodes.size() - 1;
}

void Builder::connect(const Exits& exits, std::size_t to) {
  for (const auto& exit : exits) edge({exit.from, to, exit.role, exit.label, exit.source});
}

Exits Builder::then(const Exits& exits, std::size_t to) {
  connect(exits, to);
  return {{.from = to}};
}

void Builder::enterCluster(std::string label, syntax::Range range, bool labelRight) {
  graph.clusters.push_back({std::move(label), cluster, source(range), labelRight});
  cluster = graph.clusters.size() - 1;
}

void Builder::leaveCluster() { cluster = graph.clusters[*cluster].parent; }

Source Builder::source(syntax::Range range) const {
  const auto& where = program.files[file];
  return {where.path.string(), range, where.document.lines().position(range.begin)};
}

std::string Builder::text(syntax::Range range) const {
  const auto& whole = program.files[file].document.text();
  std::string out;
  bool comment = false;
  for (char c : std::string_view(whole).substr(range.begin, range.length())) {
    if (c == ';') comment = true;
    if (c == '\n') comment = false;
    const bool blank = comment || c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!blank)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  return out;
}

std::vector<std::string> Builder::effects(const syntax::Effects& effects) const {
  std::vector<std::string> lines;
  for (const auto& effect : effects.items)
    lines.push_back(std::string(effect.variable.text) + " := " + text(effect.value.range));
  return lines;
}

std::string Builder::seconds(const syntax::Interval& interval) const {
  return text(interval.range) + " s";
}

} // namespace proskill::viz
