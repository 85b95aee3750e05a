#pragma once

#include "fiacre/syntax/tree.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

/// A second, straightforward interpreter of Fiacre, to check the engine. It walks the tree at every
/// step, reduces nothing, and shares only the tree with verify/.
namespace proskill::oracle {

/// An error of the model, or a construct that this interpreter does not support. Both fail a test.
struct ModelError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A discrete state: the states of the instances by index, then the variables, one slot per scalar.
/// A constructor is represented by its index in its union.
using Store = std::vector<std::int64_t>;

/// Position of a variable, or a part of it, in a store.
struct Place {
  std::size_t offset = 0;
  const fiacre::Type* type = nullptr;
};

using Scope = std::unordered_map<std::string, Place>;

/// Maps the name of a port in a process or a component to its index in Interpreter::ports.
using PortMap = std::unordered_map<std::string, std::size_t>;

struct PortSlot {
  std::string name;
  std::vector<std::uint32_t> component; ///< the path of the component that declares it
  const fiacre::Port* port = nullptr;
};

/// A process in the composition.
struct Instance {
  const fiacre::Process* process = nullptr;
  /// Positions in `par`, from 1, from the main component down; 0 and k precede those of observer k.
  std::vector<std::uint32_t> path;
  Scope scope;
  PortMap ports;
};

/// Identifies a timed transition across states: its participants, the branches of `select` and the
/// values of `any` on its path, its port or its wait, and its target. Tests inside a path do not
/// count: an `if` whose branches meet again is one transition.
using ClockId = std::size_t;

/// An atomic step.
struct Firing {
  ClockId clock = 0;
  fiacre::Interval interval;
  std::vector<std::size_t> participants; ///< instances, ascending
  std::vector<std::size_t> movers;       ///< those that did not end in `loop`
  std::optional<std::size_t> port;
  std::vector<std::size_t> watchers;                     ///< ports that observers pass with it
  std::vector<std::pair<std::size_t, std::string>> tags; ///< by instance
  std::vector<fiacre::OriginId> origins;                 ///< of the statements passed
  /// For a `select` with `unless`: which of its parts.
  std::optional<std::pair<const fiacre::Statement*, std::size_t>> rank;
  Store after;
};

/// Engine: the branches of an `if` that meet again are one transition. Frac: each path is a
/// transition with a clock of its own, enabled while all its tests are true.
enum class Reading : std::uint8_t { Engine, Frac };

struct Path;

class Interpreter {
public:
  /// \pre `program` outlives this
  explicit Interpreter(const fiacre::Program& program, Reading reading = Reading::Engine);

  [[nodiscard]] const Store& initial() const { return first; }
  /// Every step that the discrete state allows, ignoring time. They are computed once and stay
  /// valid. \throw ModelError
  [[nodiscard]] const std::vector<Firing>& firings(const Store& store) const;
  /// Whether one step has priority over the other.
  [[nodiscard]] bool goesBefore(const Firing& high, const Firing& low) const;
  [[nodiscard]] const std::vector<Instance>& instances() const { return elaborated; }
  [[nodiscard]] const std::vector<PortSlot>& ports() const { return slots; }
  [[nodiscard]] std::vector<std::uint32_t> pathOf(const fiacre::Observable& observable) const;
  /// The instances that take part in a transition of this clock.
  [[nodiscard]] const std::vector<std::size_t>& participants(ClockId clock) const;

  /// The value of `expression` as seen by the instance at `path`, or by the component there.
  [[nodiscard]] bool holds(const std::vector<std::uint32_t>& path, const fiacre::Expr& expression,
                           const Store& store) const;
  /// The value of an lvalue in the main component as text, such as `skill[takeoff].status`. Indices
  /// are constants, so it is at one place in every store.
  [[nodiscard]] std::string show(const std::string& lvalue, const Store& store) const;
  /// The name of an instance's current state.
  [[nodiscard]] const std::string& stateName(std::size_t instance, const Store& store) const;

private:
  friend class Evaluation;
  friend class PathWalk;
  friend const fiacre::Type& resolveType(const Interpreter&, const fiacre::Type&);

  [[nodiscard]] const fiacre::Type& resolve(const fiacre::Type& type) const;
  [[nodiscard]] const fiacre::Component& componentNamed(const std::string& name) const;
  void countInstances(const std::vector<fiacre::Instance>& parts);
  void addParts(const std::vector<fiacre::Instance>& parts, const std::vector<std::uint32_t>& path,
                const Scope& scope, const PortMap& ports);
  void elaborate(const fiacre::Component& component, std::vector<std::uint32_t> path, Scope scope,
                 PortMap ports);
  void addInstance(const fiacre::Process& process, const fiacre::Instance& instance,
                   std::vector<std::uint32_t> path, const Scope& outer, const PortMap& outerPorts);
  static PortMap bindPorts(const std::vector<fiacre::Port>& formal,
                           const fiacre::Instance& instance, const PortMap& outer);
  void bindParameters(const std::vector<fiacre::Parameter>& parameters,
                      const fiacre::Instance& instance, const Scope& outer, Scope& scope);
  void declare(const std::vector<fiacre::Variable>& variables, Scope& scope);
  Place allocate(const fiacre::Type& type);
  void start(std::size_t instance);
  [[nodiscard]] std::vector<Firing> computeFirings(const Store& store) const;
  [[nodiscard]] std::vector<Path> paths(std::size_t instance, const Store& store) const;
  void synchronise(std::size_t port, const std::vector<std::vector<Path>>& all, const Store& store,
                   std::vector<Firing>& result) const;
  [[nodiscard]] bool isProbed(std::size_t port, const Store& store) const;
  [[nodiscard]] bool observes(const Firing& firing) const;
  void watch(std::size_t port, const std::vector<std::vector<Path>>& all, const Store& store,
             std::vector<Firing>& result) const;
  [[nodiscard]] std::vector<std::vector<const Path*>>
  choices(std::size_t port, const std::vector<std::vector<Path>>& all) const;
  [[nodiscard]] Firing combine(std::span<const Path* const> parts, const Store& store) const;
  [[nodiscard]] ClockId clockOf(std::span<const Path* const> parts) const;

  const fiacre::Program& program;
  Reading reading;
  std::unordered_map<std::string, const fiacre::TypeDeclaration*> types;
  std::unordered_map<std::string, const fiacre::Constant*> constants;
  std::unordered_map<std::string, const fiacre::Function*> functions;
  std::vector<Instance> elaborated;
  std::map<std::vector<std::uint32_t>, Scope> componentScopes;
  std::vector<PortSlot> slots;
  std::size_t firstObserver = 0; ///< instances from here on belong to observers
  std::set<std::pair<std::size_t, std::size_t>> priorities; ///< ports: the first has priority
  Store first;

  // Clocks are numbered when they first occur.
  mutable std::map<std::vector<std::uint64_t>, ClockId> clockNumbers;
  mutable std::vector<std::vector<std::size_t>> clockParticipants;
  mutable std::map<Store, std::vector<Firing>> known;   ///< the firings by state
  mutable std::unordered_map<std::string, Place> shown; ///< the places of lvalues
};

} // namespace proskill::oracle
