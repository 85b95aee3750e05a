#include "tests/lsp/support/lamp.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace proskill::test::in_view_test {

using namespace lamp;

namespace {

/// Counters up to `most`, each of which depends on the next.
std::string counters(int count, int most) {
  std::string text = "(defproperty near (always (<= x0 (+ x1 51))))\n";
  for (int i = 0; i < count; ++i)
    text += fmt::format("(defsv x{0} :min 0 :max {2} :init 0)\n"
                        "(defevent up{0} :guard (& (< x{0} {2}) (<= x{0} (+ x{1} 50))) :effects "
                        "(x{0} (+ x{0} 1)))\n",
                        i, (i + 1) % count, most);
  return text;
}

/// Counters whose properties are decided after 100^12 states.
std::string endlessText() { return counters(12, 99); }

/// A large program that is verified soon.
std::string manyDoors() {
  std::string text = counters(2, 9);
  for (int i = 0; i < 300; ++i)
    text += fmt::format("(defsv door{0} :states (Open Shut Ajar) :init Open\n"
                        "  :transitions ((Open Shut) (Shut Ajar) (Ajar Open)))\n"
                        "(defevent shut{0} :guard (door{0} Open) :effects (door{0} Shut))\n"
                        "(defevent ajar{0} :guard (door{0} Shut) :effects (door{0} Ajar))\n",
                        i);
  return text;
}

/// More than what is verified at once: the counters, a comment, and a door.
std::string largeText() {
  return endlessText() + "; " + std::string(70'000, '-') +
         "\n(defsv door :states (Open Shut) :init Open\n  :transitions ((Open Shut)))\n"
         "(defevent shut :effects (door Shut))\n";
}

std::size_t linesOf(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

void view(Session& session, std::size_t first, std::size_t last) {
  session.notify("proskill/view", {{"textDocument", {{"uri", kMain}}},
                                   {"range",
                                    {{"start", {{"line", first}, {"character", 0}}},
                                     {"end", {{"line", last}, {"character", 0}}}}}});
}

/// Waits for the verdict on a property while the program is being verified.
std::string verdictWhileChecking(Session& session, const std::string& name) {
  while (true) {
    const auto news = session.notified("proskill/verdicts");
    if (news["state"] != "checking") return "none: " + news["state"].get<std::string>();
    for (const auto& verdict : news["verdicts"])
      if (verdict["name"] == name && verdict["pending"] == false) return verdict["verdict"];
  }
}

} // namespace

TEST_CASE("definitions that are scrolled into view of a large program are verified next") {
  const auto text = largeText();
  Session::Options options;
  options.initializationOptions = kLive;
  options.initializationOptions["verify"]["delay"] = 200; // the view is known by then
  Session session(options);
  session.initialize();
  session.open(kMain, text);
  SECTION("while what was in view is being verified") {
    view(session, 0, 3);
    verdictsIn(session, "checking");
  }
  SECTION("while the whole program is") {
    view(session, linesOf(endlessText()), linesOf(endlessText()));
    while (session.notified("proskill/verdicts")["progress"].is_null()) continue;
  }
  view(session, linesOf(text) - 3, linesOf(text));
  CHECK(verdictWhileChecking(session, "door.no_forbidden_transition") == "holds");
}

TEST_CASE("who scrolls all the time does not hold up the verification of the whole program") {
  const auto text = manyDoors();
  Session::Options options;
  options.initializationOptions = kLive;
  options.initializationOptions["verify"]["seconds"] = 120;
  Session session(options);
  session.initialize();
  session.open(kMain, text);
  Json news;
  std::size_t line = 0;
  do {
    line = (line + 10) % (linesOf(text) - 20);
    view(session, line, line + 20);
    news = session.notified("proskill/verdicts");
  } while (news["state"] != "done" && news["state"] != "failed");
  CHECK(news["state"] == "done");
  CHECK(std::ranges::none_of(
      news["verdicts"], [](const auto& verdict) { return verdict["verdict"] == "inconclusive"; }));
}

} // namespace proskill::test::in_view_test
