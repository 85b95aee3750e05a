#pragma once

#include "verify/state/enabled.h"

namespace proskill::verify {

/// The steps that write the same constants in every state, and that no event is about: most of the
/// steps of most systems. They are fired as a few writes of bits.
class ConstantSteps {
public:
  explicit ConstantSteps(const System& system);

  [[nodiscard]] bool contain(TransitionId transition) const {
    return verify::contains(constant, transition);
  }
  /// The same as fire(), without a log. \pre contain(transition)
  void fire(TransitionId transition, Word* state) const {
    for (auto i = firstOf[transition]; i < firstOf[transition + 1]; ++i)
      state[stores[i].word] = (state[stores[i].word] & stores[i].keep) | stores[i].bits;
  }

private:
  TransitionSet constant;
  std::vector<std::uint32_t> firstOf; ///< by transition: index in `stores`
  std::vector<BitStore> stores;
};

} // namespace proskill::verify
