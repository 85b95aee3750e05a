#include "tests/support/oracle/class_graph.h"

#include <algorithm>
#include <map>

namespace proskill::oracle {

using fiacre::Interval;

namespace {

constexpr Bound kNone{0, false, true};
constexpr Bound kZero{0, false, false};

bool tighter(const Bound& a, const Bound& b) {
  if (a.infinite || b.infinite) return !a.infinite && b.infinite;
  return a.value < b.value || (a.value == b.value && a.strict && !b.strict);
}

Bound sum(const Bound& a, const Bound& b) {
  if (a.infinite || b.infinite) return kNone;
  return {a.value + b.value, a.strict || b.strict, false};
}

Domain unbounded(std::vector<ClockId> clocks) {
  Domain domain{std::move(clocks), {}};
  domain.bounds.assign(domain.size() * domain.size(), kNone);
  for (std::size_t i = 0; i < domain.size(); ++i) {
    domain.at(i, i) = kZero;
    domain.at(0, i) = kZero; // nothing fires in the past
  }
  return domain;
}

void window(Domain& domain, std::size_t i, const Interval& interval) {
  domain.at(0, i) = {-interval.lower, interval.lowerOpen, false};
  if (interval.upper) domain.at(i, 0) = {*interval.upper, interval.upperOpen, false};
}

/// Tightest bounds, by all shortest paths. \return false if there are no dates left
bool close(Domain& domain) {
  const std::size_t n = domain.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        Bound through = sum(domain.at(i, k), domain.at(k, j));
        if (tighter(through, domain.at(i, j))) domain.at(i, j) = through;
      }
  for (std::size_t i = 0; i < n; ++i)
    if (tighter(domain.at(i, i), kZero)) return false;
  return true;
}

using Windows = std::map<ClockId, Interval>;

Windows windowsOf(const std::vector<Firing>& firings) {
  Windows all;
  for (const auto& firing : firings) all[firing.clock] = firing.interval;
  return all;
}

std::vector<ClockId> keysOf(const Windows& windows) {
  std::vector<ClockId> keys;
  for (const auto& [clock, _] : windows) keys.push_back(clock);
  return keys;
}

/// The domain in which `fired` fires first; nullopt if it cannot.
std::optional<Domain> firedFirst(Domain domain, std::size_t fired) {
  for (std::size_t i = 1; i < domain.size(); ++i)
    if (tighter(kZero, domain.at(fired, i))) domain.at(fired, i) = kZero;
  if (!close(domain)) return std::nullopt;
  return domain;
}

class ClassGraph {
public:
  ClassGraph(const Interpreter& of, std::size_t most) : model(of), limit(most) {}

  ClassCounts count() {
    auto windows = windowsOf(firingsOf(model.initial()));
    Domain start = unbounded(keysOf(windows));
    for (std::size_t i = 1; i < start.size(); ++i)
      window(start, i, windows.at(start.clocks[i - 1]));
    if (close(start)) add(model.initial(), std::move(start));
    std::size_t transitions = 0;
    for (; !todo.empty() && classes.size() < limit;) {
      auto [store, domain] = *todo.back();
      todo.pop_back();
      for (const auto& firing : firingsOf(store)) transitions += fire(domain, firing);
    }
    std::set<Store> markings;
    std::set<Domain> domains;
    for (const auto& [store, domain] : classes) {
      markings.insert(store);
      domains.insert(domain);
    }
    return {classes.size(), markings.size(), domains.size(), transitions, todo.empty()};
  }

private:
  const std::vector<Firing>& firingsOf(const Store& store) {
    auto [entry, added] = known.try_emplace(store);
    if (added) entry->second = model.firings(store);
    return entry->second;
  }

  void add(const Store& store, Domain domain) {
    auto [entry, added] = classes.emplace(store, std::move(domain));
    if (added) todo.push_back(entry);
  }

  bool fire(const Domain& domain, const Firing& firing) {
    std::size_t fired = indexOf(domain, firing.clock);
    auto first = firedFirst(domain, fired);
    if (!first) return false;
    auto windows = windowsOf(firingsOf(firing.after));
    Domain next = unbounded(keysOf(windows));
    for (std::size_t i = 1; i < next.size(); ++i) {
      ClockId clock = next.clocks[i - 1];
      if (!goesOn(domain, firing, clock)) {
        window(next, i, windows.at(clock));
        continue;
      }
      // dates relative to the step: x_i - x_fired
      std::size_t old = indexOf(domain, clock);
      next.at(i, 0) = first->at(old, fired);
      next.at(0, i) = first->at(fired, old);
      for (std::size_t j = 1; j < i; ++j) {
        if (!goesOn(domain, firing, next.clocks[j - 1])) continue;
        std::size_t other = indexOf(domain, next.clocks[j - 1]);
        next.at(i, j) = first->at(old, other);
        next.at(j, i) = first->at(other, old);
      }
    }
    if (!close(next)) throw ModelError("a class without dates");
    add(firing.after, std::move(next));
    return true;
  }

  static std::size_t indexOf(const Domain& domain, ClockId clock) {
    auto found = std::ranges::find(domain.clocks, clock);
    return static_cast<std::size_t>(found - domain.clocks.begin()) + 1;
  }

  [[nodiscard]] bool goesOn(const Domain& domain, const Firing& firing, ClockId clock) const {
    if (clock == firing.clock || indexOf(domain, clock) == domain.size()) return false;
    return std::ranges::none_of(model.participants(clock), [&](std::size_t instance) {
      return std::ranges::find(firing.movers, instance) != firing.movers.end();
    });
  }

  const Interpreter& model;
  std::size_t limit;
  std::map<Store, std::vector<Firing>> known;
  std::set<std::pair<Store, Domain>> classes;
  std::vector<std::set<std::pair<Store, Domain>>::iterator> todo;
};

} // namespace

ClassCounts countClasses(const Interpreter& model, std::size_t limit) {
  return ClassGraph(model, limit).count();
}

} // namespace proskill::oracle
