#include "host/runs.h"

#include <sys/eventfd.h>
#include <unistd.h>
#include <utility>

namespace proskill::host {

namespace {

void makeReadable(int descriptor) {
  const std::uint64_t one = 1;
  if (descriptor >= 0) (void)!::write(descriptor, &one, sizeof one);
}

} // namespace

Arguments::Arguments(const nlohmann::ordered_json& list) {
  for (const auto& given : list) {
    proskill_value value{PROSKILL_NONE, 0, 0, ""};
    if (given.is_number_integer()) {
      value.type = PROSKILL_INTEGER;
      value.integer = given.get<std::int64_t>();
      value.number = static_cast<double>(value.integer);
    } else if (given.is_number()) {
      value.type = PROSKILL_FLOAT;
      value.number = given.get<double>();
    } else if (given.is_boolean()) {
      value.type = PROSKILL_BOOLEAN;
      value.integer = given.get<bool>() ? 1 : 0;
    } else if (given.is_string()) {
      value.type = PROSKILL_STRING;
      value.string = texts.emplace_back(given.get<std::string>()).c_str();
    }
    values.push_back(value);
  }
}

void Runs::begin(proskill_run run, const std::string& name) {
  const Lock lock(mutex);
  all[run].skill = &name;
}

std::optional<Runs::Ended> Runs::end(proskill_run run) {
  Lock lock(mutex);
  auto found = all.find(run);
  changed.wait(lock, [&] {
    found = all.find(run); // another thread may have ended the run meanwhile
    if (found == all.end()) return true;
    const auto caller = found->second.caller;
    return caller == std::thread::id() || caller == std::this_thread::get_id();
  });
  if (found == all.end()) return std::nullopt;
  const Ended ended{found->second.isAsked, found->second.isAbandoned};
  if (found->second.descriptor >= 0) ::close(found->second.descriptor);
  all.erase(found);
  changed.notify_all();
  return ended;
}

void Runs::askToStop(proskill_run run) {
  Lock lock(mutex);
  const auto found = all.find(run);
  if (found == all.end() || found->second.isAsked) return;
  found->second.isAsked = true;
  makeReadable(found->second.descriptor);
  changed.notify_all();
  callOnStop(lock, run);
}

/// \pre the run exists
void Runs::callOnStop(Lock& lock, proskill_run run) {
  auto& of = all.at(run);
  auto* const call = std::exchange(of.onStop, nullptr);
  if (!call) return;
  auto* const data = of.data;
  of.caller = std::this_thread::get_id();
  lock.unlock(); // the callback may end the run
  call(run, data);
  lock.lock();
  if (const auto found = all.find(run); found != all.end()) found->second.caller = {};
  changed.notify_all();
}

void Runs::abandon(proskill_run run) {
  const Lock lock(mutex);
  if (const auto found = all.find(run); found != all.end()) found->second.isAbandoned = true;
}

std::vector<std::string> Runs::stopAll(std::chrono::nanoseconds patience) {
  std::vector<proskill_run> running;
  {
    const Lock lock(mutex);
    for (const auto& [run, _] : all) running.push_back(run);
  }
  for (const auto run : running) askToStop(run);
  Lock lock(mutex);
  changed.wait_for(lock, patience, [this] { return all.empty(); });
  std::vector<std::string> left;
  for (const auto& [_, run] : all) left.push_back(*run.skill);
  return left;
}

bool Runs::isAsked(proskill_run run) const {
  const Lock lock(mutex);
  const auto found = all.find(run);
  return found == all.end() || found->second.isAsked;
}

bool Runs::wait(proskill_run run, std::chrono::nanoseconds time) const {
  Lock lock(mutex);
  return changed.wait_for(lock, time, [&] {
    const auto found = all.find(run);
    return found == all.end() || found->second.isAsked;
  });
}

int Runs::descriptor(proskill_run run) {
  const Lock lock(mutex);
  const auto found = all.find(run);
  if (found == all.end()) return -1;
  auto& made = found->second.descriptor;
  if (made < 0) {
    made = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    if (found->second.isAsked) makeReadable(made);
  }
  return made;
}

void Runs::onStop(proskill_run run, OnStop* call, void* data) {
  Lock lock(mutex);
  const auto found = all.find(run);
  if (found == all.end()) return;
  found->second.onStop = call;
  found->second.data = data;
  if (found->second.isAsked) callOnStop(lock, run);
}

const char* Runs::skill(proskill_run run) const {
  const Lock lock(mutex);
  const auto found = all.find(run);
  return found == all.end() ? "" : found->second.skill->c_str();
}

} // namespace proskill::host
