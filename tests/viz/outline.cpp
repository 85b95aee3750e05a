#include "tests/viz/outline.h"

#include "tests/where.h"
#include "viz/theme.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace proskill::viz::test {
namespace {

class OneFile : public analysis::FileSystem {
public:
  explicit OneFile(std::string content) : text(std::move(content)) {}
  std::expected<std::string, std::string> read(const std::filesystem::path&) const override {
    return text;
  }
  std::filesystem::path canonical(const std::filesystem::path& path) const override {
    return path.lexically_normal();
  }

private:
  std::string text;
};

class Disk : public analysis::FileSystem {
public:
  std::expected<std::string, std::string> read(const std::filesystem::path& path) const override {
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::unexpected("it is not there");
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
  }
  std::filesystem::path canonical(const std::filesystem::path& path) const override {
    return std::filesystem::weakly_canonical(path);
  }
};

std::string nameOf(const Node& node) {
  const auto id = std::string(nodeStyle(node.role, Scheme::Light).id);
  return node.label.empty() ? id : node.label;
}

std::string line(const Graph& graph, const Node& node) {
  auto out = std::string(nodeStyle(node.role, Scheme::Light).id);
  if (!node.label.empty()) out += " " + node.label;
  if (!node.details.empty()) out += fmt::format(" {{{}}}", fmt::join(node.details, "; "));
  if (node.cluster) out += fmt::format(" in {}", graph.clusters[*node.cluster].label);
  return out + "\n";
}

std::string line(const Graph& graph, const Edge& edge) {
  const auto id = edgeStyle(edge.role, Scheme::Light).id;
  auto out = fmt::format("{} {} {}", nameOf(graph.nodes[edge.from]), edge.twoWay ? "<->" : "->",
                         nameOf(graph.nodes[edge.to]));
  if (edge.role != EdgeRole::Next) out += fmt::format(" [{}]", id);
  if (!edge.label.empty()) out += fmt::format(": {}", edge.label);
  return out + "\n";
}

} // namespace

analysis::Program program(std::string text) {
  return analysis::load(OneFile(std::move(text)), "p.proskill");
}

analysis::Program example(const std::string& path) {
  return analysis::load(Disk(), std::filesystem::path(PROSKILL_SOURCE_DIR) / "examples" / path);
}

Graph picture(const analysis::Program& program, Kind kind, const std::string& name,
              bool forbidden) {
  auto graph = draw(program, {kind, name, forbidden});
  if (!graph) throw std::runtime_error(graph.error());
  return std::move(*graph);
}

std::string outline(const Graph& graph) {
  std::string out = "\n";
  for (const auto& node : graph.nodes) out += line(graph, node);
  for (const auto& edge : graph.edges) out += line(graph, edge);
  return out;
}

std::string origin(const analysis::Program& program, const Node& node) {
  for (const auto& file : program.files)
    if (file.path.string() == node.source.file)
      return file.document.text().substr(node.source.range.begin, node.source.range.length());
  throw std::runtime_error("no such file: " + node.source.file);
}

} // namespace proskill::viz::test
