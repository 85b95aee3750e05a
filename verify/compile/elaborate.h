#pragma once

#include "verify/compile/expressions.h"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace proskill::verify {

/// Events by what they are of; numbered as they are asked for.
class Events {
public:
  explicit Events(System& of) : system(of) {}

  EventId tag(InstanceId instance, const std::string& name) {
    return numbered(tags, {instance, name});
  }
  EventId entering(InstanceId instance, std::uint32_t location) {
    return numbered(entries, {instance, location});
  }
  EventId port(std::uint32_t port) { return numbered(ports, port); }

  /// kNone where nobody asked for it.
  [[nodiscard]] EventId askedTag(InstanceId instance, const std::string& name) const {
    return asked(tags, {instance, name});
  }
  [[nodiscard]] EventId askedEntering(InstanceId instance, std::uint32_t location) const {
    return asked(entries, {instance, location});
  }
  [[nodiscard]] EventId askedPort(std::uint32_t port) const { return asked(ports, port); }

private:
  template <class Map> static EventId asked(const Map& map, const typename Map::key_type& key) {
    auto found = map.find(key);
    return found == map.end() ? kNone : found->second;
  }
  template <class Map> EventId numbered(Map& map, const typename Map::key_type& key) {
    auto [entry, added] = map.try_emplace(key, system.eventCount);
    if (added) ++system.eventCount;
    return entry->second;
  }

  System& system;
  std::map<std::pair<InstanceId, std::string>, EventId> tags;
  std::map<std::pair<InstanceId, std::uint32_t>, EventId> entries;
  std::map<std::uint32_t, EventId> ports;
};

/// Places in `par`, from 1, from the main component down. Those of the k-th observer, counted from
/// 1, begin with 0 and k.
using ModelPath = std::vector<std::uint32_t>;

/// A composition of instances and of compositions, for what synchronises with what.
struct Branch {
  InstanceId instance = kNone; ///< of a process; else a composition
  std::vector<Branch> children;
  std::set<std::uint32_t> ports; ///< System::ports that it has
  /// Those on which it waits for its neighbours; nothing: all.
  std::optional<std::set<std::uint32_t>> synchronised;

  [[nodiscard]] bool waitsOn(std::uint32_t port) const {
    return !synchronised || synchronised->contains(port);
  }
};

/// Ports of which one goes before another.
struct PortPriority {
  std::set<std::uint32_t> higher;
  std::set<std::uint32_t> lower;
};

/// The main component with its instances: who they are, what they see, how they start.
struct Elaboration {
  Scope componentScope;
  Branch composition;
  std::map<ModelPath, InstanceId> instanceAt;
  std::map<ModelPath, Scope> scopeAt; ///< of components within the main one, and of observers
  std::map<std::pair<ModelPath, std::string>, std::uint32_t> portAt;
  std::vector<std::optional<fiacre::Interval>> intervals; ///< by port
  std::vector<PortPriority> priorities;
  std::vector<const fiacre::Observable*> probes; ///< by port: what has to be seen; null: nothing
  InstanceId firstObserver = kNone;              ///< instances from it on are of observers
  std::vector<const fiacre::Type*> cellTypes;    ///< by cell; null: where an instance is
  std::map<std::string, std::int64_t, std::less<>> constants; ///< those that are one number
  std::vector<const fiacre::Process*> processes;              ///< by instance
  std::vector<Scope> scopes;                                  ///< by instance
  /// By instance: System::ports of its formal ports.
  std::vector<std::vector<std::uint32_t>> portsOf;
};

/// A path of a property or a probe. \throw CompileError where its observer is none
[[nodiscard]] ModelPath pathOf(const fiacre::Program& program,
                               const fiacre::Observable& observable);

/// Gives the system its cells, instances, ports and initial values. \throw CompileError
[[nodiscard]] Elaboration elaborate(const fiacre::Program& program, const Types& types,
                                    Expressions& expressions, System& system);

} // namespace proskill::verify
