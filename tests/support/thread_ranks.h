#pragma once

#include "verify/ranks.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <random>

namespace proskill::test {

/// Ranks that are threads of this process. Messages are delayed and overtake each other at random,
/// except those from one rank to another.
class ThreadRanks {
public:
  ThreadRanks(unsigned ranks, std::uint64_t seed);

  /// Calls a function in a thread for each rank, and waits for all of them.
  void run(const std::function<void(verify::Ranks&)>& work);

private:
  class Rank;

  struct Mail {
    verify::Ranks::Message message;
    unsigned delay = 0; ///< number of looks into the mailbox that do not find it
  };

  unsigned count;
  std::uint64_t seed;
  std::mutex guard;
  std::condition_variable changed;
  std::vector<std::deque<Mail>> mailboxes; ///< by rank
  std::vector<unsigned> underWay;          ///< by rank: messages that it sent, not received yet
  std::uint64_t finished = 0;              ///< how often ranks have finished a round
  std::vector<std::string> given;          ///< by rank, in the present call of gather()
  unsigned givers = 0;
  std::vector<std::string> gathered; ///< in the last call
  std::uint64_t gatherings = 0;
};

} // namespace proskill::test
