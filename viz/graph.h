#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Pictures as plain values: what there is, what it means, and where it comes from; neither shapes
/// nor colours.
namespace proskill::viz {

/// What a node stands for. The theme gives each its shape and its colours, the legend its words.
enum class NodeRole : std::uint8_t {
  Start,     // where it begins
  End,       // where it gives control back
  State,     // a value of a state variable, a state of a watchdog
  Test,      // a condition that chooses the way
  Step,      // sets state variables
  Action,    // the platform's command
  Call,      // calls a skill
  Wait,      // for a condition or a time
  Interrupt, // interrupts, or is interrupted
  Message,   // printf
  Success,
  Failure,
  Invariant, // a guard that failed
  Error,     // what must not happen
  Fork,      // all branches begin
  Join,      // all branches have ended
  Junction,  // ways meet
  Label,     // for goto
  Event,     // something that happens in the environment
  Mission,   // the main skill
  Monitor,
  Composite,
  Basic,
  Folded, // a cluster as one node
};

enum class EdgeRole : std::uint8_t {
  Next,
  Yes,
  No,
  Forbidden,
  Stops, // before the action has ended
  Calls,
  Interrupts,
};

/// A place in the program, for links back to it.
struct Source {
  std::string file; ///< as a user would write it
  syntax::Range range;
  syntax::Position position; ///< of the range's begin
};

struct Node {
  NodeRole role = NodeRole::Step;
  std::string label;
  std::vector<std::string> details; ///< smaller lines below the label
  Source source;
  std::optional<std::size_t> cluster;
};

struct Edge {
  std::size_t from = 0;
  std::size_t to = 0;
  EdgeRole role = EdgeRole::Next;
  std::string label;
  std::optional<Source> source;
  bool twoWay = false; ///< the same back again
};

/// A frame around nodes, perhaps within another.
struct Cluster {
  std::string label;
  std::optional<std::size_t> parent;
  Source source;
  bool labelRight = false; ///< out of the way of an edge that comes from the left
};

/// How the nodes are best placed.
enum class Layout : std::uint8_t { Layered, Circular };

struct Graph {
  std::string title;
  std::string note; ///< a line below the title
  Layout layout = Layout::Layered;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  std::vector<Cluster> clusters;
};

} // namespace proskill::viz
