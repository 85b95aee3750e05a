#include "viz/dot/dot.h"

#include "viz/dot/circle.h"
#include "viz/dot/ids.h"
#include "viz/dot/label.h"
#include "viz/dot/part_ids.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace proskill::viz {
namespace {

/// cgraph takes non-const strings, but does not change those that are passed here.
char* text(std::string& value) { return value.data(); }

/// A name in a URL. All bytes but letters, digits and punctuation of paths become %XX.
std::string urlOf(const Source& source) {
  std::string out;
  for (char c : source.file) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return fmt::format("{}#{}-{}", out, source.range.begin, source.range.end);
}

/// Sets attributes of an object, and declares new ones.
class Attributes {
public:
  Attributes(Agraph_t* within, void* what) : graph(within), object(what) {}

  void set(std::string name, std::string value) {
    declare(name);
    agxset(object, agattr(agraphof(object), AGTYPE(object), text(name), nullptr), text(value));
  }
  void setHtml(std::string name, std::string value) {
    declare(name);
    char* html = agstrdup_html(graph, text(value));
    agxset(object, agattr(agraphof(object), AGTYPE(object), text(name), nullptr), html);
    agstrfree(graph, html);
  }
  void setSource(const Source& source) {
    const auto file = clean(source.file);
    set("range", fmt::format("{}:{}-{}", file, source.range.begin, source.range.end));
    set("URL", urlOf(source));
    set("tooltip",
        fmt::format("{}:{}:{}", file, source.position.line + 1, source.position.column + 1));
  }

private:
  void declare(std::string& name) {
    std::string nothing;
    const auto kind = AGTYPE(object);
    if (!agattr(agroot(graph), kind, text(name), nullptr))
      agattr(agroot(graph), kind, text(name), text(nothing));
  }

  Agraph_t* graph;
  void* object;
};

class Drawing {
public:
  Drawing(const Graph& shown, Scheme chosen)
      : graph(shown), scheme(chosen), page(pageStyle(chosen)) {}

  CGraph draw() {
    std::string name = "proskill";
    Agdisc_t discipline{nullptr, sequentialIds(), nullptr};
    root.reset(agopen(text(name), Agdirected, &discipline));
    drawPage();
    drawClusters();
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) drawNode(i);
    if (graph.layout == Layout::Circular) pinNodes();
    for (std::size_t i = 0; i < graph.edges.size(); ++i) drawEdge(i);
    return std::move(root);
  }

private:
  void drawPage() {
    setDefaults();
    Attributes attributes(root.get(), root.get());
    attributes.set("charset", "UTF-8");
    attributes.set("layout", graph.layout == Layout::Layered ? "dot" : "neato");
    attributes.set("rankdir", "TB");
    attributes.set("nodesep", "0.35");
    attributes.set("ranksep", "0.42");
    attributes.set("pad", "0.3");
    attributes.set("bgcolor", std::string(page.background));
    attributes.set("fontname", std::string(kFont));
    attributes.set("fontcolor", std::string(page.text));
    attributes.set("labelloc", "t");
    attributes.set("labeljust", "l");
    attributes.setHtml("label", titleAndLegend(graph, scheme));
  }

  /// Sets what holds for all nodes and edges once.
  void setDefaults() {
    const auto set = [&](int kind, std::string name, std::string value) {
      agattr(root.get(), kind, text(name), text(value));
    };
    for (int kind : {AGNODE, AGEDGE}) {
      set(kind, "fontname", std::string(kFont));
      set(kind, "fontsize", kind == AGNODE ? "11" : "9");
      set(kind, "fontcolor", std::string(kind == AGNODE ? page.text : page.faint));
    }
    set(AGNODE, "penwidth", "1.2");
    set(AGNODE, "margin", "0.14,0.08");
    set(AGNODE, "height", "0.36");
    set(AGNODE, "width", "0.75");
    set(AGEDGE, "arrowsize", "0.7");
    set(AGEDGE, "penwidth", "1.2");
  }

  void drawClusters() {
    for (std::size_t i = 0; i < graph.clusters.size(); ++i) {
      const auto& cluster = graph.clusters[i];
      auto* parent = cluster.parent ? clusters[*cluster.parent] : root.get();
      auto name = clusterId(i);
      clusters.push_back(agsubg(parent, text(name), 1));
      Attributes attributes(root.get(), clusters.back());
      attributes.set("id", name);
      attributes.set("style", "filled,rounded");
      attributes.set("color", std::string(page.frame));
      attributes.set("fillcolor", std::string(page.shade));
      attributes.set("fontsize", "10");
      attributes.set("fontcolor", std::string(page.faint));
      attributes.set("margin", "12");
      attributes.set("label", clean(cluster.label));
      attributes.set("labeljust", cluster.labelRight ? "r" : "l");
      attributes.setSource(cluster.source);
    }
  }

