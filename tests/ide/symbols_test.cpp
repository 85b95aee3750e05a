#include "ide/completion/fuzzy.h"
#include "ide/features/symbols.h"
#include "tests/ide/marked_program.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

#include <set>

using namespace proskill;
using test::MarkedProgram;
using test::MemoryFiles;

namespace {

std::string written(const std::vector<ide::OutlineEntry>& entries) {
  std::string result;
  for (const auto& entry : entries) {
    if (!result.empty()) result += ' ';
    result += entry.name;
    if (!entry.children.empty()) result += "(" + written(entry.children) + ")";
  }
  return result;
}

void checkRanges(const std::vector<ide::OutlineEntry>& entries, syntax::Range outer) {
  for (const auto& entry : entries) {
    INFO(entry.name);
    CHECK_FALSE(entry.name.empty());
    CHECK((outer.begin <= entry.range.begin && entry.range.end <= outer.end));
    CHECK((entry.range.begin <= entry.selection.begin && entry.selection.end <= entry.range.end));
    checkRanges(entry.children, entry.range);
  }
}

std::vector<std::string> found(const MarkedProgram& program, std::string_view query) {
  std::vector<std::string> result;
  for (const auto& it : ide::workspaceSymbols(program.snapshot(), query, [] { return false; }))
    result.push_back(it.name);
  return result;
}

using Names = std::vector<std::string>;

} // namespace

TEST_CASE("the outline has every definition with what is inside of it, in the order of the text") {
  const MarkedProgram program(
      "(include \"other.proskill\")\n(defsv lamp :states (On Off) :init On)\n"
      "(defskill go :input ($x int) :precondition (ok true) :invariant (safe (:guard true))\n"
      "  :success done :failure (bad worse) :body ((label again) (goto again)))\n"
      "(defevent e :effects (lamp On)) (defresource arm) (defproperty p (deadlockfree))\n"
      "(defconst two 2) (defenvironment world :body ((label w)))");
  CHECK(written(ide::outline(program.view())) ==
        "other.proskill lamp(On Off) go(x ok safe done bad worse again) e arm p two world(w)");
  checkRanges(ide::outline(program.view()),
              {0, static_cast<syntax::Offset>(program.view().text().size())});
}

TEST_CASE("the outline of a half-typed text has names for all, and ranges within each other") {
  for (const auto* text :
       {"(defsv", "(defskill )", "(defskill f :input ($", "(include", "(defsv lamp :states (A B",
        "(defskill f :precondition (a (b\n(defevent e :effects", "(defwhat x)", "()"}) {
    INFO(text);
    const MarkedProgram program{std::string(text)};
    checkRanges(ide::outline(program.view()),
                {0, static_cast<syntax::Offset>(program.view().text().size())});
  }
  CHECK(written(ide::outline(MarkedProgram("(defskill )").view())) == "defskill");
}

TEST_CASE("the workspace's symbols by what was typed of them, the best first") {
  const MarkedProgram program({{"a.proskill", "(include \"lib.proskill\")\n"
                                              "(defskill goto_waypoint :action (x))"},
                               {"b.proskill", "(include \"lib.proskill\")\n"
                                              "(defskill gather_wood :action (x))"},
                               {"lib.proskill", "(defsv gw :states (Gone Waiting) :init Gone)"},
                               {"lone.proskill", "(defresource gripper)"}});
  CHECK(found(program, "gw") == Names{"gw", "gather_wood", "goto_waypoint"});
  CHECK(found(program, "GRIP") == Names{"gripper"});
  CHECK(found(program, "way") == Names{"goto_waypoint"});
  CHECK(found(program, "xyz").empty());
  CHECK(found(program, "").size() == 6);
}

