#include "cli/output/graph_file.h"

#include "cli/output/checked_program.h"
#include "cli/terminal/error.h"
#include "cli/terminal/exit_code.h"
#include "disk/output.h"
#include "tina/graph_text.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>

namespace proskill::cli {

namespace {

/// Prints one line with counts, in the form of sift, and the time; then what ranks have sent, and
/// what was on disk.
void printCounts(const verify::Exploration& counted) {
  fmt::print("{} classe(s), {} marking(s), {} domain(s), {} transition(s)\n{:.3f}s\n",
             counted.classes, counted.markings, counted.domains, counted.transitions,
             counted.seconds);
  if (counted.ranks > 0)
    fmt::print("{} rank(s), {} message(s), {} byte(s) sent\n", counted.ranks, counted.messages,
               counted.sentBytes);
  if (counted.spilledBytes > 0) fmt::print("{} byte(s) on disk\n", counted.spilledBytes);
}

int failIncomplete(const verify::Exploration& counted) {
  std::cerr << "the graph is not complete: " << counted.stopped << '\n';
  return kInconclusive;
}

int count(const codegen::Model& model, const verify::Options& options) {
  auto counted = verify::countClasses(model.fiacre, options);
  if (!counted) return failUnsupported(counted.error());
  printCounts(*counted);
  return counted->complete ? kDone : failIncomplete(*counted);
}

std::optional<std::string> writeGraph(const std::filesystem::path& path,
                                      const verify::StateGraph& graph, const std::string& name) {
  return disk::writeFile(path, [&](std::ostream& out) {
    if (path.extension() == ".aut")
      tina::writeAut(out, graph);
    else
      tina::writeKtzText(out, graph, name);
  });
}

} // namespace

int exploreGraph(const std::string& target, verify::GraphKind kind, const codegen::Model& model,
                 const verify::Options& options) {
  if (target == "counts" && kind == verify::GraphKind::Classes) return count(model, options);
  const std::filesystem::path path(target);
  const bool isFile = target != "counts";
  if (isFile && path.extension() != ".aut" && path.extension() != ".txt")
    return fail("`--graph` needs a file that ends in `.aut` or `.txt`, or `counts`");
  auto graph = verify::stateGraph(model.fiacre, kind, options);
  if (!graph) return failUnsupported(graph.error());
  if (!graph->counts.complete) {
    printCounts(graph->counts);
    return failIncomplete(graph->counts);
  }
  if (isFile)
    if (auto problem = writeGraph(path, *graph, tina::netName(model.fiacre))) return fail(*problem);
  printCounts(graph->counts);
  if (kind != verify::GraphKind::Classes)
    fmt::print("{} state(s), {} edge(s)\n", graph->markingOf.size(), graph->edges.size());
  return kDone;
}

} // namespace proskill::cli
