#include "viz/theme.h"

#include <array>

namespace proskill::viz {
namespace {

/// A colour family: fill and line, on light and on dark ground.
struct Tint {
  std::string_view lightFill;
  std::string_view lightLine;
  std::string_view darkFill;
  std::string_view darkLine;
};

constexpr Tint kInk{"#1f2937", "#1f2937", "#e5e7eb", "#e5e7eb"};
constexpr Tint kPaper{"#ffffff", "#374151", "#1b1f27", "#d1d5db"};
constexpr Tint kGrey{"#f3f4f6", "#6b7280", "#2b303b", "#9ca3af"};
constexpr Tint kBlue{"#e1ecfd", "#2563eb", "#1c2f52", "#7aa9f7"};
constexpr Tint kNavy{"#c3d7fb", "#1d4ed8", "#274690", "#a5c3fb"};
constexpr Tint kTeal{"#d7f3ef", "#0f766e", "#123d3a", "#4fd1c0"};
constexpr Tint kAmber{"#fef3cf", "#b07908", "#45360d", "#e9c46a"};
constexpr Tint kViolet{"#ece6fb", "#6d4bc3", "#332a55", "#b39ef0"};
constexpr Tint kPink{"#fce3f0", "#be2577", "#4c1b37", "#f286bd"};
constexpr Tint kGreen{"#dcf5e3", "#15803d", "#153d25", "#6bd18d"};
constexpr Tint kOrange{"#ffe8d4", "#c2500c", "#4d2a12", "#f5a26b"};
constexpr Tint kRed{"#fde0e0", "#c02626", "#501c1c", "#f58a8a"};

struct NodeEntry {
  NodeRole role;
  std::string_view id;
  std::string_view meaning;
  std::string_view shape;
  std::string_view style;
  Tint tint;
};

constexpr auto kNodes = std::to_array<NodeEntry>({
    {NodeRole::Start, "start", "", "circle", "filled", kInk},
    {NodeRole::End, "end", "gives control back", "box", "filled,rounded,bold", kPaper},
    {NodeRole::State, "state", "state", "box", "filled,rounded", kBlue},
    {NodeRole::Test, "test", "test", "hexagon", "filled", kAmber},
    {NodeRole::Step, "step", "sets state variables", "box", "filled", kGrey},
    {NodeRole::Action, "action", "action of the platform", "box", "filled,bold", kTeal},
    {NodeRole::Call, "call", "calls a skill", "box", "filled,rounded", kBlue},
    {NodeRole::Wait, "wait", "waits", "ellipse", "filled", kViolet},
    {NodeRole::Interrupt, "interrupt", "interrupt", "box", "filled,rounded,dashed", kPink},
    {NodeRole::Message, "message", "message", "note", "filled", kGrey},
    {NodeRole::Success, "success", "success", "box", "filled,rounded,bold", kGreen},
    {NodeRole::Failure, "failure", "failure", "box", "filled,rounded,bold", kOrange},
    {NodeRole::Invariant, "invariant", "invariant fails", "box", "filled,rounded,dashed", kRed},
    {NodeRole::Error, "error", "error", "octagon", "filled,bold", kRed},
    {NodeRole::Fork, "fork", "parallel branches", "box", "filled", kInk},
    {NodeRole::Join, "join", "", "box", "filled", kInk},
    {NodeRole::Junction, "junction", "", "circle", "filled", kInk},
    {NodeRole::Label, "label", "label", "plain", "", kPaper},
    {NodeRole::Event, "event", "event", "parallelogram", "filled", kTeal},
    {NodeRole::Mission, "mission", "the mission", "box", "filled,rounded,bold", kNavy},
    {NodeRole::Monitor, "monitor", "monitor", "box", "filled,rounded,bold", kViolet},
    {NodeRole::Composite, "composite", "composite skill", "box", "filled,rounded", kBlue},
    {NodeRole::Basic, "basic", "basic skill", "box", "filled", kTeal},
    {NodeRole::Folded, "folded", "folded", "folder", "filled", kGrey},
});

struct EdgeEntry {
  EdgeRole role;
  std::string_view id;
  std::string_view meaning;
  std::string_view style;
  Tint tint;
  std::string_view sign;
};

constexpr Tint kLine{"", "#4b5563", "", "#aeb6c2"};

constexpr auto kEdges = std::to_array<EdgeEntry>({
    {EdgeRole::Next, "next", "", "solid", kLine, "→"},
    {EdgeRole::Yes, "yes", "", "solid", kGreen, "→"},
    {EdgeRole::No, "no", "", "solid", kRed, "→"},
    {EdgeRole::Forbidden, "forbidden", "must not happen", "dashed", kRed, "⇢"},
    {EdgeRole::Stops, "stops", "ends it early", "dashed", kRed, "⇢"},
    {EdgeRole::Calls, "calls", "calls", "solid", kLine, "→"},
    {EdgeRole::Interrupts, "interrupts", "interrupts", "dashed", kPink, "⇢"},
});

} // namespace

NodeStyle nodeStyle(NodeRole role, Scheme scheme) {
  const auto& entry = kNodes[static_cast<std::size_t>(role)];
  const bool light = scheme == Scheme::Light;
  return {entry.id,
          entry.meaning,
          entry.shape,
          entry.style,
          light ? entry.tint.lightFill : entry.tint.darkFill,
          light ? entry.tint.lightLine : entry.tint.darkLine};
}

EdgeStyle edgeStyle(EdgeRole role, Scheme scheme) {
  const auto& entry = kEdges[static_cast<std::size_t>(role)];
  const auto colour = scheme == Scheme::Light ? entry.tint.lightLine : entry.tint.darkLine;
  return {entry.id, entry.meaning, entry.style, colour, entry.sign};
}

PageStyle pageStyle(Scheme scheme) {
  if (scheme == Scheme::Light) return {"#ffffff", "#111827", "#4b5563", "#cbd2dc", "#fafbfc"};
  return {"#1b1f27", "#eef1f5", "#b4bcc8", "#454c5a", "#20252f"};
}

} // namespace proskill::viz
