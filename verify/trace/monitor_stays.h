#pragma once

#include "verify/explore/search.h"

#include <algorithm>

namespace proskill::verify {

/// A monitor in a location while the model is in a state, between two dates of the evidence (see
/// dates.h): either that of the step to the state, or of the move to the location, and so on.
struct MonitorStay {
  std::uint32_t location = 0;
  std::size_t from = 0;
  std::size_t to = 0;
};

/// The stays of the monitor of an evidence, state by state. Time may only pass in one whose
/// location allows the state. A move between two steps may have any place among several states;
/// then its locations have a stay in each of them, some of no duration.
/// Not included: stays in locations of errors, where a run is a violation whatever follows, and the
/// stay after the last move in the last state.
class MonitorStays {
public:
  explicit MonitorStays(const Evidence& evidence) {
    const std::size_t last = evidence.steps.size();
    std::size_t own = last + 2;
    for (const auto& mark : evidence.marks) {
      const std::size_t date = mark.atStep ? mark.after : own++;
      if (mark.ticks) continue;
      if (segments.empty()) segments.push_back({.location = mark.location});
      auto& before = segments.back();
      before.moves = !mark.atStep;
      before.end = date;
      before.late = mark.after;
      before.last = mark.atStep ? mark.after - 1 : mark.until;
      const auto to = evidence.monitor->locations[mark.location].edges[mark.edge].to;
      segments.push_back({.location = to,
                          .begins = !mark.atStep,
                          .begin = date,
                          .first = mark.after,
                          .early = mark.until,
                          .last = last == 0 ? 0 : last - 1});
    }
    std::erase_if(segments, [&](const Segment& segment) {
      return evidence.monitor->locations[segment.location].error || segment.first > segment.last;
    });
    if (!segments.empty() && last == 0 && !segments.back().moves) segments.pop_back();
  }

  /// Calls `see` with each stay in the state after this many steps. \pre called with rising numbers
  template <class See> void eachIn(std::size_t state, See&& see) {
    while (next < segments.size() && segments[next].last < state) ++next;
    for (std::size_t i = next; i < segments.size() && segments[i].first <= state; ++i) {
      const auto& it = segments[i];
      if (it.last < state) continue;
      see(MonitorStay{.location = it.location,
                      .from = it.begins && state <= it.early ? it.begin : state,
                      .to = it.moves && state >= it.late ? it.end : state + 1});
    }
  }

private:
  /// A location from one move to the next.
  struct Segment {
    std::uint32_t location = 0;
    bool begins = false;   ///< with a move between two steps
    std::size_t begin = 0; ///< its date
    std::size_t first = 0; ///< the first state
    std::size_t early = 0; ///< the last state in which it can begin
    bool moves = false;    ///< it ends with a move between two steps
    std::size_t end = 0;   ///< its date
    std::size_t late = 0;  ///< the first state in which it can end
    std::size_t last = 0;  ///< the last state
  };

  std::vector<Segment> segments;
  std::size_t next = 0;
};

} // namespace proskill::verify
