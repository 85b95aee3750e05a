#include "tests/dap/client.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/where.h"

namespace proskill::test {

namespace {

process::Child startAdapter() {
  auto started = process::Child::start({PROSKILL_PROGRAM, "dap"});
  REQUIRE(started);
  return std::move(*started);
}

} // namespace

DapClient::DapClient() : child(startAdapter()) {}

/// Exchanges available bytes; returns false at the end.
bool DapClient::pump() {
  auto done = child.exchange(unsent, std::chrono::milliseconds(1000));
  unsent.erase(0, done.sent);
  frames.feed(done.received);
  while (auto next = frames.next()) messages.push_back(Json::parse(std::get<std::string>(*next)));
  ended = done.ended;
  return !ended;
}

int DapClient::send(const std::string& command, Json arguments) {
  Json message{{"seq", ++last}, {"type", "request"}, {"command", command}};
  message["arguments"] = std::move(arguments);
  sendRaw(rpc::frame(message.dump()));
  return last;
}

void DapClient::sendRaw(const std::string& bytes) {
  unsent += bytes;
  while (!unsent.empty() && pump()) {
  }
}

Json DapClient::waitFor(const std::function<bool(const Json&)>& isIt, const std::string& what) {
  for (int patience = 0; patience < 120; ++patience) {
    for (auto it = messages.begin(); it != messages.end(); ++it)
      if (isIt(*it)) {
        auto found = std::move(*it);
        messages.erase(it);
        return found;
      }
    if (ended) break;
    pump();
  }
  FAIL("there is no " << what);
  return {};
}

Json DapClient::answer(int sequence) {
  return waitFor(
      [&](const Json& it) { return it["type"] == "response" && it["request_seq"] == sequence; },
      "answer");
}

Json DapClient::event(const std::string& name) {
  return waitFor([&](const Json& it) { return it["type"] == "event" && it["event"] == name; },
                 "event " + name)["body"];
}

bool DapClient::said(std::string_view words) const {
  return std::ranges::any_of(messages, [&](const Json& it) {
    return it["type"] == "event" && it["event"] == "output" &&
           it["body"]["output"].get<std::string>().contains(words);
  });
}

std::string DapClient::ending() {
  while (pump()) {
  }
  return child.ending();
}

Json DapClient::ask(const std::string& command, Json arguments) {
  return answer(send(command, std::move(arguments)));
}

Json DapClient::result(const std::string& command, Json arguments) {
  auto message = ask(command, std::move(arguments));
  INFO(message.dump());
  REQUIRE(message["success"] == true);
  return message["body"];
}

Json DapClient::start(const Json& launch) {
  result("initialize", {{"adapterID", "proskill"}});
  result("launch", launch);
  event("initialized");
  result("configurationDone");
  return event("stopped");
}

Json DapClient::top(const Json& stopped) {
  return result("stackTrace", {{"threadId", stopped["threadId"]}})["stackFrames"][0];
}

std::map<std::string, std::string> DapClient::values(const Json& frame, const std::string& scope) {
  std::map<std::string, std::string> found;
  const auto scopes = result("scopes", {{"frameId", frame["id"]}});
  for (const auto& it : scopes["scopes"]) {
    if (it["name"] != scope) continue;
    const auto all = result("variables", {{"variablesReference", it["variablesReference"]}});
    for (const auto& variable : all["variables"]) found[variable["name"]] = variable["value"];
  }
  return found;
}

} // namespace proskill::test
