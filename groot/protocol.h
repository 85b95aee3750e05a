#pragma once

#include "groot/hooks.h"

#include <array>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace proskill::groot {

/// The parts of a message.
using Parts = std::vector<std::string>;
using TreeId = std::array<std::uint8_t, 16>;

/// A UUID, other than that of any other run.
[[nodiscard]] TreeId randomTreeId();

/// When the run has come to a state.
struct Moment {
  std::uint64_t time = 0;  ///< of a clock that requests are dated with, in microseconds
  bool isAfterGap = false; ///< steps before it are not known
};

/// Answers the requests of Groot2's monitor protocol (BehaviorTree.CPP, groot2_protocol.h).
/// A request has a head of 6 bytes (protocol, letter, number in 4 bytes) and perhaps a second part.
/// The reply repeats the head and adds the tree's id; an error has the parts `error` and a message.
class Protocol {
public:
  /// \pre the tree, the executable and the hooks outlive this
  Protocol(const Tree& tree, const runtime::Executable& executable, Hooks& hooks, TreeId id);

  /// The run is in this state.
  void follow(const verify::Word* state, Moment moment);
  /// \param time as in a moment \param date in microseconds since 1970
  [[nodiscard]] Parts answer(const Parts& request, std::uint64_t time, std::uint64_t date);

  /// The message to subscribers that the run has stopped at a breakpoint.
  [[nodiscard]] static Parts stopMessage(Uid uid, std::uint32_t number);

private:
  /// A change of a status in a recording.
  struct Change {
    std::uint64_t time = 0;
    Uid uid = 0;
    Status status = Status::Idle;
  };

  void record(Uid uid, Status status);
  [[nodiscard]] Parts answerOnHooks(const Parts& request, Parts reply);
  [[nodiscard]] Parts statusReply(Parts reply) const;
  [[nodiscard]] Parts blackboards(Parts reply, std::string_view names) const;
  [[nodiscard]] Parts toggleRecording(Parts reply, std::string_view word, std::uint64_t time,
                                      std::uint64_t date);
  [[nodiscard]] Parts recorded(Parts reply);

  const Tree& tree;
  const runtime::Executable& executable;
  Hooks& hooks;
  const TreeId id;
  const std::string xml;
  std::vector<verify::Word> state;
  std::uint64_t now = 0;                  ///< the time of the current step
  std::optional<std::uint64_t> recording; ///< since when
  std::deque<Change> changes;             ///< the last ones
  Statuses statuses;                      ///< the last member, since it uses the others
};

} // namespace proskill::groot
