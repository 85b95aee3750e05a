#include "lsp/server/server.h"

#include "lsp/workspace/fingerprint.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

/// What the server tells of itself: its log, `$/logTrace` and `proskill/status`.
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

Json documents(const ide::Snapshot& snapshot) {
  Json result = Json::array();
  for (const auto& [path, text] : snapshot.open())
    if (text.kind != ide::TextKind::Notebook)
      result.push_back({{"uri", text.uri},
                        {"version", text.version},
                        {"bytes", text.document.text().size()},
                        {"hash", fingerprint(text.document.text())}});
  return result;
}

} // namespace

void Server::log(std::string_view line) const {
  if (!options.log) return;
  auto now = std::chrono::floor<std::chrono::milliseconds>(std::chrono::system_clock::now());
  auto second = std::chrono::floor<std::chrono::seconds>(now);
  options.log(fmt::format("{:%FT%T}.{:03}Z {}",
                          fmt::gmtime(std::chrono::system_clock::to_time_t(second)),
                          (now - second).count(), line));
}

void Server::logAnswer(const Message& message, std::string_view outcome,
                       std::chrono::nanoseconds latency) {
  auto line = fmt::format("{} {} {:.3f} ms {}", message.method, message.id.dump(),
                          milliseconds(latency), outcome);
  log(line);
  if (trace == Trace::Off) return;
  Json params{{"message", line}};
  if (trace == Trace::Verbose) params["verbose"] = shown(message.params);
  peer.notify("$/logTrace", params);
}

void Server::failed(std::string_view method, const Json& params, std::string_view error) const {
  log(fmt::format("{} failed: {}; its parameters: {}", method, error, shown(params)));
}

Json Server::status(const ide::Snapshot& snapshot) const {
  return {{"version", options.version},
          {"seconds",
           std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count()},
          {"pending", pending.size()},
          {"errors", errors.load()},
          {"memoryBytes", residentBytes()},
          {"documents", documents(snapshot)},
          {"files", snapshot.files().size()},
          {"requests", statistics.latencies()}};
}

} // namespace proskill::lsp
