#include "ide/fiacre/fiacre_text.h"
#include "ide/snapshot/fiacre_file.h"
#include "lsp/protocol/progress.h"
#include "lsp/verification/verdict_json.h"
#include "lsp/verification/verification.h"

#include <fmt/format.h>

#include <algorithm>

namespace proskill::lsp {

namespace {

/// The first program of a file, open or not.
std::expected<ide::View, rpc::RpcError> programOf(const Request& request) {
  auto path = documentFile(request);
  if (!path) return std::unexpected(path.error());
  return request.snapshot.view(*path);
}

std::vector<std::string> namesIn(const Json& params) {
  std::vector<std::string> names;
  auto found = params.find("names");
  if (found == params.end() || !found->is_array()) return names;
  for (const auto& name : *found)
    if (name.is_string()) names.push_back(name.get<std::string>());
  return names;
}

std::optional<rpc::RpcError> whyNot(const ide::View& view) {
  if (ide::isFiacre(view) && !ide::FiacreText(view.text()).model())
    return requestFailed("the text names no model");
  const auto& found = ide::isFiacre(view) ? view.owner->findings() : view.analysis().diagnostics;
  for (const auto& diagnostic : found)
    if (diagnostic.severity == syntax::Severity::Error)
      return requestFailed("the program has errors: " + diagnostic.message);
  return std::nullopt;
}

std::string wordsOf(const worker::WorkerProgress& now) {
  constexpr std::uint64_t kMegabyte = 1 << 20;
  return fmt::format("{} of {} decided, {} states, {:.0f} a second, {} MB, {:.0f} s", now.decided,
                     now.total, now.classes, now.rate(), now.bytes / kMegabyte, now.seconds);
}

unsigned percentageOf(const worker::WorkerProgress& now) {
  return now.total > 0 ? static_cast<unsigned>(100 * now.decided / now.total) : 0;
}

/// The verdicts that were requested, in the order of the model.
Json resultJson(const Verified& verified, const Converter& convert) {
  return {{"program", convert.uri(0)},
          {"main", verified.mainSkill.empty() ? Json() : Json(verified.mainSkill)},
          {"verdicts", verdictsJson(*verified.verdicts, convert)},
          {"exploration", explorationSummary(verified.verdicts->exploration)},
          {"texts", textsJson(*verified.verdicts, convert)}};
}

} // namespace

Answer Verification::verifyRequested(const Request& request) {
  const auto chosen = settingsNow();
  if (!chosen.trusted)
    return std::unexpected(
        requestFailed("the workspace is not trusted: nothing is verified, only static checks run"));
  auto view = programOf(request);
  if (!view) return std::unexpected(view.error());
  if (auto error = whyNot(*view)) return std::unexpected(*error);
  auto job = worker::jobFor(view->program());
  job.names = namesIn(request.params);
  job.budget = withLimits(chosen.requestBudget, request.params.value("limits", Json()));
  // limits of the request itself are not settings
  const auto limits = request.params.contains("limits") ? LimitSettings{} : kRequestLimits;
  const auto& open = request.snapshot.open();
  Progress workDone([this](std::string_view method,
                           const Json& params) { outside.send(rpc::notification(method, params)); },
                    request.params.value("workDoneToken", Json()), nullptr);
  workDone.begin("Verifying " + view->program().files.front().path.filename().string());
  store.set(view->owner, VerificationState::Checking);
  auto verified =
      run(view->owner, open, job, limits, request.cancellation, [&](const auto& progress) {
        workDone.report(wordsOf(progress), percentageOf(progress));
        store.setProgress(view->owner, progress);
      });
  if (!verified) {
    const auto& failure = verified.error();
    workDone.end(failure.message);
    store.set(view->owner,
              failure.cancelled ? VerificationState::Waiting : VerificationState::Failed,
              failure.cancelled ? "cancelled" : failure.message);
    return std::unexpected(rpc::RpcError{failure.cancelled ? rpc::ErrorCode::RequestCancelled
                                                           : rpc::ErrorCode::RequestFailed,
                                         failure.message});
  }
  const Converter convert(view->program(), open, request.client.encoding);
  auto result = resultJson(*verified, convert);
  workDone.end(fmt::format("{} verdicts", verified->verdicts->properties.size()));
  record(view->owner, std::move(*verified));
  return result;
}

/// Verifies a property again for its trace. Editors store verdicts, so this is mostly a replay.
std::expected<std::shared_ptr<const std::string>, worker::WorkerFailure>
Verification::findTrace(const Verified& known, const std::string& name, const Request& request) {
  const auto chosen = settingsNow();
  if (!chosen.trusted)
    return std::unexpected(worker::WorkerFailure{
        false, "the workspace is not trusted: nothing is verified, so the trace is not built"});
  const auto& program = known.verdicts->program;
  auto job = worker::jobFor(program->program);
  job.names = {name};
  job.budget = chosen.requestBudget;
  const auto report = worker::runWorker(outside.worker, job, request.cancellation, [](auto&) {});
  if (!report) return std::unexpected(report.error());
  const auto found = readReport(*report, program, request.snapshot.open(), kRequestLimits);
  const auto trace = found ? found->traces.find(name) : known.traces.end();
  if (!found || trace == found->traces.end())
    return std::unexpected(worker::WorkerFailure{
        false, fmt::format("the trace of `{}` was not found again within the limits", name)});
  return trace->second;
}

Answer Verification::traceRequested(const Request& request) {
  auto view = programOf(request);
  if (!view) return std::unexpected(view.error());
  const auto wanted = textIn(request.params, "name");
  if (!wanted) return std::unexpected(wanted.error());
  const auto state = store.of(view->program().files.front().path);
  if (!state || !state->verified)
    return std::unexpected(requestFailed("the program has not been verified yet"));
  Verified known = *state->verified;
  const auto& all = known.verdicts->properties;
  const auto property = std::ranges::find(all, *wanted, &ide::PropertyVerdict::name);
  if (property == all.end() || !property->steps)
    return std::unexpected(requestFailed(fmt::format("there is no trace of `{}`", *wanted)));
  if (!known.traces.contains(*wanted)) {
    auto found = findTrace(known, *wanted, request);
    if (!found)
      return std::unexpected(rpc::RpcError{found.error().cancelled
                                               ? rpc::ErrorCode::RequestCancelled
                                               : rpc::ErrorCode::RequestFailed,
                                           found.error().message});
    known.traces = {{*wanted, std::move(*found)}};
  }
  const bool stale = !ide::areCurrent(*known.verdicts, view->program());
  const Converter convert(known.verdicts->program->program, request.snapshot.open(),
                          request.client.encoding);
  return traceOf(known, *wanted, stale, convert);
}

void Verification::addMethods(Registry& registry) {
  registry.add(
      "proskill/verify", [this](const Request& request) { return verifyRequested(request); },
      rpc::Priority::Long);
  registry.add(
      "proskill/trace", [this](const Request& request) { return traceRequested(request); },
      rpc::Priority::Long);
}

} // namespace proskill::lsp
