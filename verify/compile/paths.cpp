#include "verify/compile/path_writer.h"

#include <algorithm>
#include <set>

namespace proskill::verify {

namespace {

bool isTimed(const fiacre::Interval& interval) {
  bool immediate = interval.upper == 0 && !interval.lowerOpen && !interval.upperOpen;
  bool always = interval.lower == 0 && !interval.lowerOpen && !interval.upper;
  return !immediate && !always;
}

/// The targets by which a waiting path is split: where it ends, `kNone` for `loop`.
std::set<std::uint32_t> endsOf(const Path& path) {
  std::set<std::uint32_t> ends;
  for (const auto& instruction : path.code) {
    if (instruction.kind == InstructionKind::To) ends.insert(instruction.last);
    if (instruction.kind == InstructionKind::Loop) ends.insert(kNone);
  }
  return ends;
}

/// The path, in which every end outside of `kept` becomes a failed guard.
Path restricted(Path path, const std::set<std::uint32_t>& kept, NodeId never) {
  for (auto& instruction : path.code) {
    bool to = instruction.kind == InstructionKind::To;
    bool loop = instruction.kind == InstructionKind::Loop;
    if ((!to && !loop) || kept.contains(to ? instruction.last : kNone)) continue;
    instruction = {.kind = InstructionKind::On, .node = never};
    path.tentative = true;
  }
  path.loops = kept.contains(kNone);
  return path;
}

} // namespace

const std::vector<fiacre::Type>& PathContext::valuesOf(const std::string& port) const {
  static const std::vector<fiacre::Type> kNothing;
  const auto found = std::ranges::find(process->ports, port, &fiacre::Port::name);
  return found == process->ports.end() ? kNothing : found->values;
}

std::vector<Path> pathsOf(const fiacre::From& from, std::uint32_t location, PathContext& context,
                          Expressions& expressions) {
  PathWriter writer(context, expressions);
  PathDraft draft;
  draft.path.instance = context.instance;
  draft.path.location = location;
  draft.path.guard = expressions.nodes().number(1);
  writer.write(std::move(draft), {&from.statement});
  const NodeId never = expressions.nodes().number(0);
  std::vector<Path> all;
  for (const auto& path : writer.found) {
    bool timed = path.port != kNone ? context.portIsTimed[path.port]
                                    : isTimed(path.wait.value_or(fiacre::Interval{}));
    std::set<std::uint32_t> moves = endsOf(path);
    const bool loops = moves.erase(kNone) > 0;
    if (loops) all.push_back(restricted(path, {kNone}, never));
    if (timed)
      for (auto end : moves) all.push_back(restricted(path, {end}, never));
    else if (!moves.empty())
      all.push_back(restricted(path, moves, never));
  }
  return all;
}

} // namespace proskill::verify
