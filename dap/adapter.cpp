#include "dap/adapter.h"

#include "ide/description/markup.h"
#include "rpc/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <thread>

namespace proskill::dap {

namespace {

constexpr std::string_view kNotLaunched = "no session is running";

std::string commandOf(const Json& message) {
  auto command = message.find("command");
  return command != message.end() && command->is_string() ? command->get<std::string>() : "";
}

bool endsAll(const Json& message) {
  const auto command = commandOf(message);
  return command == "disconnect" || command == "terminate";
}

/// Requests that are allowed before a session has begun.
bool needsNothing(std::string_view command) {
  constexpr std::array<std::string_view, 6> kAny{"initialize",        "launch",
                                                 "disconnect",        "terminate",
                                                 "configurationDone", "setExceptionBreakpoints"};
  return std::ranges::find(kAny, command) != kAny.end();
}

std::string_view reasonOf(Stop why) {
  switch (why) {
  case Stop::Step: return "step";
  case Stop::Breakpoint: return "breakpoint";
  case Stop::Variable: return "data breakpoint";
  case Stop::Start: return "entry";
  case Stop::End: return "end";
  case Stop::TooLong: return "pause";
  }
  return "step";
}

} // namespace

Adapter::Adapter(rpc::Connection& with, const analysis::FileSystem& files, AdapterOptions chosen)
    : connection(with), disk(files), options(std::move(chosen)), outbox(with) {}

int Adapter::run() {
  const std::jthread reader([this] { readStream(); });
  while (!finished) {
    auto message = take();
    if (!message) break;
    handle(*message);
  }
  connection.close();
  return finished ? 0 : 1;
}

void Adapter::readStream() {
  rpc::FrameReader frames;
  for (auto bytes = connection.read(); !bytes.empty(); bytes = connection.read()) {
    frames.feed(bytes);
    while (auto next = frames.next()) {
      const auto* body = std::get_if<std::string>(&*next);
      auto message = body ? Json::parse(*body, nullptr, false) : Json();
      if (!message.is_object()) continue; // the protocol defines no answer to an invalid message
      if (endsAll(message)) cancellation.cancel();
      const std::lock_guard lock(mutex);
      queue.push_back(std::move(message));
      wake.notify_one();
    }
  }
  cancellation.cancel();
  const std::lock_guard lock(mutex);
  streamEnded = true;
  wake.notify_one();
}

std::optional<Json> Adapter::take() {
  std::unique_lock lock(mutex);
  wake.wait(lock, [&] { return streamEnded || !queue.empty(); });
  if (queue.empty()) return std::nullopt;
  auto message = std::move(queue.front());
  queue.pop_front();
  return message;
}

const std::map<std::string, Adapter::Handler, std::less<>>& Adapter::handlers() {
  static const std::map<std::string, Handler, std::less<>> all{
      {"initialize", &Adapter::initialize},
      {"launch", &Adapter::launch},
      {"configurationDone", &Adapter::configurationDone},
      {"disconnect", &Adapter::disconnect},
      {"terminate", &Adapter::setNothing},
      {"setBreakpoints", &Adapter::setBreakpoints},
      {"setExceptionBreakpoints", &Adapter::setNothing},
      {"dataBreakpointInfo", &Adapter::dataBreakpointInfo},
      {"setDataBreakpoints", &Adapter::setDataBreakpoints},
      {"threads", &Adapter::threads},
      {"stackTrace", &Adapter::stackTrace},
      {"scopes", &Adapter::scopes},
      {"variables", &Adapter::variables},
      {"evaluate", &Adapter::evaluate},
      {"next", &Adapter::next},
      {"stepIn", &Adapter::stepIn},
      {"stepOut", &Adapter::stepOut},
      {"stepBack", &Adapter::stepBack},
      {"continue", &Adapter::resume},
      {"reverseContinue", &Adapter::reverseContinue},
      {"pause", &Adapter::pause},
      {"restart", &Adapter::restart},
      {"stepInTargets", &Adapter::stepInTargets},
      {"proskill/choices", &Adapter::choices},
      {"proskill/choose", &Adapter::choose},
      {"proskill/position", &Adapter::position},
      {"proskill/goTo", &Adapter::goTo}};
  return all;
}

void Adapter::handle(const Json& message) {
  if (message.value("type", Json()) != "request") return;
  const auto command = commandOf(message);
  const auto found = handlers().find(command);
  const Json arguments = message.value("arguments", Json::object());
  Answer answer = std::unexpected(fmt::format("there is no request `{}`", command));
  try {
    if (found != handlers().end() && !player && !needsNothing(command))
      answer = std::unexpected(std::string(kNotLaunched));
    else if (found != handlers().end())
      answer = (this->*found->second)(arguments);
  } catch (const std::exception& error) {
    answer = std::unexpected(fmt::format("`{}` failed: {}", command, error.what()));
  }
  Json response{{"type", "response"},
                {"request_seq", message.value("seq", Json(0))},
                {"command", command},
                {"success", answer.has_value()}};
  if (answer) {
    response["body"] = *answer;
  } else {
    response["message"] = answer.error();
    response["body"] = {{"error", {{"id", 1}, {"format", answer.error()}, {"showUser", true}}}};
  }
  send(std::move(response));
  if (answer) afterwards(command);
}

/// Sends the events that follow a response.
void Adapter::afterwards(const std::string& command) {
  if (command == "launch") event("initialized", Json::object());
  if (command == "terminate") event("terminated", Json::object());
  if (player && configured && !announced) {
    announced = true;
    stop = Stop::Start;
    if (!launched.stopOnEntry) stop = player->run();
  }
  if (stop) stopped(*std::exchange(stop, std::nullopt), std::exchange(stopWords, {}));
}

void Adapter::send(Json message) {
  message["seq"] = ++lastSent;
  outbox.send(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Adapter::event(std::string_view name, Json body) {
  send({{"type", "event"}, {"event", name}, {"body", std::move(body)}});
}

void Adapter::console(const std::string& text) {
  event("output", {{"category", "console"}, {"output", text + "\n"}});
}

void Adapter::stopped(Stop why, std::string_view plain) {
  const auto& trace = player->trace();
  const bool atEnd = player->choices().empty();
  Json body{{"reason", reasonOf(why)},
            {"threadId", threadOf(player->actor())},
            {"allThreadsStopped", true}};
  if (!plain.empty()) body["description"] = plain;
  if (atEnd && player->isSimulation())
    body["description"] = "Nothing more can happen";
  else if (atEnd)
    body["description"] =
        trace.description.empty()
            ? "The end of the trace"
            : fmt::format("{}: {}", ide::withoutBackticks(trace.description), trace.verdict);
  if (body.contains("description")) body["text"] = body["description"];
  event("stopped", std::move(body));
}

} // namespace proskill::dap
