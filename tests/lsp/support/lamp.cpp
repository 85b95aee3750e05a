#include "tests/lsp/support/lamp.h"

namespace proskill::test::lamp {

Json document(const std::string& uri) { return {{"textDocument", {{"uri", uri}}}}; }

Json verifying(const std::string& uri, Json names) {
  auto params = document(uri);
  params["names"] = std::move(names);
  return params;
}

Json verdictsIn(Session& session, const std::string& state, const std::string& program) {
  while (true) {
    auto news = session.notified("proskill/verdicts");
    if (news["state"] == state && news["program"] == program) return news;
  }
}

Json diagnosticsWith(Session& session, const std::string& uri, bool verdicts) {
  while (true) {
    auto news = session.notified("textDocument/publishDiagnostics");
    if (news["uri"] != uri) continue;
    Json found = Json::array();
    for (const auto& it : news["diagnostics"])
      if (it["source"] == "proskill verify") found.push_back(it);
    if (found.empty() != verdicts) return found;
  }
}

std::string verdictOn(const Json& result, const std::string& name) {
  for (const auto& verdict : result["verdicts"])
    if (verdict["name"] == name) return verdict["verdict"];
  return "";
}

void openLamp(Session& session, const std::string& main) {
  session.initialize();
  session.open(kLamp, kLampText);
  session.open(kMain, main);
}

} // namespace proskill::test::lamp
