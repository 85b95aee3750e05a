#include "ide/description/diagnostics.h"
#include "ide/features/hover.h"
#include "ide/features/inlay_hints.h"
#include "ide/features/rename.h"
#include "tests/support/linked_files.h"
#include "tests/support/random/random_edits.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

using namespace proskill;
using Snapshot = std::shared_ptr<const ide::Snapshot>;

namespace {

constexpr const char* kPath = "/w/main.proskill";

/// A skill that nobody calls and a value that is never left, so that the flow analysis has
/// findings.
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
  auto texts = textsOf(document);
  auto graph = ide::graphOf(test::MemoryFiles(), texts);
  return std::make_shared<ide::Snapshot>(std::make_shared<test::MemoryFiles>(), std::move(texts),
                                         std::move(graph));
}

/// After inserting `put` before `place`.
syntax::Document edited(const syntax::Document& document, std::string_view place,
                        std::string_view put) {
  const auto at = static_cast<syntax::Offset>(document.text().find(place));
  return document.edit({at, at}, put);
}

Snapshot after(const Snapshot& snapshot, const syntax::Document& document) {
  auto texts = textsOf(document);
  auto graph = ide::graphOf(test::MemoryFiles(), texts);
  return snapshot->with(std::move(texts), std::move(graph));
}

/// The same flow object, not an equal one.
bool isSameFlow(const Snapshot& a, const Snapshot& b) {
  const auto first = a->view(kPath).owner->flowIfKnown();
  const auto second = b->view(kPath).owner->flowIfKnown();
  return first && second && &first->flow() == &second->flow();
}

/// The values at every place.
std::string shown(const Snapshot& snapshot) {
  const auto view = snapshot->view(kPath);
  const auto end = static_cast<syntax::Offset>(view.text().size());
  std::string all;
  for (const auto& hint : ide::inlayHints(view, {0, end}))
    all += fmt::format("{} {} {}\n", hint.at, hint.label, hint.tooltip);
  for (syntax::Offset at = 0; at <= end; ++at) {
    for (const auto& hint : ide::inlayHints(view, {at, std::min(end, at + 30)}))
      all += fmt::format("from {}: {} {}\n", at, hint.at, hint.label);
    if (const auto hover = ide::hover(view, at))
      all += fmt::format("{}-{} {}\n", hover->range.begin, hover->range.end, hover->text.plain());
  }
  return all;
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
    for (const auto& fix : it.fixes)
      all += fmt::format("  {}-{} {} to {}\n", fix.location.range.begin, fix.location.range.end,
                         fix.title, fix.text);
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
    CHECK(said(after(first, now)) == said(snapshotOf(now)));
  }
}

TEST_CASE("a comment does not have the flow computed again") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  REQUIRE(said(first) != "");
  const auto next = after(first, edited(before, "(defsv", "; a lamp\n"));
  REQUIRE(said(next) != "");
  CHECK(isSameFlow(first, next));
}

TEST_CASE("an edit that was never looked at does not lose what was known before it") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  REQUIRE(said(first) != "");
  auto document = before;
  auto snapshot = first;
  for (int i = 0; i < 3; ++i) {
    document = edited(document, "(defsv", "; a lamp\n");
    snapshot = after(snapshot, document);
  }
  CHECK(said(snapshot) == said(snapshotOf(document)));
  CHECK(isSameFlow(first, snapshot));
}

TEST_CASE("letters that are typed and taken back do not have the flow computed again") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  const auto told = said(first);
  REQUIRE(told != "");
  const auto begin = static_cast<syntax::Offset>(before.text().find("on) (if"));
  auto document = before;
  auto snapshot = first;
  auto end = begin;
  for (const char* letter : {"(", "x", "y"}) {
    document = document.edit({end, end}, letter);
    ++end;
    snapshot = after(snapshot, document);
    CHECK(said(snapshot) == said(snapshotOf(document)));
    CHECK(snapshot->view(kPath).owner->flow() == nullptr);
  }
  document = document.edit({begin, end}, "");
  snapshot = after(snapshot, document);
  CHECK(said(snapshot) == told);
  CHECK(isSameFlow(first, snapshot));
}

TEST_CASE("what the flow tells of a place moves with the place") {
  const auto before = syntax::Document::parse(
      "(defsv lamp :states (On Off Dim) :init Off)\n"
      "(defevent dusk :effects (lamp On))\n"
      "(defskill on :start (lamp On) :time_interval [1,3] :action (on) :success lit :failure no)\n"
      "(defskill main :success well :failure dark\n"
      "  :body ((on) (if (= on.status success) (^ 1) else (failure dark)) (success well)))\n");
  const auto first = snapshotOf(before);
  (void)said(first);
  REQUIRE_THAT(shown(first), Catch::Matchers::Contains("= success or failure"));
  auto document = before;
  auto snapshot = first;
  for (const auto& [place, put] :
       std::vector<std::pair<const char*, const char*>>{{"(if", "; what if?\n   "},
                                                        {"(defsv", "; a lamp\n\n"},
                                                        {"success) (^", "  "},
                                                        {"(^", "; wait\n"},
                                                        {"(success", " ; well\n"},
                                                        {"; wait", "\n"},
                                                        {":body", "\n"}}) {
    document = edited(document, place, put);
    snapshot = after(snapshot, document);
    const auto fresh = snapshotOf(document);
    REQUIRE(said(snapshot) == said(fresh));
    CHECK(shown(snapshot) == shown(fresh));
    CHECK(isSameFlow(first, snapshot));
  }
}

