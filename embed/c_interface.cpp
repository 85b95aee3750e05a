#include "embed/executor.h"

#include <memory>

/// The functions of include/proskill/executor.h.

using namespace proskill;
using embed::answer;
using embed::Done;
using embed::failed;
using embed::isNull;

namespace {

/// Calls a function of an executor that only one thread may use at a time.
template <class Call> proskill_error exclusive(proskill_executor* executor, Call&& call) noexcept {
  return answer([&]() -> Done {
    if (!executor) return isNull("executor");
    return executor->exclusively(call);
  });
}

/// Calls a function of a started run, in any thread.
template <class Call>
proskill_error toPlatform(proskill_executor* executor, const char* argument, const char* name,
                          Call&& call) noexcept {
  return answer([&]() -> Done {
    if (!executor) return isNull("executor");
    if (!argument) return isNull(name);
    const auto platform = executor->started();
    return platform ? call(**platform) : std::unexpected(platform.error());
  });
}

} // namespace

// NOLINTBEGIN(readability-identifier-naming): names of C
extern "C" {

uint32_t proskill_executor_abi() { return PROSKILL_EXECUTOR_ABI; }

const char* proskill_error_text() { return embed::keptText(); }

proskill_error proskill_program_load(const char* file, proskill_program** program) {
  return answer([&]() -> Done {
    if (!file) return isNull("file");
    if (!program) return isNull("program");
    auto loaded = embed::loadProgram(file);
    if (!loaded) return std::unexpected(std::move(loaded.error()));
    *program = std::make_unique<proskill_program>(std::move(*loaded)).release();
    return {};
  });
}

void proskill_program_free(proskill_program* program) {
  const std::unique_ptr<proskill_program> owner(program);
}

proskill_error proskill_executor_new(const proskill_program* program,
                                     const proskill_options* options,
                                     proskill_executor** executor) {
  return answer([&]() -> Done {
    if (!program) return isNull("program");
    if (!executor) return isNull("executor");
    auto made = proskill_executor::make(*program, options);
    if (!made) return std::unexpected(std::move(made.error()));
    *executor = made->release();
    return {};
  });
}

proskill_error proskill_executor_free(proskill_executor* executor) {
  if (!executor) return PROSKILL_OK;
  const auto may = exclusive(executor, [] { return Done(); });
  const std::unique_ptr<proskill_executor> owner(may == PROSKILL_OK ? executor : nullptr);
  return may;
}

proskill_error proskill_executor_perform(proskill_executor* executor, const char* skill,
                                         proskill_begin begin, proskill_stop stop, void* data) {
  return exclusive(executor, [&]() -> Done {
    if (!skill) return isNull("skill");
    if (!begin) return isNull("begin");
    return executor->perform(skill, {begin, stop, data});
  });
}

proskill_error proskill_executor_observe(proskill_executor* executor, proskill_observer observer,
                                         void* data) {
  return exclusive(executor, [&] { return executor->observe(observer, data); });
}

proskill_error proskill_executor_record(proskill_executor* executor, const char* file) {
  return exclusive(executor, [&]() -> Done {
    if (!file) return isNull("file");
    return executor->record(file);
  });
}

proskill_error proskill_executor_serve_view(proskill_executor* executor,
                                            const proskill_view_options* options) {
  return exclusive(executor, [&] { return executor->serveView(options); });
}

const char* proskill_executor_view_address(const proskill_executor* executor) {
  return executor ? executor->viewAddress().c_str() : "";
}

proskill_error proskill_executor_start(proskill_executor* executor) {
  return exclusive(executor, [&] { return executor->start(); });
}

proskill_error proskill_executor_proceed(proskill_executor* executor) {
  return exclusive(executor, [&] { return executor->proceed(); });
}

proskill_error proskill_executor_run(proskill_executor* executor) {
  return exclusive(executor, [&] { return executor->runToEnd(); });
}

int proskill_executor_descriptor(const proskill_executor* executor) {
  return executor ? executor->descriptor() : -1;
}

double proskill_executor_timeout(proskill_executor* executor) {
  return executor ? executor->timeout() : 0;
}

proskill_phase proskill_executor_phase(const proskill_executor* executor) {
  return executor ? executor->phase() : PROSKILL_READY;
}

proskill_end proskill_executor_end(const proskill_executor* executor) {
  return executor ? executor->end() : PROSKILL_NOT_ENDED;
}

const char* proskill_executor_outcome(const proskill_executor* executor) {
  return executor ? executor->outcome() : "";
}

double proskill_executor_time(const proskill_executor* executor) {
  const auto date = executor ? executor->date() : 0;
  return static_cast<double>(date) / static_cast<double>(runtime::kSecond);
}

uint64_t proskill_executor_steps(const proskill_executor* executor) {
  return executor ? executor->steps() : 0;
}

uint64_t proskill_executor_faults(const proskill_executor* executor) {
  return executor ? executor->faults() : 0;
}

const char* proskill_executor_recording_error(const proskill_executor* executor) {
  return executor ? executor->recordingError().c_str() : "";
}

proskill_error proskill_executor_value(proskill_executor* executor, const char* name,
                                       const char** value) {
  return answer([&]() -> Done {
    if (!executor) return isNull("executor");
    if (!name) return isNull("name");
    if (!value) return isNull("value");
    const auto found = executor->value(name);
    if (!found) return std::unexpected(found.error());
    *value = *found;
    return {};
  });
}

const char* proskill_executor_name(const proskill_executor* executor, size_t index) {
  return executor ? executor->nameOfValue(index) : nullptr;
}

proskill_error proskill_executor_finish(proskill_executor* executor, proskill_run run,
                                        const char* result) {
  return proskill_executor_finish_after(executor, run, 0, result);
}

proskill_error proskill_executor_finish_after(proskill_executor* executor, proskill_run run,
                                              double seconds, const char* result) {
  return toPlatform(executor, "", "", [&](embed::FunctionPlatform& platform) -> Done {
    const auto delay = embed::timeOf(seconds, "seconds");
    return delay ? platform.finish(run, result, *delay) : std::unexpected(delay.error());
  });
}

proskill_error proskill_executor_fail(proskill_executor* executor, proskill_run run,
                                      const char* why) {
  return toPlatform(executor, why, "why",
                    [&](embed::FunctionPlatform& platform) { return platform.fail(run, why); });
}

bool proskill_executor_stop_requested(const proskill_executor* executor, proskill_run run) {
  return executor && executor->isAsked(run);
}

proskill_error proskill_executor_report(proskill_executor* executor, const char* event) {
  return proskill_executor_report_after(executor, 0, event);
}

proskill_error proskill_executor_report_after(proskill_executor* executor, double seconds,
                                              const char* event) {
  return toPlatform(executor, event, "event", [&](embed::FunctionPlatform& platform) -> Done {
    const auto delay = embed::timeOf(seconds, "seconds");
    return delay ? platform.send(event, false, *delay) : std::unexpected(delay.error());
  });
}

proskill_error proskill_executor_interrupt(proskill_executor* executor, const char* skill) {
  return toPlatform(executor, skill, "skill", [&](embed::FunctionPlatform& platform) {
    return platform.send(skill, true, 0);
  });
}

proskill_error proskill_executor_log(proskill_executor* executor, const char* text) {
  return toPlatform(executor, text, "text", [&](embed::FunctionPlatform& platform) {
    platform.log(text);
    return Done();
  });
}

void proskill_executor_stop(proskill_executor* executor) {
  if (executor) executor->stop();
}

} // extern "C"
// NOLINTEND(readability-identifier-naming)
