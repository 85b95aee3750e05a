#include "lsp/verification/verdict_json.h"
#include "lsp/verification/verification.h"

#include <algorithm>

/// How verdicts are sent to the client.
namespace proskill::lsp {

namespace {

/// Whether it is enough to send the verdicts that changed.
bool sameRows(const std::shared_ptr<const ide::ProgramVerdicts>& before,
              const ide::ProgramVerdicts& now) {
  return before && before->program == now.program &&
         std::ranges::equal(before->properties, now.properties, {}, &ide::PropertyVerdict::name,
                            &ide::PropertyVerdict::name);
}

} // namespace

/// Called by the store, by one thread at a time.
void Verification::announce(const ProgramState& state) {
  std::shared_ptr<const ide::Snapshot> now;
  syntax::Encoding counted{};
  VerdictNews news{};
  {
    const std::lock_guard lock(mutex);
    now = snapshot;
    counted = encoding;
    news = verdictNews;
  }
  if (news == VerdictNews::None) return;
  const ide::OpenTexts none;
  const auto& open = now ? now->open() : none;
  const Converter here(state.program->program, open, counted);
  const auto& root = state.program->program.files.front().path;
  Json json{{"program", here.uri(0)},
            {"label", root.filename().string()},
            {"main", nullptr},
            {"state", nameOf(state.state)},
            {"stale", state.stale},
            {"message", state.message},
            {"progress", state.progress ? progressJson(*state.progress) : Json()},
            {"counts", countsJson({})},
            {"changes", false},
            {"verdicts", Json::array()},
            {"exploration", nullptr},
            {"texts", textsJson(state.program->program, open)}};
  if (state.verified) {
    const auto& verdicts = *state.verified->verdicts;
    const Converter there(verdicts.program->program, open, counted);
    if (!state.verified->mainSkill.empty()) json["main"] = state.verified->mainSkill;
    json["counts"] = countsJson(verdicts.properties);
    auto& before = announced[root];
    if (news == VerdictNews::Changes && sameRows(before, verdicts)) {
      json["verdicts"] = changedVerdictsJson(*before, verdicts, there);
      json["changes"] = true;
    } else {
      json["verdicts"] = verdictsJson(verdicts, there);
    }
    before = state.verified->verdicts;
    json["exploration"] = explorationSummary(verdicts.exploration);
    json["texts"] = textsJson(verdicts, there);
  }
  if (!state.verified || state.state == VerificationState::Off) announced.erase(root);
  outside.send(rpc::notification("proskill/verdicts", json));
}

} // namespace proskill::lsp