  void drawNode(std::size_t i) {
    const auto& node = graph.nodes[i];
    auto id = nodeId(i);
    auto* within = node.cluster ? clusters[*node.cluster] : root.get();
    nodes.push_back(agnode(within, text(id), 1));
    const auto style = nodeStyle(node.role, scheme);
    Attributes attributes(root.get(), nodes.back());
    attributes.set("id", id);
    attributes.set("class", "role-" + std::string(style.id));
    attributes.set("shape", std::string(style.shape));
    attributes.set("style", std::string(style.style));
    attributes.set("fillcolor", std::string(style.fill));
    attributes.set("color", std::string(style.line));
    attributes.setSource(node.source);
    // these shapes have margins of their own
    if (style.shape == "hexagon" || style.shape == "octagon" || style.shape == "ellipse" ||
        style.shape == "parallelogram")
      attributes.set("margin", "0.04,0.03");
    if (node.label.empty())
      drawSign(attributes, node.role);
    else
      attributes.setHtml("label", nodeLabel(node, scheme));
  }

  void pinNodes() {
    const auto points = placeInCircle(graph);
    for (std::size_t i = 0; i < points.size(); ++i)
      Attributes(root.get(), nodes[i])
          .set("pos", fmt::format("{:.3f},{:.3f}!", points[i].x, points[i].y));
  }

  /// Draws a node without text: a dot, or the bar of a fork.
  void drawSign(Attributes& attributes, NodeRole role) {
    const bool bar = role == NodeRole::Fork || role == NodeRole::Join;
    const auto* height = bar ? "0.07" : role == NodeRole::Junction ? "0.09" : "0.18";
    attributes.set("label", "");
    attributes.set("height", height);
    attributes.set("width", bar ? "1.8" : height);
    attributes.set("fixedsize", "true");
  }

  void drawEdge(std::size_t i) {
    const auto& edge = graph.edges[i];
    auto key = edgeId(i);
    auto* drawn = agedge(clusterOf(edge), nodes[edge.from], nodes[edge.to], text(key), 1);
    const auto style = edgeStyle(edge.role, scheme);
    Attributes attributes(root.get(), drawn);
    attributes.set("id", key);
    attributes.set("class", "role-" + std::string(style.id));
    attributes.set("style", std::string(style.style));
    attributes.set("color", std::string(style.colour));
    if (isMainWay(edge)) attributes.set("weight", "4");
    if (edge.twoWay) attributes.set("dir", "both");
    if (!edge.label.empty()) attributes.set("label", edgeLabel(edge.label));
    if (edge.source) attributes.setSource(*edge.source);
  }

  /// Puts a little space on both sides of each line.
  static std::string edgeLabel(std::string_view words) {
    std::string out;
    for (const auto& line : wrap(clean(words), 18)) out += (out.empty() ? " " : "\n ") + line + " ";
    return out;
  }

  /// The cluster that contains an edge, so that the frame also encloses the edge's label.
  [[nodiscard]] Agraph_t* clusterOf(const Edge& edge) const {
    const auto from = graph.nodes[edge.from].cluster;
    return from && from == graph.nodes[edge.to].cluster ? clusters[*from] : root.get();
  }

  /// Whether to draw an edge straight: the main path is straight; branches and joins have no main
  /// path.
  [[nodiscard]] bool isMainWay(const Edge& edge) const {
    const auto from = graph.nodes[edge.from].role;
    const auto to = graph.nodes[edge.to].role;
    return (edge.role == EdgeRole::Next || edge.role == EdgeRole::Yes) && edge.from < edge.to &&
           from != NodeRole::Action && to != NodeRole::Join && to != NodeRole::End;
  }

  const Graph& graph;
  Scheme scheme;
  PageStyle page;
  CGraph root;
  std::vector<Agraph_t*> clusters;
  std::vector<Agnode_t*> nodes;
};

/// Position in a text for reading.
struct Reader {
  std::string_view rest;
};

/// Reads to the end of a line, as fgets does. cgraph's own reader expects that.
int readLine(void* from, char* buffer, int size) {
  auto& rest = static_cast<Reader*>(from)->rest;
  const auto line = std::min(rest.find('\n'), rest.size() - 1) + 1;
  const auto length = rest.empty() ? 0 : std::min(line, static_cast<std::size_t>(size));
  rest.copy(buffer, length);
  rest.remove_prefix(length);
  return static_cast<int>(length);
}

int putString(void* out, const char* bytes) {
  static_cast<std::string*>(out)->append(bytes);
  return 0;
}

int flush(void*) { return 0; }

} // namespace

CGraph toCGraph(const Graph& graph, Scheme scheme) { return Drawing(graph, scheme).draw(); }

CGraph readDot(std::string_view dot) {
  Agiodisc_t fromString{readLine, nullptr, nullptr};
  Agdisc_t discipline{nullptr, sequentialIds(), &fromString};
  Reader reader{dot};
  CGraph graph(agread(&reader, &discipline));
  if (graph) graph->clos->disc.io = &AgIoDisc;
  return graph;
}

std::string writeDot(Agraph_t* graph) {
  std::string out;
  Agiodisc_t toString{nullptr, putString, flush};
  auto* former = graph->clos->disc.io;
  graph->clos->disc.io = &toString;
  agwrite(graph, &out);
  graph->clos->disc.io = former;
  return out;
}

} // namespace proskill::viz
