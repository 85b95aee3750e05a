#include "tina/session.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::tina {

namespace {

bool complainsOfMemory(const process::Finished& finished) {
  for (const auto* text : {&finished.out, &finished.err})
    for (const auto* words : {"ut of memory", "annot allocate memory", "bad_alloc"})
      if (text->find(words) != std::string::npos) return true;
  return false;
}

} // namespace

process::Job Session::job(const std::string& name, std::vector<std::string> command) const {
  process::Job made{.command = std::move(command),
                    .directory = workspace.path(),
                    .memory = options.limits.bytes,
                    .cancelled = options.cancelled};
  if (options.limits.seconds) made.seconds = std::max(0.0, *options.limits.seconds - seconds());
  if (options.progress)
    made.progress = [this, name](double passed, std::string_view line) {
      options.progress({name, passed, line});
    };
  return made;
}

std::optional<Session::Stop> Session::judge(const std::string& name,
                                            const process::Finished& finished) const {
  using process::Ending;
  if (finished.ending == Ending::Cancelled) return Stop{true, "cancelled"};
  if (finished.ending == Ending::TimedOut)
    return Stop{true, fmt::format("the time limit was reached, in `{}`", name)};
  if (finished.succeeded()) return std::nullopt;
  if (options.limits.bytes && complainsOfMemory(finished))
    return Stop{true, fmt::format("the memory limit was reached, in `{}`", name)};
  return Stop{false, fmt::format("`{}` {}", name, finished.words())};
}

std::expected<process::Finished, Session::Stop> Session::run(const std::string& name,
                                                             std::vector<std::string> command) {
  Call call{.command = fmt::format("{}", fmt::join(command, " "))};
  auto finished = process::run(job(name, std::move(command)));
  call.ended = finished ? finished->words() : "could not be started: " + finished.error();
  if (finished) {
    call.out = finished->out;
    call.err = finished->err;
  }
  calls.push_back(call);
  if (!finished) return std::unexpected(Stop{false, fmt::format("`{}` {}", name, call.ended)});
  if (auto stop = judge(name, *finished)) return std::unexpected(std::move(*stop));
  return std::move(*finished);
}

} // namespace proskill::tina