TEST_CASE("the workspace's symbols tell where they are, and what they are inside of") {
  const MarkedProgram program("(defevent e)\n(defsv lamp :states (On Off) :init Off)");
  const auto found = ide::workspaceSymbols(program.snapshot(), "Off", [] { return false; });
  REQUIRE(found.size() == 1);
  CHECK(found[0].file == "/w/main.proskill");
  CHECK(program.view().text().substr(found[0].at.begin, found[0].at.length()) == "Off");
  CHECK(found[0].kind == analysis::SymbolKind::Value);
  CHECK(found[0].owner == "lamp");
  const auto events = ide::workspaceSymbols(program.snapshot(), "e", [] { return false; });
  REQUIRE_FALSE(events.empty());
  CHECK(events[0].name == "e");
  CHECK_FALSE(events[0].owner);
}

TEST_CASE("symbols are those of open texts as they are now, and of files outside of the folders") {
  const auto disk = std::make_shared<MemoryFiles>(std::map<std::string, std::string>{
      {"/w/open.proskill", "(defevent old)"},
      {"/w/closed.proskill", "(include \"../far/lib.proskill\") (defevent closed)"},
      {"/far/lib.proskill", "(include \"deep.proskill\") (defevent lib)"},
      {"/far/deep.proskill", "(include \"lib.proskill\") (defevent deep)"}});
  std::vector<ide::IncludeGraph::File> known;
  for (const auto* path : {"/w/open.proskill", "/w/closed.proskill"})
    known.push_back(std::make_shared<const ide::KnownFile>(
        ide::knownFile(*disk, path, path, *disk->document(path))));
  ide::OpenTexts texts;
  texts["/w/open.proskill"] = {"file:///w/open.proskill", 1,
                               syntax::Document::parse("(defevent now)")};
  const ide::Snapshot snapshot(disk, texts, std::make_shared<const ide::IncludeGraph>(known));
  std::set<std::string> names;
  for (const auto& it : ide::workspaceSymbols(snapshot, "", [] { return false; }))
    CHECK(names.insert(it.name).second);
  CHECK(names == std::set<std::string>{"now", "closed", "lib", "deep"});
}

TEST_CASE("a search that is cancelled ends") {
  const MarkedProgram program("(defresource gripper)");
  CHECK(ide::workspaceSymbols(program.snapshot(), "g", [] { return true; }).empty());
}

TEST_CASE("symbols of hundreds of closed files, as many as a list can show, each once") {
  constexpr int kPrograms = 300;
  std::map<std::string, std::string> files{{"/w/base.proskill", "(defskill shared :action (s))"}};
  for (int i = 0; i < kPrograms; ++i)
    files[fmt::format("/w/p{}.proskill", i)] =
        fmt::format("(include \"base.proskill\")\n(defskill skill_{0} :action (s))\n", i);
  std::vector<ide::IncludeGraph::File> known;
  const auto disk = std::make_shared<MemoryFiles>(files);
  for (const auto& [name, text] : files)
    known.push_back(std::make_shared<const ide::KnownFile>(
        ide::knownFile(*disk, name, name, syntax::Document::parse(text))));
  const ide::Snapshot snapshot(disk, {}, std::make_shared<const ide::IncludeGraph>(known));
  auto found = [&](std::string_view query) {
    Names names;
    for (const auto& it : ide::workspaceSymbols(snapshot, query, [] { return false; }))
      names.push_back(it.name);
    return names;
  };
  CHECK(found("shared") == Names{"shared"});
  CHECK(found("skill_299") == Names{"skill_299"});
  CHECK(found("skill").size() == 256);
}

TEST_CASE("letters that begin a part of a name, or follow each other, count more") {
  CHECK_FALSE(ide::fuzzyScore("ba", "ab"));
  CHECK_FALSE(ide::fuzzyScore("abc", "ab"));
  CHECK(ide::fuzzyScore("gw", "goto_waypoint") > ide::fuzzyScore("gw", "garrow"));
  CHECK(ide::fuzzyScore("go", "goto") > ide::fuzzyScore("go", "gripper_open_wide"));
  CHECK(ide::fuzzyScore("go", "go") > ide::fuzzyScore("go", "goto"));
  CHECK(ide::fuzzyScore("GO", "go"));
}
