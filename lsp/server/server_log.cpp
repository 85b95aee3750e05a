#include "lsp/server/server_log.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace proskill::lsp {

namespace {

constexpr std::size_t kLongest = 4096;

std::string shown(const Json& params) {
  auto text = params.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "…";
  return text;
}

double milliseconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

} // namespace

void ServerLog::setTrace(const Json& value) {
  if (value == "off") trace = Trace::Off;
  if (value == "messages") trace = Trace::Messages;
  if (value == "verbose") trace = Trace::Verbose;
}

void ServerLog::write(std::string_view line) const {
  if (!sink) return;
  auto now = std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
  auto second = std::chrono::floor<std::chrono::seconds>(now);
  sink(fmt::format("{:%FT%T}.{:03}Z {}", fmt::gmtime(std::chrono::system_clock::to_time_t(second)),
                   (now - second).count(), line));
}

void ServerLog::writeAnswer(const rpc::Message& message, std::string_view outcome,
                            std::chrono::nanoseconds latency) {
  auto line = fmt::format("{} {} {:.3f} ms {}", message.method, message.id.dump(),
                          milliseconds(latency), outcome);
  write(line);
  if (trace == Trace::Off) return;
  Json params{{"message", line}};
  if (trace == Trace::Verbose) params["verbose"] = shown(message.params);
  peer.notify("$/logTrace", params);
}

void ServerLog::writeFailure(std::string_view method, const Json& params,
                             std::string_view error) const {
  write(fmt::format("{} failed: {}; its parameters: {}", method, error, shown(params)));
}

} // namespace proskill::lsp
