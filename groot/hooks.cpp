#include "groot/hooks.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace proskill::groot {

namespace {

using Json = nlohmann::json;

/// As long as BehaviorTree.CPP waits for a sign of life.
constexpr std::uint64_t kSilence = 5'000'000; ///< microseconds
constexpr int kBreakpointMode = 0;
constexpr std::string_view kGoOn = "SKIPPED";
constexpr const char* kUnknownNode = "Node ID not found";
/// By status.
constexpr std::array<std::string_view, 5> kStatuses{"IDLE", "RUNNING", "SUCCESS", "FAILURE", kGoOn};

bool isStatus(std::string_view word) { return std::ranges::count(kStatuses, word) > 0; }

/// Whether an unlocked node is to end with a status, instead of going on as it would.
bool isEnd(std::string_view desired) { return desired == "SUCCESS" || desired == "FAILURE"; }

} // namespace

/// A breakpoint in a request.
struct Hooks::Request {
  std::uint64_t uid = 0;
  std::int64_t position = 0;
  std::int64_t mode = kBreakpointMode;
  Hook hook;

  [[nodiscard]] Key key() const { return {static_cast<Position>(position), static_cast<Uid>(uid)}; }
  [[nodiscard]] bool isAt(std::size_t nodes) const {
    return uid >= 1 && uid <= nodes && (position == 0 || position == 1);
  }
  [[nodiscard]] bool isOf(const Stop& stop) const {
    return stop.uid == uid && static_cast<std::int64_t>(stop.position) == position;
  }

  /// The error is a message.
  static std::expected<Request, std::string> read(const Json& json) {
    if (!json.is_object()) return std::unexpected("a breakpoint must be a JSON object");
    try {
      return Request{
          .uid = json.at("uid").get<std::uint64_t>(),
          .position = json.at("position").get<std::int64_t>(),
          .mode = json.value("mode", std::int64_t{kBreakpointMode}),
          .hook = {.isEnabled = json.value("enabled", true),
                   .isOnce = json.value("once", false) || json.value("remove_when_done", false),
                   .desired = json.value("desired_status", std::string(kGoOn))}};
    } catch (const Json::exception&) {
      return std::unexpected("a breakpoint must have numbers `uid` and `position`; `enabled` and "
                             "`once` are booleans, `desired_status` is a string");
    }
  }

  /// One, or the members of a list.
  static std::expected<std::vector<Request>, std::string> readAll(std::string_view text) {
    const auto json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) return std::unexpected("the second part is not JSON");
    std::vector<Request> all;
    for (const auto& each : json.is_array() ? json : Json::array({json})) {
      auto request = read(each);
      if (!request) return std::unexpected(std::move(request.error()));
      all.push_back(std::move(*request));
    }
    return all;
  }

  static std::expected<Request, std::string> readOne(std::string_view text) {
    auto all = readAll(text);
    if (!all) return std::unexpected(std::move(all.error()));
    if (all->size() != 1) return std::unexpected("the second part must be one object");
    return std::move(all->front());
  }
};

Hooks::Hooks(std::size_t ofTree, Breakpoints& by, std::string why, Publish tell)
    : nodes(ofTree), breakpoints(by), whyNot(std::move(why)), publish(std::move(tell)) {}

std::string Hooks::insert(std::string_view text) {
  const auto requests = Request::readAll(text);
  if (!requests) return requests.error();
  for (const auto& request : *requests)
    if (auto why = whyNotInserted(request); !why.empty()) return why;
  for (const auto& request : *requests) {
    all[request.key()] = request.hook;
    arm(request.key(), request.hook);
  }
  show();
  return "";
}

std::string Hooks::whyNotInserted(const Request& request) const {
  if (!breakpoints.canStop()) return whyNot;
  if (!request.isAt(nodes)) return kUnknownNode;
  if (!isStatus(request.hook.desired)) return "`desired_status` is not a status";
  if (request.mode != kBreakpointMode)
    return "nodes cannot be replaced: how a node ends is decided by the program";
  return "";
}

