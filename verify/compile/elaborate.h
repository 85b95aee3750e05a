#pragma once

#include "verify/compile/expressions.h"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace proskill::verify {

/// Numbers for events, given out when somebody asks for an event.
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

  /// kNone if nobody asked for this event.
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

/// The path of an instance: positions in `par`, from 1, starting at the main component. Paths of
/// the k-th observer, counted from 1, begin with 0 and k.
using ModelPath = std::vector<std::uint32_t>;

/// A tree of compositions with instances as leaves. It determines which instances synchronise.
struct Branch {
  InstanceId instance = kNone; ///< of a process; kNone: this is a composition
  std::vector<Branch> children;
  std::set<std::uint32_t> ports; ///< indices into System::ports
  /// The ports on which it synchronises with its siblings; nullopt: all.
  std::optional<std::set<std::uint32_t>> synchronised;

  [[nodiscard]] bool waitsOn(std::uint32_t port) const {
    return !synchronised || synchronised->contains(port);
  }
};

/// A priority: each port in `higher` goes before each port in `lower`.
struct PortPriority {
  std::set<std::uint32_t> higher;
  std::set<std::uint32_t> lower;
};

/// The main component, instantiated: the instances, their scopes and their initial values.
struct Elaboration {
  Scope componentScope;
  Branch composition;
  std::map<ModelPath, InstanceId> instanceAt;
  std::map<ModelPath, Scope> scopeAt; ///< of components within the main one, and of observers
  std::map<std::pair<ModelPath, std::string>, std::uint32_t> portAt;
  std::vector<std::optional<fiacre::Interval>> intervals; ///< by port
  std::vector<PortPriority> priorities;
  /// By port: what a probe on this port observes; null: not a probe.
  std::vector<const fiacre::Observable*> probes;
  InstanceId firstObserver = kNone;           ///< this instance and all later ones are observers
  std::vector<const fiacre::Type*> cellTypes; ///< by cell; null: the location of an instance
  std::map<std::string, std::int64_t, std::less<>> constants; ///< constants with a scalar value
  std::vector<const fiacre::Process*> processes;              ///< by instance
  std::vector<Scope> scopes;                                  ///< by instance
  /// By instance: indices into System::ports of its formal ports.
  std::vector<std::vector<std::uint32_t>> portsOf;
};

/// The path of the instance in a property or a probe.
/// \throw CompileError if it names an observer that does not exist
[[nodiscard]] ModelPath pathOf(const fiacre::Program& program,
                               const fiacre::Observable& observable);

/// Adds the cells, instances, ports and initial values to the system. \throw CompileError
[[nodiscard]] Elaboration elaborate(const fiacre::Program& program, const Types& types,
                                    Expressions& expressions, System& system);

} // namespace proskill::verify
