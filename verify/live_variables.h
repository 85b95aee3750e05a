#pragma once

#include "verify/system.h"

namespace proskill::verify {

class LiveVariables {
public:
  void clean(Word*) const {}
};

} // namespace proskill::verify
