#include "analysis/program/stop.h"
#include "ide/description/diagnostics.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

using namespace proskill;

namespace {

/// Many skills with bodies, to have enough work.
std::string programOf(int skills) {
  std::string text = "(defsv lamp :states (On Off) :init Off :transitions :all)\n";
  for (int i = 0; i < skills; ++i)
    text += fmt::format("(defskill a{0} :action (a{0}) :start (lamp On) :success ok)\n"
                        "(defskill b{0} :body ((if (lamp Off) (a{0})) (a{0})))\n",
                        i);
  return text;
}

std::shared_ptr<const ide::Snapshot> snapshotOf(const std::string& text) {
  ide::OpenTexts texts;
  texts["/w/main.proskill"] = {"file:///w/main.proskill", 1, syntax::Document::parse(text)};
  auto disk = std::make_shared<test::MemoryFiles>();
  auto graph = ide::graphOf(*disk, texts);
  return std::make_shared<ide::Snapshot>(std::move(disk), std::move(texts), std::move(graph));
}

std::size_t found(const ide::Snapshot& snapshot) {
  return ide::diagnostics(snapshot, "/w/main.proskill").size();
}

/// Counts how often the work asks whether to stop; it stops at the `last` question.
std::size_t questions(const ide::Snapshot& snapshot, std::size_t last) {
  std::size_t count = 0;
  const analysis::StopWhen stop([&] { return ++count == last; });
  found(snapshot);
  return count;
}

} // namespace

TEST_CASE("work that nobody waits for ends at its next question, and asks often") {
  constexpr int kSkills = 40;
  const auto text = programOf(kSkills);
  const auto all = questions(*snapshotOf(text), 0);
  CHECK(all > 2 * kSkills); // more than one per skill: the work between two is short
  for (std::size_t last : {std::size_t{1}, std::size_t{5}, all / 4, all / 2, all - 3, all}) {
    std::size_t count = 0;
    const auto snapshot = snapshotOf(text);
    const analysis::StopWhen stop([&] { return ++count >= last; });
    CHECK_THROWS_AS(found(*snapshot), analysis::Stopped);
    CHECK(count == last);
  }
}

TEST_CASE("what was stopped is computed by whoever asks next") {
  const auto text = programOf(10);
  const auto wanted = found(*snapshotOf(text));
  const auto all = questions(*snapshotOf(text), 0);
  for (std::size_t last = 1; last <= all; last += 7) {
    const auto snapshot = snapshotOf(text);
    CHECK_THROWS_AS(questions(*snapshot, last), analysis::Stopped);
    CHECK(found(*snapshot) == wanted);
  }
}

TEST_CASE("work within other work is stopped by its own question") {
  const analysis::StopWhen outer([] { return true; });
  {
    const analysis::StopWhen inner([] { return false; });
    CHECK_NOTHROW(analysis::stopIfAsked());
  }
  CHECK_THROWS_AS(analysis::stopIfAsked(), analysis::Stopped);
}
