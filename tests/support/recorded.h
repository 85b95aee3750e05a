#pragma once

#include "report/run/mcap.h"
#include "runtime/conform/recorded_run.h"

#include <algorithm>
#include <string>

namespace proskill::test {

/// A file in memory, which must outlive it.
inline report::mcap::File fileOf(const std::string& bytes) {
  return {bytes.size(), [&](std::uint64_t at, std::uint64_t size) {
            return bytes.substr(std::min<std::uint64_t>(at, bytes.size()), size);
          }};
}

/// Keeps a recorded run as a whole.
class KeptRun final : public runtime::RunSink {
public:
  bool onHead(const runtime::RecordedHead& head) override {
    run.head = head;
    return true;
  }
  bool onStep(const runtime::RecordedStep& step) override {
    run.steps.push_back(step);
    return true;
  }
  bool onCall(const runtime::RecordedCall& call) override {
    run.calls.push_back(call);
    return true;
  }

  runtime::RecordedRun run;
};

} // namespace proskill::test
