#include "viz/builder.h"

namespace proskill::viz {
namespace {

using EventDefinition = analysis::Definition<syntax::Event>;

/// What the event waits for, again after each occurrence.
std::size_t drawWait(Builder& builder, const analysis::Program& program,
                     const EventDefinition& event) {
  if (event->every)
    return builder.node(NodeRole::Wait, builder.seconds(*event->every), event->every->range,
                        {"since it occurred last, or since the start"});
  const bool isEmitted = !program.environments.all.empty();
  auto when = isEmitted ? "until the environment emits it" : "any time";
  if (!event->guard) return builder.node(NodeRole::Wait, when, event->name.range);
  return builder.node(NodeRole::Wait, "until " + builder.text(event->guard->range),
                      event->guard->range, {isEmitted ? when : "then at any time, while it holds"});
}

} // namespace

bool hasTimesOfItsOwn(const EventDefinition& event) { return event->every || event->guard; }

Graph drawEvent(const analysis::Program& program, const EventDefinition& event) {
  Builder builder(program, event.file);
  builder.graph.title = "event " + std::string(event.name());
  const auto start = builder.node(NodeRole::Start, {}, event->name.range);
  const auto wait = drawWait(builder, program, event);
  const auto occurs = builder.node(NodeRole::Event, std::string(event.name()), event->name.range,
                                   builder.effects(event->effects));
  builder.edge({start, wait});
  builder.edge({wait, occurs});
  builder.edge({occurs, wait});
  return std::move(builder.graph);
}

} // namespace proskill::viz
