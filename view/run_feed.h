#pragma once

#include "report/ordered_json.h"
#include "runtime/control/bounded_queue.h"
#include "view/panel_data.h"

#include <atomic>
#include <functional>
#include <string_view>

namespace proskill::view {

/// The steps of a run for any number of pages. The run puts them into a bounded queue; a thread
/// takes them out, and pages request them when they have time.
class RunFeed {
public:
  /// Creates the parameters of the notification `run`.
  using Status = std::function<OrderedJson()>;

  /// \param head the trace without its steps \param waits whether the run waits where the queue is
  /// full, as it may in simulated time
  RunFeed(EventFeed& news, OrderedJson head, bool waits, Status status);
  RunFeed(const RunFeed&) = delete;
  RunFeed& operator=(const RunFeed&) = delete;
  ~RunFeed() { finish(); }

  /// The run's: adds a step or a remark, as JSON. Takes no lock.
  /// \return false if there is no room
  bool push(std::string_view line);
  /// The run's: nothing more is added.
  void finish();
  /// The status has changed.
  void wake();

  /// The steps from this one on, as many as one answer may have: `{from, steps, total}`. If some of
  /// them are no longer kept, from the first that is, with the values before it as `initial`.
  [[nodiscard]] OrderedJson from(std::size_t index) const;
  [[nodiscard]] OrderedJson trace() const;
  /// Number of steps and remarks so far.
  [[nodiscard]] std::size_t total() const;
  /// Number of those for which there was no room.
  [[nodiscard]] std::uint64_t lost() const { return lostLines; }

private:
  void work();
  void takeAll();
  void keep(std::string line);
  void forgetFirst();

  EventFeed& news;
  const bool waits;
  const Status status;
  runtime::BoundedQueue<std::string> queue;
  std::atomic<std::uint64_t> lostLines{0};
  std::atomic<std::uint32_t> changes{0}; ///< the thread waits for it
  std::atomic<bool> finished{false};
  mutable std::mutex mutex; ///< guards what follows
  OrderedJson head;         ///< with the values before the first kept line
  std::deque<std::string> kept;
  std::size_t first = 0; ///< number of the first kept line
  std::thread worker;    ///< the last member, since it uses the others
};

} // namespace proskill::view
