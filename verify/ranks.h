#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace proskill::verify {

/// The processes that share a search. They work in rounds: each sends messages and receives those
/// of the others until isRoundOver(). Between two rounds all of them call sum() or gather(), as
/// often as each other; so no message of a round can be taken for one of the next.
class Ranks {
public:
  struct Message {
    unsigned from = 0;
    std::string bytes;
  };

  Ranks() = default;
  virtual ~Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  /// The number of this process, from 0.
  [[nodiscard]] virtual unsigned self() const = 0;
  [[nodiscard]] virtual unsigned count() const = 0;

  /// Starts to send a message. Those to one rank arrive in their order.
  virtual void send(unsigned to, std::string bytes) = 0;
  /// Whether so many messages of this rank are under way that it should receive some before it
  /// sends more.
  [[nodiscard]] virtual bool isBusy() = 0;
  /// The next message that has arrived, if any. Does not wait.
  [[nodiscard]] virtual std::optional<Message> receive() = 0;
  /// Says that this rank sends no more in this round. \return whether all ranks have said so, and
  /// have received what was sent to them. Does not wait: call it again, and receive() in between.
  [[nodiscard]] virtual bool isRoundOver() = 0;

  /// Replaces each number by its sum over all ranks.
  virtual void sum(std::span<std::uint64_t> numbers) = 0;
  /// What each rank gives, by rank.
  [[nodiscard]] virtual std::vector<std::string> gather(const std::string& own) = 0;
};

} // namespace proskill::verify
