#pragma once

#include "verify/answer_store.h"
#include "verify/checkpoint/checkpoint.h"

#include <string>
#include <vector>

namespace proskill::verify {

/// What a verification need not do again when it goes on from a checkpoint: everything but the
/// search under way.
struct Settled {
  struct Decided {
    std::size_t question = 0;
    KnownAnswer answer;
    std::string reason; ///< if it is unknown, and no limit is to blame; otherwise empty
  };

  std::vector<Decided> decided;
  Exploration exploration; ///< of finished searches
  /// The questions of the search of states under way, some of which may be decided by now.
  std::vector<std::size_t> asked;
  std::size_t stage = 0; ///< the next one of stagesOf()
  bool slicesAreDone = false;
  bool statesAreDone = false; ///< all questions about states are settled
};

/// \param decided how many of the decided questions to write
void write(CheckpointWriter& to, const Settled& settled, std::size_t decided);
/// Nothing is assumed of what is read; see CheckpointReader::hasFailed.
/// \param questions their number
[[nodiscard]] Settled readSettled(CheckpointReader& from, std::size_t questions);

} // namespace proskill::verify
