#pragma once

#include "tests/lsp/support/session.h"

#include <string>

/// Texts and questions about verdicts.
namespace proskill::test::lamp {

inline constexpr auto kMain = "file:///w/main.proskill";
inline constexpr auto kLamp = "file:///w/lamp.proskill";

/// A lamp that can be switched on, and never off.
inline const std::string kLampText = "(defsv lamp :states (On Off) :init Off\n"
                                     "  :transitions ((Off On)))\n";
inline const std::string kGood = "(include \"lamp.proskill\")\n"
                                 "(defevent on :effects (lamp On))\n";
inline const std::string kBad = kGood + "(defevent off :effects (lamp Off))\n";

/// Live verification without delay.
inline const Json kLive = {{"verify", {{"delay", 0}, {"seconds", 60}}}};

[[nodiscard]] Json document(const std::string& uri);
[[nodiscard]] Json verifying(const std::string& uri, Json names = Json::array());
/// The next notification on a program in a state.
Json verdictsIn(Session& session, const std::string& state, const std::string& program = kMain);
/// The next diagnostics of a text with, or without, verdicts.
Json diagnosticsWith(Session& session, const std::string& uri, bool verdicts);
[[nodiscard]] std::string verdictOn(const Json& result, const std::string& name);
void openLamp(Session& session, const std::string& main);

} // namespace proskill::test::lamp