std::string Hooks::remove(std::string_view text) {
  const auto request = Request::readOne(text);
  if (!request) return request.error();
  if (!request->isAt(nodes) || !all.contains(request->key())) return kUnknownNode;
  erase(request->key());
  show();
  return "";
}

std::string Hooks::unlock(std::string_view text) {
  const auto request = Request::readOne(text);
  if (!request) return request.error();
  const auto found = request->isAt(nodes) ? all.find(request->key()) : all.end();
  if (found == all.end()) return kUnknownNode;
  followRun();
  const auto stop =
      std::ranges::find_if(stopped, [&](const Stop& it) { return request->isOf(it); });
  if (stop == stopped.end()) return "the run has not stopped at this breakpoint";
  if (auto why = whyNotUnlocked(*stop, request->hook.desired); !why.empty()) return why;
  if (request->hook.isOnce || found->second.isOnce)
    erase(request->key());
  else
    pass(request->key());
  show();
  return "";
}

/// A program decides itself how its nodes end.
std::string Hooks::whyNotUnlocked(const Stop& stop, std::string_view desired) const {
  if (!isStatus(desired)) return "`desired_status` is not a status";
  if (!isEnd(desired)) return "";
  if (stop.position == Position::Pre)
    return "a node cannot be skipped with a status: how it ends is decided by the program; unlock "
           "it "
           "with SKIPPED";
  const auto is = kStatuses.at(static_cast<std::size_t>(stop.status));
  if (desired == is) return "";
  return "the node has ended with " + std::string(is) + ", which cannot be changed";
}

void Hooks::removeAll() {
  while (!all.empty()) erase(all.begin()->first);
}

void Hooks::disableAll() {
  for (auto& [key, hook] : all) {
    hook.isEnabled = false;
    arm(key, hook);
  }
}

std::string Hooks::dump() const {
  auto list = Json::array();
  for (const auto& [key, hook] : all)
    list.push_back({{"enabled", hook.isEnabled},
                    {"uid", key.second},
                    {"mode", kBreakpointMode},
                    {"once", hook.isOnce},
                    {"desired_status", hook.desired},
                    {"position", static_cast<int>(key.first)}});
  return list.dump();
}

/// Sets the breakpoint if it is enabled; otherwise the run does not stop at it, or goes on.
void Hooks::arm(const Key& key, const Hook& hook) {
  const bool isOn = hook.isEnabled && isHeard;
  breakpoints.set(key.second, key.first, isOn);
  if (!isOn) pass(key);
}

void Hooks::erase(const Key& key) {
  all.erase(key);
  arm(key, {.isEnabled = false});
}

/// The run need not wait for this breakpoint any more.
void Hooks::pass(const Key& key) {
  followRun();
  const auto isIt = [&](const Stop& stop) { return Key(stop.position, stop.uid) == key; };
  if (stopped.empty()) return;
  if (isIt(stopped.front())) isShown = false;
  std::erase_if(stopped, isIt);
  if (stopped.empty()) breakpoints.release();
}

void Hooks::followRun() {
  for (Stop stop; breakpoints.takeStop(stop);) {
    if (stop.isFirst) forgetStops();
    stopped.push_back(stop);
  }
  if (!stopped.empty() && !breakpoints.isHeld()) forgetStops();
  show();
}

/// Somebody else has let the run go on.
void Hooks::forgetStops() {
  stopped.clear();
  isShown = false;
}

/// Announces the first stop to viewers.
void Hooks::show() {
  if (stopped.empty() || isShown) return;
  isShown = true;
  publish(stopped.front().uid);
}

void Hooks::hear(std::uint64_t time) {
  heard = time;
  if (isHeard) return;
  isHeard = true;
  for (const auto& [key, hook] : all) arm(key, hook);
}

void Hooks::notice(std::uint64_t time) {
  if (!isHeard || all.empty() || time < heard + kSilence) return;
  isHeard = false;
  for (const auto& [key, hook] : all) arm(key, hook);
}

std::optional<std::uint64_t> Hooks::nextNotice(std::uint64_t time) const {
  if (!isHeard || all.empty()) return std::nullopt;
  return heard + kSilence - std::min(time, heard + kSilence);
}

} // namespace proskill::groot
