#include "fuzz/targets.h"

#include <stdexcept>
#include <string>

namespace proskill::fuzz {

void expect(bool condition, std::string_view what) {
  if (!condition) throw std::logic_error("not so: " + std::string(what));
}

} // namespace proskill::fuzz
