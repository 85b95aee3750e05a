#pragma once

#include "dds/dds.h"
#include "dds/raw_type.h"

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>

namespace proskill::dds {

/// Something that a thread of Fast DDS has noticed. Of messages only that a reader has some: they
/// stay in its history, which is bounded, until they are asked for.
struct Notice {
  DdsEventKind kind = DDS_NOTHING;
  std::int32_t endpoint = -1;
  DdsSample who{};
  Bytes text{};
};

/// Notices in their order. A reader with messages is in it once.
class Events {
public:
  void add(Notice notice);
  /// \return nothing when the time has passed
  std::optional<Notice> next(std::chrono::steady_clock::time_point until);

private:
  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Notice> waiting;
};

} // namespace proskill::dds