TEST_CASE("after any edits the findings are those of a fresh snapshot") {
  std::uint64_t seed = 1;
  for (const auto& text : test::allPrograms()) {
    test::RandomEdits edits(seed++);
    auto document = syntax::Document::parse(text);
    auto snapshot = snapshotOf(document);
    for (int i = 0; i < 30; ++i) {
      const auto edit = edits.any(document.text());
      const auto back = document;
      document = document.edit(edit.range, edit.text);
      INFO("edit " << i << " at " << edit.range.begin << "-" << edit.range.end << ": " << edit.text
                   << "\nof\n"
                   << back.text());
      snapshot = after(snapshot, document);
      if (edits.pick(4) != 0) CHECK(said(snapshot) == said(snapshotOf(document)));
      if (edits.pick(3) != 0) document = back.edit({0, 0}, "");
      snapshot = after(snapshot, document);
      if (edits.pick(4) != 0) CHECK(said(snapshot) == said(snapshotOf(document)));
    }
  }
}

TEST_CASE("the program before an edit is given to be forgotten, once") {
  const auto before = syntax::Document::parse(kText);
  const auto first = snapshotOf(before);
  REQUIRE(said(first) != "");
  const auto next = after(first, edited(before, "(defsv", "; a lamp\n"));
  CHECK(next->takeReplaced().empty());
  REQUIRE(said(next) != "");
  const auto replaced = next->takeReplaced();
  REQUIRE(replaced.size() == 1);
  CHECK(replaced.front() == first->view(kPath).owner);
  CHECK(next->takeReplaced().empty());
}

TEST_CASE(
    "programs that an edit does not touch are kept, and so are those of which nothing is open") {
  const auto disk = std::make_shared<test::MemoryFiles>(
      std::map<std::string, std::string>{{"/w/closed.proskill", "(defskill c :action (c))"}});
  const auto open = syntax::Document::parse(kText);
  auto texts = textsOf(open);
  const auto graph =
      ide::graphOf(*disk, texts)->with({"/w/closed.proskill", "/w/closed.proskill", {}});
  const auto first = std::make_shared<const ide::Snapshot>(disk, texts, graph);
  const auto closed = first->view("/w/closed.proskill").owner;
  const auto next = first->with(textsOf(edited(open, "(defsv", "; ")), graph);
  CHECK(next->view("/w/closed.proskill").owner == closed);
  CHECK(next->view(kPath).owner != first->view(kPath).owner);
  texts["/w/closed.proskill"] = {"file:///w/closed.proskill", 1, syntax::Document::parse("; new")};
  const auto opened = next->with(texts, graph);
  CHECK(opened->view("/w/closed.proskill").text() == "; new");
  texts.erase("/w/closed.proskill"); // the new file on the disk is unknown until it is read
  CHECK(opened->with(texts, graph)->view("/w/closed.proskill").owner != closed);
}

