#include "fiacre/check/lone_ports.h"

#include "fiacre/check/declarations.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace proskill::fiacre {
namespace {

/// The users of a port within an instance.
struct Holders {
  std::size_t count = 0;    ///< number of instances of processes
  std::size_t together = 0; ///< the largest number of them that synchronise in one step; 0: none
                            ///< can
  bool sends = false;       ///< one can synchronise without receiving a value
  std::string process;      ///< the name of one of them
};

/// The names of one port in a component or a process.
using PortNames = std::set<std::string>;

bool communicates(const Statement& statement, StatementKind how, const PortNames& port) {
  return (statement.kind == how && port.contains(statement.name)) ||
         std::ranges::any_of(statement.children,
                             [&](const auto& child) { return communicates(child, how, port); });
}

bool communicates(const Process& process, StatementKind how, const PortNames& port) {
  return std::ranges::any_of(process.transitions, [&](const auto& from) {
    return communicates(from.statement, how, port);
  });
}

Holders holder(const Process& process, const PortNames& port) {
  const bool sends = communicates(process, StatementKind::Send, port);
  const bool passes = sends || communicates(process, StatementKind::Receive, port);
  return {.count = 1, .together = passes ? 1U : 0U, .sends = sends, .process = process.name};
}

/// The names within an instance of the ports that it is given.
PortNames namesWithin(const Instance& instance, const std::vector<Port>& formal,
                      const PortNames& port) {
  PortNames names;
  for (std::size_t i = 0; i < formal.size(); ++i)
    if (port.contains(instance.ports[i])) names.insert(formal[i].name);
  return names;
}

/// The users of a port in one composition: those that synchronise do so with all others that do, or
/// not at all.
class Composed {
public:
  void add(const Holders& part, bool waits) {
    if (part.count == 0) return;
    all.count += part.count;
    all.sends = all.sends || part.sends;
    all.process = part.process;
    if (!waits) {
      apart = std::max(apart, part.together);
      return;
    }
    blocked = blocked || part.together == 0;
    joint += part.together;
  }

  [[nodiscard]] Holders result() const {
    auto made = all;
    made.together = std::max(apart, blocked ? 0 : joint);
    return made;
  }

private:
  Holders all;
  std::size_t apart = 0;
  std::size_t joint = 0;
  bool blocked = false;
};

class Search {
public:
  explicit Search(const Program& program) : known(program) {}

  Holders holders(const std::vector<Instance>& parts, const PortNames& port) {
    Composed composed;
    for (const auto& part : parts) composed.add(holders(part, port), waits(part, port));
    return composed.result();
  }

private:
  static bool waits(const Instance& part, const PortNames& port) {
    const auto isPort = [&](const auto& name) { return port.contains(name); };
    return !part.synchronised || std::ranges::any_of(*part.synchronised, isPort);
  }

  Holders holders(const Instance& part, const PortNames& port) {
    if (!part.parts.empty()) return holders(part.parts, port);
    if (const auto* process = lookUp(known.processes, part.process)) {
      const auto names = namesWithin(part, (*process)->ports, port);
      if (names.empty()) return {};
      return holder(**process, names);
    }
    const auto& component = **lookUp(known.components, part.process);
    const auto names = namesWithin(part, component.interfacePorts, port);
    return names.empty() ? Holders{} : inside(component, names);
  }

  Holders inside(const Component& component, const PortNames& port) {
    const std::pair key(component.name, port);
    if (const auto found = memory.find(key); found != memory.end()) return found->second;
    return memory.emplace(key, holders(component.instances, port)).first->second;
  }

  const Declarations known;
  std::map<std::pair<std::string, PortNames>, Holders> memory;
};

bool isOnPurpose(const Component& component, const Port& port) {
  const auto names = [&](const std::vector<std::string>& ports) {
    return std::ranges::find(ports, port.name) != ports.end();
  };
  return port.interval || port.probe ||
         std::ranges::any_of(component.priorities, [&](const Priority& priority) {
           return names(priority.higher) || names(priority.lower);
         });
}

} // namespace

std::vector<LonePort> lonePorts(const Program& program) {
  std::vector<LonePort> found;
  Search search(program);
  for (const auto& component : program.components)
    for (const auto& port : component.ports) {
      if (isOnPurpose(component, port)) continue;
      const auto holders = search.holders(component.instances, {port.name});
      if (holders.together == 1 && holders.sends)
        found.push_back({component.name, port.name, holders.count == 1 ? holders.process : ""});
    }
  return found;
}

} // namespace proskill::fiacre
