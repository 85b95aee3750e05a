#include "tests/lsp/support/session.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace proskill::test {

namespace {

/// Only a server that hangs takes so long.
constexpr std::chrono::seconds kPatience{60};

} // namespace

std::string Pipe::read() {
  std::unique_lock lock(mutex);
  wake.wait(lock, [&] { return closed || !toServer.empty(); });
  if (toServer.empty()) return {};
  auto bytes = std::move(toServer.front());
  toServer.pop_front();
  return bytes;
}

bool Pipe::write(std::string_view bytes) {
  const std::lock_guard lock(mutex);
  frames.feed(bytes);
  while (auto next = frames.next()) toClient.push_back(Json::parse(std::get<std::string>(*next)));
  wake.notify_all();
  return true;
}

void Pipe::close() { hangUp(); }

void Pipe::send(std::string bytes) {
  const std::lock_guard lock(mutex);
  toServer.push_back(std::move(bytes));
  wake.notify_all();
}

void Pipe::hangUp() {
  const std::lock_guard lock(mutex);
  closed = true;
  wake.notify_all();
}

Json Pipe::receive() {
  std::unique_lock lock(mutex);
  REQUIRE(wake.wait_for(lock, kPatience, [&] { return !toClient.empty(); }));
  auto message = std::move(toClient.front());
  toClient.pop_front();
  return message;
}

bool Pipe::hasMore() {
  const std::lock_guard lock(mutex);
  return !toClient.empty();
}

Session::Session(Options chosen)
    : options(std::move(chosen)),
      server(pipe, options.disk,
             {.version = "1",
              .threads = 2,
              .debounce = options.debounce,
              .log = {},
              .worker = options.worker}),
      running(std::async(std::launch::async, [this] { return server.run(); })) {}

Session::~Session() {
  pipe.hangUp();
  if (running.valid()) running.wait();
}

void Session::initialize() {
  const auto tags = [](std::vector<int> known) { return Json{{"valueSet", known}}; };
  Json text = {
      {"publishDiagnostics", {{"relatedInformation", true}, {"tagSupport", tags({1, 2})}}},
      {"completion", {{"completionItem", {{"snippetSupport", true}, {"tagSupport", tags({1})}}}}},
      {"documentSymbol", {{"hierarchicalDocumentSymbolSupport", true}}},
      {"hover", {{"contentFormat", Json::array({"markdown"})}}}};
  if (options.pull) text["diagnostic"] = Json::object();
  Json capabilities = {{"textDocument", text},
                       {"workspace", {{"workspaceEdit", {{"documentChanges", true}}}}},
                       {"experimental", {{"verdicts", "all"}}}};
  capabilities["general"]["staleRequestSupport"] = {{"cancel", true},
                                                    {"retryOnContentModified", options.retried}};
  capabilities.merge_patch(options.capabilities);
  if (!options.encoding.empty())
    capabilities["general"]["positionEncodings"] = Json::array({options.encoding});
  auto answer = result("initialize", {{"processId", nullptr},
                                      {"rootUri", nullptr},
                                      {"capabilities", capabilities},
                                      {"initializationOptions", options.initializationOptions}});
  CHECK(answer["capabilities"]["positionEncoding"] ==
        (options.encoding.empty() ? "utf-16" : options.encoding));
  notify("initialized", Json::object());
}

void Session::notify(std::string_view method, const Json& params) {
  sendBody(rpc::notification(method, params));
}

int Session::send(std::string_view method, const Json& params) {
  sendBody(rpc::request(++lastId, method, params));
  return lastId;
}

Json Session::answer(int id) {
  while (true) {
    auto message = receive();
    if (!message.contains("method") && message["id"] == id) return message;
    notifications.push_back(std::move(message));
  }
}

Json Session::result(std::string_view method, const Json& params) {
  auto message = ask(method, params);
  INFO(message.dump());
  REQUIRE(message.contains("result"));
  return message["result"];
}

Json Session::notified(std::string_view method) {
  for (auto it = notifications.begin(); it != notifications.end(); ++it)
    if (it->contains("method") && (*it)["method"] == method) {
      auto params = (*it)["params"];
      notifications.erase(it);
      return params;
    }
  while (true) {
    auto message = receive();
    if (message.contains("method") && message["method"] == method) return message["params"];
    notifications.push_back(std::move(message));
  }
}

bool Session::wasNotified(std::string_view method) const {
  return std::ranges::any_of(notifications, [&](const Json& it) {
    return it.contains("method") && it["method"] == method;
  });
}

void Session::open(const std::string& uri, const std::string& text, int version) {
  notify("textDocument/didOpen",
         {{"textDocument",
           {{"uri", uri}, {"languageId", "proskill"}, {"version", version}, {"text", text}}}});
}

void Session::change(const std::string& uri, int version, Json range, const std::string& text) {
  Json change = {{"text", text}};
  if (!range.is_null()) change["range"] = std::move(range);
  notify("textDocument/didChange", {{"textDocument", {{"uri", uri}, {"version", version}}},
                                    {"contentChanges", Json::array({change})}});
}

void Session::close(const std::string& uri) {
  notify("textDocument/didClose", {{"textDocument", {{"uri", uri}}}});
}

Json Session::at(std::string_view method, const std::string& uri, unsigned line, unsigned character,
                 Json more) {
  more["textDocument"] = {{"uri", uri}};
  more["position"] = {{"line", line}, {"character", character}};
  return result(method, more);
}

Json rangeOf(unsigned line, unsigned from, unsigned to) {
  return {{"start", {{"line", line}, {"character", from}}},
          {"end", {{"line", line}, {"character", to}}}};
}

} // namespace proskill::test
