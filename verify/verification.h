#pragma once

#include "verify/answer_store.h"
#include "verify/checkpoint/checkpoint.h"
#include "verify/compile/compile.h"
#include "verify/explore/search.h"
#include "verify/settled.h"
#include "verify/stages.h"
#include "verify/trace/witness.h"
#include "verify/verify.h"

#include <map>
#include <set>

namespace proskill::verify {

/// Answers questions to a compiled model, each as soon as it is decided.
class Verification {
public:
  Verification(const Compiled& model, const fiacre::Provenance& origins,
               const std::vector<Question>& of, const Options& with, LimitWatch& watch, Result& to);

  /// \throw LimitMet where it is met before there is anything to explore
  std::optional<Unsupported> run();

private:
  [[nodiscard]] bool takes(Reduction reduction) const;
  [[nodiscard]] std::function<bool(Reduction)> may() const;

  // what is known before anything is explored
  void findKnown();
  void findEarlier();
  std::set<std::size_t> replayKnown(std::map<std::size_t, Evidence>& violations);
  void answerKnownTime(std::size_t index, const KnownAnswer& found);
  void answerKnown(std::size_t index, Answer made, const KnownAnswer& found);
  [[nodiscard]] std::expected<Answer, std::string> shown(std::size_t index, const Goal& goal,
                                                         const Evidence& evidence,
                                                         const Witness& witness) const;
  [[nodiscard]] Answer timeAnswer(std::size_t index, Duration time,
                                  const std::optional<Goal>& shows, Evidence evidence,
                                  const Witness& witness) const;

  // checkpoints
  std::optional<Unsupported> resume();
  bool answerSettled(std::vector<Settled::Decided> decided);
  void settle();
  void settleStates(bool isLimited);
  void settleSince(std::size_t index);
  void saveSometimes();
  std::optional<Unsupported> searchAndSettle(std::size_t index);
  void settleRun();

  // questions about states and steps
  std::optional<Unsupported> exploreStates(std::vector<std::size_t> which);
  std::optional<Unsupported> explore(std::vector<std::size_t> which);
  bool isStoppedAt(const Stage& reached, const std::vector<std::size_t>& which);
  bool answersAny(const Stage& stage, const std::vector<std::size_t>& which);
  std::optional<Unsupported> stopDecided();
  enum class Order : std::uint8_t { BreadthFirst, Led, Newest, Walks };
  std::optional<Unsupported> exploreWhole(const std::vector<std::size_t>& which, const Pause& pause,
                                          Order order = Order::BreadthFirst);
  [[nodiscard]] bool usesParts();
  bool isAnsweredPlainly(std::size_t index);
  bool answerTrue(std::size_t index);
  bool exploreSlices(std::vector<std::size_t> which, const SearchSize& most);
  bool refine(std::vector<std::size_t> which, const Refinement::Budget& budget);
  Refinement& refinementOfAll();
  [[nodiscard]] bool areErrorsExcluded();
  bool isAnyDecided(const auto& decide);
  [[nodiscard]] std::vector<std::size_t> openAmong(const std::vector<std::size_t>& which,
                                                   const auto& suits) const;
  [[nodiscard]] std::vector<std::size_t> leadable(const std::vector<std::size_t>& which) const;
  bool exploreLed(const std::vector<std::size_t>& which, std::uint64_t most, std::uint64_t each);
  bool sampleRuns(const std::vector<std::size_t>& which, std::uint64_t most, bool traced);
  [[nodiscard]] bool wantsTrace(std::size_t index) const;
  bool exploreNewest(const std::vector<std::size_t>& which, std::uint64_t most);
  bool exploreByWalks(const std::vector<std::size_t>& which, std::uint64_t most);
  [[nodiscard]] std::optional<Answer> shownIfPossible(std::size_t index, const Evidence& evidence,
                                                      const Witness& witness) const;
  bool isShownBySlice(std::size_t index, const Evidence* evidence, const Witness& witness);

  // questions with a search of their own
  std::optional<Unsupported> searchFor(std::size_t index);
  std::optional<Unsupported> searchForLost(std::size_t index, const Goal& goal);
  std::optional<Unsupported> answerWith(const auto& found, std::size_t index,
                                        const Reductions& reductions);
  std::optional<Unsupported> measure(std::size_t index, const Goal& goal);
  std::optional<Unsupported> watch(std::size_t index, const Goal& goal);
  std::optional<Unsupported> watchWithin(std::size_t index, std::uint64_t most);
  [[nodiscard]] bool mayRefineRuns(const Goal& goal) const;
  bool isShownByRunSlices(std::size_t index, std::uint64_t most);
  void exploreRuns(const Stage& stage);

  void answerBy(std::size_t index, const Evidence& evidence, const Witness& witness);
  void answerWithout(std::size_t index, const Exploration& exploration,
                     const std::string& progressStopped);
  void keep(std::size_t index, const KnownAnswer& made);
  void answer(std::size_t index, Answer made);

  const Compiled& compiled;
  const fiacre::Provenance& provenance;
  const std::vector<Question>& questions;
  const Options& options;
  LimitWatch& limits;
  Result& result;
  System whole; ///< with every cell kept
  const Reductions none;
  std::set<std::size_t> answered;
  std::set<std::size_t> known; ///< goals that Options::answers or a checkpoint had the answers to
  bool slicesAreDone = false;  ///< larger searches of them would not decide more
  bool isEdit = false;         ///< Options::answers had answers of an earlier version of the model
  std::size_t stage = 0;       ///< the next one of stagesOf()
  std::optional<Refinement> refinement; ///< from the first stage that needs it to the last

  std::optional<Checkpoint> checkpoint;
  bool isSaving = false; ///< no limit has left anything open yet
  double savedAt = 0;    ///< in seconds, without a search under way
  Settled settled;
  std::size_t settledCount =
      0; ///< of Settled::decided; the others are decided by the search under way
};

} // namespace proskill::verify
