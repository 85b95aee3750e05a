#pragma once

#include "groot/breakpoints.h"

#include <deque>
#include <functional>
#include <map>
#include <string_view>

namespace proskill::groot {

/// The breakpoints of viewers ("hooks" in the protocol), and the stops of the run at them that no
/// viewer has unlocked yet. For the thread that answers viewers. Functions return why a request is
/// refused; empty: it is done.
class Hooks {
public:
  /// Announces to viewers that the run has stopped at a node.
  using Publish = std::function<void(Uid uid)>;

  /// \param whyNot the run cannot stop, if it cannot
  /// \pre the breakpoints outlive this
  Hooks(std::size_t nodes, Breakpoints& breakpoints, std::string whyNot, Publish publish);

  /// \param text one of them, or a list: `{"uid", "position", "mode", "enabled", "once",
  /// "desired_status"}`
  [[nodiscard]] std::string insert(std::string_view text);
  /// \param text `{"uid", "position"}`
  [[nodiscard]] std::string remove(std::string_view text);
  /// Lets the run go on from a breakpoint, and from the next one if it has stopped at several.
  /// \param text `{"uid", "position", "desired_status", "remove_when_done"}`
  [[nodiscard]] std::string unlock(std::string_view text);
  void removeAll();
  void disableAll();
  /// All of them, as JSON.
  [[nodiscard]] std::string dump() const;

  /// Takes the stops of the run.
  void followRun();
  /// A viewer has sent a request. \param time in microseconds
  void hear(std::uint64_t time);
  /// Suspends all breakpoints, and lets the run go on, if no viewer has sent a request for 5 s.
  void notice(std::uint64_t time);
  /// Microseconds until `notice` has something to do; nullopt: nothing.
  [[nodiscard]] std::optional<std::uint64_t> nextNotice(std::uint64_t time) const;

private:
  using Key = std::pair<Position, Uid>;
  struct Hook {
    bool isEnabled = true;
    bool isOnce = false;
    std::string
        desired; ///< the status in the request, which only has a meaning when it is unlocked
  };
  struct Request;

  [[nodiscard]] std::string whyNotInserted(const Request& request) const;
  [[nodiscard]] std::string whyNotUnlocked(const Stop& stop, std::string_view desired) const;
  void arm(const Key& key, const Hook& hook);
  void erase(const Key& key);
  void pass(const Key& key);
  void forgetStops();
  void show();

  const std::size_t nodes;
  Breakpoints& breakpoints;
  const std::string whyNot;
  const Publish publish;
  std::map<Key, Hook> all;
  std::deque<Stop> stopped; ///< the run goes on once all are unlocked
  bool isShown = false;     ///< the first of them
  bool isHeard = true;      ///< a viewer is there
  std::uint64_t heard = 0;  ///< when
};

} // namespace proskill::groot
