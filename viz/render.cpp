#include "viz/render.h"

#include "viz/dot/dot.h"
#include "viz/dot/text_layout.h"

#include <graphviz/gvc.h>

#include <mutex>

#ifdef __SANITIZE_ADDRESS__
/// Graphviz and its text libraries leak about a kilobyte per picture.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libgvc\nleak:libgvplugin\nleak:libcgraph\nleak:libpango\nleak:libfontconfig\nleak:"
         "libglib\n";
}
#endif

namespace proskill::viz {
namespace {

/// One context for pixel formats, which uses the fonts of this computer, and one for the rest. They
/// are never freed: Graphviz compares each font with the name of the last one, which belongs to the
/// context.
GVC_t* graphviz(bool pixels) {
  constexpr int kLoadOthers = 1;
  if (pixels) {
    static GVC_t* const context = gvContext();
    return context;
  }
  static GVC_t* const context = gvContextPlugins(textLayoutPlugin(), kLoadOthers);
  return context;
}

/// Collects Graphviz's messages during its lifetime. The callback takes no user data, hence the
/// global; only one thread at a time is in Graphviz.
class Complaints {
public:
  Complaints() : former(agseterrf(collect)), level(agseterr(AGWARN)) { said.clear(); }
  ~Complaints() {
    agseterrf(former);
    agseterr(level);
  }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  [[nodiscard]] static const std::string& text() { return said; }

private:
  static int collect(char* message) {
    said += message;
    return 0;
  }

  static inline std::string said;
  agusererrf former;
  agerrlevel_t level;
};

std::unexpected<std::string> failed(const std::string& what) {
  auto reason = Complaints::text();
  while (reason.ends_with('\n')) reason.pop_back();
  return std::unexpected(reason.empty() ? what : what + ": " + reason);
}

std::expected<std::string, std::string> renderBytes(Agraph_t* graph, const char* engine,
                                                    Format format) {
  const bool pixels = format == Format::Png;
  const auto* name = pixels ? "png" : "svg";
  auto* const context = graphviz(pixels);
  if (!context) return failed("Graphviz cannot be started");
  if (gvLayout(context, graph, engine) != 0) return failed("Graphviz cannot place the nodes");
  char* data = nullptr;
  unsigned length = 0;
  const bool good = gvRenderData(context, graph, name, &data, &length) == 0 && data;
  std::string bytes = good ? std::string(data, length) : std::string();
  gvFreeRenderData(data);
  gvFreeLayout(context, graph);
  if (!good) return failed(std::string("Graphviz cannot write ") + name);
  return bytes;
}

/// High enough for today's screens.
void setResolution(Agraph_t* graph) {
  std::string name = "dpi";
  std::string value = "144";
  agattr(graph, AGRAPH, name.data(), value.data());
}

} // namespace

std::expected<std::string, std::string> render(const Graph& graph, Format format, Scheme scheme) {
  static std::mutex oneAtATime;
  const std::lock_guard lock(oneAtATime);
  const Complaints complaints;
  auto text = writeDot(toCGraph(graph, scheme).get());
  if (format == Format::Dot) return text;
  // The layout depends on the order in which a graph was built. Reading it back restores the order
  // of its text, and the picture equals that of `dot`.
  const auto drawn = readDot(text);
  if (!drawn) return failed("the graph cannot be read back");
  if (format == Format::Png) setResolution(drawn.get());
  const auto* engine = graph.layout == Layout::Layered ? "dot" : "neato";
  return renderBytes(drawn.get(), engine, format);
}

} // namespace proskill::viz
