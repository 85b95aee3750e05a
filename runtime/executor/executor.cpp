#include "runtime/executor/executor.h"

#include "runtime/executor/execution.h"

namespace proskill::runtime {

RunResult execute(const Executable& executable, Clock& clock, Platform& platform,
                  Observer& observer, const RunOptions& options) {
  Execution execution(executable, clock, platform, observer, options);
  execution.start();
  while (true) {
    switch (execution.proceed()) {
    case Progress::Moved: break;
    case Progress::Waits: clock.wait(execution.wakeDate(), execution.descriptors()); break;
    case Progress::Ended: return execution.result();
    }
  }
}

} // namespace proskill::runtime
