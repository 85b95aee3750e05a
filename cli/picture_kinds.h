#pragma once

#include "cli/choice.h"
#include "viz/pictures.h"

#include <algorithm>

namespace proskill::cli {

/// The words for kinds of pictures, on the command line and in JSON.
inline const Choices<viz::Kind> kPictureKinds{{"sv", viz::Kind::StateVariable},
                                              {"skill", viz::Kind::Skill},
                                              {"body", viz::Kind::Body},
                                              {"calls", viz::Kind::Calls}};

template <class Value>
[[nodiscard]] const std::string& wordOf(const Choices<Value>& choices, Value value) {
  return std::ranges::find(choices, value, &Choices<Value>::value_type::second)->first;
}

} // namespace proskill::cli
