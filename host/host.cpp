#include "host/host.h"

#include "host/connection.h"
#include "host/crash.h"
#include "host/library.h"
#include "host/runs.h"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <thread>
#include <unistd.h>

namespace proskill::host {

namespace {

constexpr int kProtocol = 1;
/// Time that actions have to stop after the run; `proskill run` waits for five seconds.
constexpr auto kPatience = std::chrono::seconds(4);

/// Implements the functions of platform.h. They are plain functions without a context, so there is
/// one host, which lives as long as the process.
class Host {
public:
  explicit Host(std::string library) : path(std::move(library)) {}

  int run(const std::map<std::string, std::string>& named);

  void finish(proskill_run run, const char* result) {
    finish(run, result ? std::optional<std::string>(result) : std::nullopt, false);
  }
  void fail(proskill_run run, const std::string& why) {
    const auto ended = runs.end(run);
    if (!ended || !ended->isAbandoned)
      connection.send({{"type", "failed"}, {"run", run}, {"text", why}});
  }
  void say(Json message);

  Runs runs;
  double speed = 1;

private:
  void greet(const Json& hello, const std::map<std::string, std::string>& named);
  void giveUp(const std::string& why, const std::string& skill);
  void sayReady();
  void start(const Json& message);
  void perform(proskill_run run, const std::string& skill, Function::Perform* function,
               const Arguments& arguments);
  void finish(proskill_run run, const std::optional<std::string>& result, bool hasReturned);
  int end();

  std::string path;
  Connection connection;
  std::optional<Library> library;
  std::map<std::string, Function> functions;
  std::mutex beginning;
  std::vector<Json> early; ///< messages sent before `ready`
  bool isReady = false;
  std::atomic<bool> isOver = false;
};

Host* theHost = nullptr; // set before the library is loaded

/// Converts seconds of the run's clock to real time.
std::chrono::nanoseconds realTime(double seconds) {
  constexpr double kLongest = 1e9;
  const double real = seconds / theHost->speed;
  return std::chrono::nanoseconds(std::llround((real > 0 ? std::min(real, kLongest) : 0) * 1e9));
}

std::string textOf(const char* text) { return text ? text : ""; }

constexpr proskill_host kHost{
    .abi = PROSKILL_ABI,
    .size = sizeof(proskill_host),
    .stop_requested = [](proskill_run run) { return theHost->runs.isAsked(run); },
    .wait = [](proskill_run run,
               double seconds) { return theHost->runs.wait(run, realTime(seconds)); },
    .stop_descriptor = [](proskill_run run) { return theHost->runs.descriptor(run); },
    .on_stop = [](proskill_run run, Runs::OnStop* call,
                  void* data) { theHost->runs.onStop(run, call, data); },
    .finish = [](proskill_run run, const char* result) { theHost->finish(run, result); },
    .fail = [](proskill_run run, const char* why) { theHost->fail(run, textOf(why)); },
    .skill = [](proskill_run run) { return theHost->runs.skill(run); },
    .report =
        [](const char* event) {
          theHost->say({{"type", "event"}, {"name", textOf(event)}});
        },
    .interrupt =
        [](const char* skill) {
          theHost->say({{"type", "interrupt"}, {"skill", textOf(skill)}});
        },
    .log =
        [](const char* text) {
          theHost->say({{"type", "log"}, {"text", textOf(text)}});
        },
    .speed = [] { return theHost->speed; },
};

int Host::run(const std::map<std::string, std::string>& named) {
  while (const auto message = connection.receive()) {
    if (!message->is_object()) continue;
    const auto type = message->value("type", "");
    if (type == "hello") greet(*message, named);
    if (type == "start") start(*message);
    if (type == "stop") runs.askToStop(message->value("run", proskill_run{0}));
    if (type == "abandon") runs.abandon(message->value("run", proskill_run{0}));
    if (type == "end") break;
  }
  return end();
}

void Host::greet(const Json& hello, const std::map<std::string, std::string>& named) {
  speed = hello.value("speed", 1.0);
  std::vector<std::string> skills;
  for (const auto& skill : hello["skills"]) skills.push_back(skill.value("name", ""));
  nameInCrashes("", connection);
  auto loaded = Library::load(path, kHost);
  if (!loaded) return giveUp(loaded.error(), "");
  library.emplace(std::move(*loaded));
  auto found = library->functionsFor(skills, named);
  if (!found) return giveUp(found.error().why, found.error().skill);
  functions = std::move(*found);
  if (const auto why = library->open(); !why.empty()) return giveUp(why, "");
  sayReady();
}

void Host::giveUp(const std::string& why, const std::string& skill) {
  Json message{{"type", "failed"}, {"text", why}};
  if (!skill.empty()) message["skill"] = skill;
  connection.send(message);
}

void Host::sayReady() {
  const std::lock_guard lock(beginning);
  connection.send({{"type", "ready"}, {"protocol", kProtocol}});
  for (const auto& message : early) connection.send(message);
  early.clear();
  isReady = true;
}

void Host::say(Json message) {
  if (isOver) return;
  {
    const std::lock_guard lock(beginning);
    if (!isReady) return early.push_back(std::move(message));
  }
  connection.send(message);
}

void Host::start(const Json& message) {
  const auto run = message.value("run", proskill_run{0});
  const auto found = functions.find(message.value("skill", ""));
  if (found == functions.end()) return fail(run, "its skill has no function");
  const auto& [skill, function] = *found;
  runs.begin(run, skill);
  Arguments arguments(message.value("arguments", Json::array()));
  if (function.begin) {
    nameInCrashes(skill, connection);
    function.begin(run, arguments.data(), arguments.size());
    nameInCrashes("", connection);
    return;
  }
  try {
    std::thread([this, run, &skill = skill, perform = function.perform,
                 given = std::move(arguments)] {
      this->perform(run, skill, perform, given);
    }).detach(); // at the end of the run, main waits for this thread's action
  } catch (const std::system_error& error) {
    fail(run, fmt::format("there is no thread for it: {}", error.what()));
  }
}

void Host::perform(proskill_run run, const std::string& skill, Function::Perform* function,
                   const Arguments& arguments) {
  nameInCrashes(skill, connection);
  try {
    const char* result = function(run, arguments.data(), arguments.size());
    finish(run, result ? std::optional<std::string>(result) : std::nullopt, true);
  } catch (const std::exception& error) {
    fail(run, error.what());
  }
}

/// \param hasReturned the action is a blocking function, which may have called `fail` before it
/// returned
void Host::finish(proskill_run run, const std::optional<std::string>& result, bool hasReturned) {
  const auto ended = runs.end(run);
  if (ended ? ended->isAbandoned : hasReturned) return;
  if (result)
    connection.send({{"type", "result"}, {"run", run}, {"result", *result}});
  else
    connection.send({{"type", "stopped"}, {"run", run}});
}

int Host::end() {
  const auto left = runs.stopAll(kPatience);
  isOver = true;
  if (left.empty() && library) library->close();
  if (!left.empty()) fmt::print(stderr, "actions that did not stop: {}\n", fmt::join(left, ", "));
  std::fflush(nullptr);
  _exit(0); // threads of the library may still use what destructors would destroy
}

} // namespace

int runLibrary(const std::string& path, const std::map<std::string, std::string>& functions) {
  Host host(path);
  theHost = &host;
  return host.run(functions);
}

} // namespace proskill::host
