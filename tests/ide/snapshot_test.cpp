#include "ide/diagnostics.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using Snapshot = std::shared_ptr<const ide::Snapshot>;

namespace {

constexpr const char* kPath = "/w/main.proskill";

/// A skill that nobody calls and a value that is never left, so that the flow has something to
/// tell.
constexpr const char* kText =
    "(defsv lamp :states (On Off) :init Off)\n"
    "(defskill on :start (lamp On) :action (on) :success lit)\n"
    "(defskill alone :action (a) :success done)\n"
    "(defskill main :success well :body ((on) (if (lamp Off) (on)) (success well)))\n";

ide::OpenTexts textsOf(const syntax::Document& document) {
  ide::OpenTexts texts;
  texts[kPath] = {"file:///w/main.proskill", 1, document};
  return texts;
}

Snapshot snapshotOf(const syntax::Document& document) {
  return std::make_shared<ide::Snapshot>(std::make_shared<test::MemoryFiles>(), textsOf(document),
                                         ide::Includes{{kPath, {}}});
}

/// After `put` was put in front of `place`.
syntax::Document edited(const syntax::Document& document, std::string_view place,
                        std::string_view put) {
  const auto at = static_cast<syntax::Offset>(document.text().find(place));
  return document.edit({at, at}, put);
}

std::string said(const Snapshot& snapshot) {
  std::string all;
  for (const auto& finding : ide::diagnostics(*snapshot, kPath)) {
    const auto& it = *finding.diagnostic;
    all += fmt::format("{} {}-{} {}\n", syntax::info(it.code).id, it.location.range.begin,
                       it.location.range.end, it.message);
    for (const auto& related : it.related)
      all += fmt::format("  {}-{} {}\n", related.location.range.begin, related.location.range.end,
                         related.message);
  }
  return all;
}

} // namespace

TEST_CASE("after an edit the findings are those of a fresh snapshot") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  REQUIRE(said(first) != "");
  for (const auto& [place, put] : std::vector<std::pair<const char*, const char*>>{
           {"(defskill main", "; a comment\n"},
           {"(defskill main", "(defskill new :action (n))\n"},
           {":action (a)", "\n  "},
           {"Off) (on)", "(^ 1) "},
           {"(if", "(on) "},
           {"(on) (if", "("},
           {"(on) (if", "; proskill-ignore: PS0612\n"}}) {
    INFO(place << " after " << put);
    const auto now = edited(before, place, put);
    CHECK(said(first->with(textsOf(now), {{kPath, {}}})) == said(snapshotOf(now)));
  }
}

TEST_CASE("a comment behind a definition does not have the flow computed again") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  REQUIRE(said(first) != "");
  const auto next = first->with(textsOf(edited(before, "(defsv", "; a lamp\n")), {{kPath, {}}});
  REQUIRE(said(next) != "");
  CHECK(next->view(kPath).owner->flowIfKnown() == nullptr);
  CHECK(first->view(kPath).owner->flowIfKnown() != nullptr);
}

TEST_CASE("an edit that was never looked at does not lose what was known before it") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  REQUIRE(said(first) != "");
  auto document = before;
  auto snapshot = first;
  for (int i = 0; i < 3; ++i) {
    document = edited(document, "(defsv", "; a lamp\n");
    snapshot = snapshot->with(textsOf(document), {{kPath, {}}});
  }
  CHECK(said(snapshot) == said(snapshotOf(document)));
  CHECK(snapshot->view(kPath).owner->flowIfKnown() == nullptr);
}

TEST_CASE("the program before an edit is given to be forgotten, once") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  REQUIRE(said(first) != "");
  const auto next = first->with(textsOf(edited(before, "(defsv", "; a lamp\n")), {{kPath, {}}});
  CHECK(next->takeReplaced().empty());
  REQUIRE(said(next) != "");
  const auto replaced = next->takeReplaced();
  REQUIRE(replaced.size() == 1);
  CHECK(replaced.front() == first->view(kPath).owner);
  CHECK(next->takeReplaced().empty());
}
