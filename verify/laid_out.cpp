#include "verify/laid_out.h"

#include "verify/model/system_bytes.h"
#include "verify/state/state_layout.h"

namespace proskill::verify {

System checkedCopy(const System& whole, LimitWatch& limits) {
  limits.checkLargeGrowth(bytesOf(whole));
  return whole;
}

System laidOutCopy(const System& whole, LimitWatch& limits) {
  return withStateLayout(checkedCopy(whole, limits));
}

System laidOutCopy(const System& whole, const Bits& kept, LimitWatch& limits) {
  return withStateLayout(checkedCopy(whole, limits), kept);
}

} // namespace proskill::verify