TEST_CASE("of the programs of which nothing is open those are kept that were used last") {
  std::map<std::string, std::string> files;
  std::vector<ide::IncludeGraph::File> known;
  for (int i = 0; i < 6; ++i) {
    const auto path = fmt::format("/w/{}.proskill", i);
    files[path] = ";" + std::string(300'000, 'x');
    known.push_back(std::make_shared<const ide::KnownFile>(ide::KnownFile{path, path, {}}));
  }
  const auto disk = std::make_shared<test::MemoryFiles>(files);
  const ide::Snapshot snapshot(disk, {}, std::make_shared<const ide::IncludeGraph>(known));
  std::vector<std::weak_ptr<const ide::AnalysedProgram>> programs;
  for (const auto& [path, text] : files) {
    programs.emplace_back(snapshot.view(path).owner);
    CHECK(snapshot.view("/w/0.proskill").text() == files["/w/0.proskill"]);
  }
  CHECK(std::ranges::count_if(programs, [](const auto& it) { return it.expired(); }) == 3);
  CHECK_FALSE(programs.front().expired());
  CHECK_FALSE(programs.back().expired());
}

TEST_CASE("the flow that was given back is there again when somebody looks at the program") {
  const auto document = syntax::Document::parse(kText);
  const auto snapshot = snapshotOf(document);
  const auto owner = snapshot->view(kPath).owner;
  REQUIRE(said(snapshot) != "");
  REQUIRE(owner->flowIfKnown());
  owner->forgetFlow();
  CHECK_FALSE(owner->flowIfKnown());
  CHECK(said(snapshot) == said(snapshotOf(document)));
  CHECK(owner->flowIfKnown());
  const auto next = after(snapshot, edited(document, "(defsv", "; a lamp\n"));
  REQUIRE(said(next) != "");
  CHECK(isSameFlow(snapshot, next));
}

TEST_CASE("a text that was opened by a link is the file that programs include") {
  const auto disk = std::make_shared<test::LinkedFiles>(
      std::map<std::string, std::string>{
          {"/w/lamp.proskill", "(defsv wrong :states (A B) :init A)"}},
      test::LinkedFiles::Links{{"/far/lamp.proskill", "/w/lamp.proskill"},
                               {"/w/also.proskill", "/w/lamp.proskill"}});
  ide::OpenTexts texts;
  texts["/far/lamp.proskill"] = {
      "file:///far/lamp.proskill", 1,
      syntax::Document::parse("(defsv lamp :states (On Off) :init Off :transitions :all)")};
  texts[kPath] = {
      "file:///w/main.proskill", 1,
      syntax::Document::parse("(include \"lamp.proskill\") (include \"also.proskill\")\n"
                              "(defevent dusk :effects (lamp On))")};
  const ide::Snapshot snapshot(disk, texts, ide::graphOf(*disk, texts));
  CHECK(snapshot.roots() == std::vector<std::filesystem::path>{kPath});
  CHECK(ide::diagnostics(snapshot, "/far/lamp.proskill").empty());
  const auto lamp = snapshot.view("/far/lamp.proskill");
  CHECK(lamp.program().files.size() == 2);
  CHECK(snapshot.nameOf("/w/also.proskill") == "/far/lamp.proskill");
  const auto plan = ide::rename(snapshot, lamp, 8, "light");
  REQUIRE(plan);
  CHECK(plan->places.at("/far/lamp.proskill").size() == 1);
  CHECK(plan->places.at(kPath).size() == 1);
}

TEST_CASE("a feature looks at one program of a file that many include, not at all of them") {
  std::map<std::string, std::string> files{{"/w/base.proskill", "(defskill base :action (b))"}};
  ide::OpenTexts texts;
  for (const auto* name : {"/w/a.proskill", "/w/b.proskill"})
    texts[name] = {std::string("file://") + name, 1,
                   syntax::Document::parse("(include \"base.proskill\")")};
  const auto disk = std::make_shared<test::MemoryFiles>(std::move(files));
  std::vector<std::filesystem::path> analysed;
  const ide::Snapshot snapshot(disk, texts, ide::graphOf(*disk, texts), [&](const auto& root) {
    analysed.push_back(root);
    return analysis::flow::Settings{};
  });
  CHECK(snapshot.view("/w/base.proskill").text() == "(defskill base :action (b))");
  CHECK(analysed == std::vector<std::filesystem::path>{"/w/a.proskill"});
  CHECK(snapshot.views("/w/base.proskill").size() == 2);
  CHECK(analysed.size() == 2);
}

TEST_CASE("a file of several programs is viewed in one whose root is open") {
  const std::string include = "(include \"use.proskill\")\n";
  const std::map<std::string, std::string> files{
      {"/w/use.proskill", "(defevent e :effects (lamp On))\n"},
      {"/w/a.proskill", include + "(defsv lamp :states (On Off) :init Off)\n"},
      {"/w/b.proskill", include + "(defsv lamp :states (On Off) :init On)\n"}};
  const auto disk = std::make_shared<test::MemoryFiles>(files);
  ide::OpenTexts all;
  for (const auto& [path, text] : files)
    all[path] = {"file://" + path, 1, syntax::Document::parse(text)};
  const auto graph = ide::graphOf(*disk, all);
  auto rootWith = [&](const std::vector<std::string>& open) {
    ide::OpenTexts texts;
    for (const auto& path : open) texts[path] = all.at(path);
    const ide::Snapshot snapshot(disk, std::move(texts), graph);
    const auto views = snapshot.views("/w/use.proskill");
    REQUIRE(views.size() == 2);
    const auto first = views.front().program().files.front().path;
    CHECK(snapshot.view("/w/use.proskill").program().files.front().path == first);
    CHECK(snapshot.isLookedAt(*views.front().owner));
    return first.string();
  };
  CHECK(rootWith({"/w/use.proskill"}) == "/w/a.proskill");
  CHECK(rootWith({"/w/use.proskill", "/w/b.proskill"}) == "/w/b.proskill");
  CHECK(rootWith({"/w/use.proskill", "/w/a.proskill", "/w/b.proskill"}) == "/w/a.proskill");
}
