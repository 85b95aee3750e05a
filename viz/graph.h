#pragma once

#include "syntax/text/source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// Pictures as plain values: elements, their meaning and their source, without shapes and colours.
namespace proskill::viz {

/// The meaning of a node. The theme defines shape and colours, the legend a description.
enum class NodeRole : std::uint8_t {
  Start,     // where it begins
  End,       // where it gives control back
  State,     // a value of a state variable, a state of a watchdog
  Test,      // a condition that decides the way
  Step,      // sets state variables
  Action,    // the platform's command
  Call,      // calls a skill
  Wait,      // for a condition or a time
  Interrupt, // interrupts, or is interrupted
  Message,   // printf
  Success,
  Failure,
  Invariant, // a guard that failed
  Error,     // an error
  Fork,      // all branches begin
  Join,      // all branches have ended
  Junction,  // paths meet
  Label,     // for goto
  Event,     // something that happens in the environment
  Mission,   // the main skill
  Monitor,
  Composite,
  Basic,
  Folded, // a folded cluster
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

/// A place in the program, for links.
struct Source {
  std::string file; ///< as the user writes it
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
  bool twoWay = false; ///< also in the other direction
};

/// A frame around nodes, possibly nested.
struct Cluster {
  std::string label;
  std::optional<std::size_t> parent;
  Source source;
  bool labelRight = false; ///< so that an edge from the left does not cross it
};

/// The layout algorithm for the nodes.
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
