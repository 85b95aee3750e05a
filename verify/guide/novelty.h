#pragma once

#include "verify/model/system.h"

#include <map>
#include <random>
#include <vector>

namespace proskill::verify {

/// How new a state is among those seen before: it has a new value of some cell, or a new pair of
/// values, or a pair that was seen rarely. A search that begins with new states soon reaches what
/// needs few things at a time, however many processes there are; among the others, rare pairs lead
/// it on from where few runs have come. Lipovetzky and Geffner, "Width and serialization of
/// classical planning problems", ECAI 2012, and "Best-first width search", AAAI 2017.
class Novelty {
public:
  /// The smaller, the newer. From `Pair` on: about the binary logarithm of how often the rarest
  /// pair was seen.
  enum Degree : std::uint8_t { Value, Pair, None = UINT8_MAX };

  /// \param laidOut with its state layout
  explicit Novelty(const System& laidOut);

  /// Notes the state from which the next ones are reached.
  void expand(const Word* state);
  /// The degree of a state, which is seen from now on. Only pairs with a value that differs from
  /// the state that is expanded are considered.
  [[nodiscard]] Degree seePair(const Word* state);
  /// The same by values alone, among the states of one group.
  [[nodiscard]] Degree seeValue(const Word* state, std::uint32_t group);

private:
  /// A cell of which values are numbered from `first` on.
  struct Tracked {
    CellId cell = 0;
    std::uint32_t first = 0;
  };

  void readValues(const Word* state);
  [[nodiscard]] Degree see(std::uint32_t one, std::uint32_t other);

  const System& system;
  std::minstd_rand random;
  std::vector<Tracked> tracked;
  std::uint32_t count = 0; ///< of values of all cells
  /// By the greater and the smaller of two values, once the greater was seen: how often the pair
  /// was, in levels of four bits. Empty: there are too many values.
  std::vector<std::vector<std::uint8_t>> pairs;
  std::map<std::uint32_t, std::vector<bool>> seen; ///< by group and value
  std::vector<std::uint32_t> values; ///< of the state that was read last, by tracked cell
  std::vector<std::uint32_t> before; ///< of the state that is expanded
};

} // namespace proskill::verify
