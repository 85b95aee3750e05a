#include "analysis/names/index.h"
#include "syntax/diagnostics/codes.h"
#include "tests/analysis/findings.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::findings;
using Files = std::map<std::string, std::string>;

TEST_CASE("a program is a file and what it includes") {
  CHECK(findings(Files{{"main.proskill", "(include \"lib/all.proskill\") (defskill m :body ((a)))"},
                       {"lib/all.proskill", "(include \"a.proskill\")"},
                       {"lib/a.proskill", "(defskill a :action (a))"}}) == "");
}

TEST_CASE("a file that is included twice counts once") {
  CHECK(findings(Files{{"main.proskill", "(include \"a.proskill\") (include \"./b.proskill\")"
                                         "(include \"lib/../b.proskill\")"},
                       {"a.proskill", "(include \"b.proskill\")"},
                       {"b.proskill", "(defskill b :action (b))"}}) == "");
}

TEST_CASE("definitions come in the order in which a reader meets them") {
  const test::MemoryFiles files(
      {{"main.proskill", "(defresource a) (include \"b.proskill\") (defresource c)"},
       {"b.proskill", "(defresource b)"}});
  const auto program = analysis::load(files, "main.proskill");
  REQUIRE(program.resources.all.size() == 3);
  CHECK(program.resources.all[1].name() == "b");
  CHECK(program.resources.all[1].file == 1);
  CHECK(program.resources.find("c") == &program.resources.all[2]);
}

TEST_CASE("a missing file is told at the include, with the reason") {
  const test::MemoryFiles files(Files{{"main.proskill", "(include \"nowhere.proskill\")"}});
  const auto found = analysis::check(analysis::load(files, "main.proskill"));
  REQUIRE(found.size() == 1);
  CHECK(found[0].message == "cannot read `nowhere.proskill`: no such file");
  CHECK(found[0].location.range == syntax::Range{10, 26});
}

TEST_CASE("a root that is missing is an empty program with an error") {
  const auto program = analysis::load(test::MemoryFiles(), "main.proskill");
  CHECK(program.files.size() == 1);
  REQUIRE(program.diagnostics.size() == 1);
  CHECK(program.diagnostics[0].code == syntax::Code::UnreadableFile);
}

TEST_CASE("include cycles are told at the include that closes them") {
  CHECK(findings(Files{{"main.proskill", "(include \"main.proskill\")"}}) ==
        "PS0007 main.proskill");
  CHECK(findings(Files{{"main.proskill", "(include \"a.proskill\")"},
                       {"a.proskill", "(include \"b.proskill\")"},
                       {"b.proskill", "(include \"a.proskill\")"}}) ==
        "b.proskill: PS0007 a.proskill");
}

TEST_CASE("what is wrong in an included file is told there") {
  CHECK(findings(Files{{"main.proskill", "(include \"a.proskill\") (defskill m :body ((b)))"},
                       {"a.proskill", "(defskill a :action (a)) (defskill a :action (b))"}}) ==
        "PS0201 b, a.proskill: PS0220 a");
  CHECK(findings(Files{{"main.proskill", "(include \"a.proskill\")"},
                       {"a.proskill", "(defskill a :action (a)"}}) == "a.proskill: PS0101 (");
}

TEST_CASE("the main skill is the composite that nobody calls") {
  auto main = [](std::string text) {
    const auto program = analysis::load(test::MemoryFiles(), "main.proskill",
                                        syntax::Document::parse(std::move(text)));
    const auto found = analysis::mainSkill(program);
    return std::pair(found.skill ? std::string(found.skill->name()) : "", found.candidates.size());
  };
  CHECK(main("(defskill a :action (a))") == std::pair(std::string(), std::size_t{0}));
  CHECK(main("(defskill a :body ((b))) (defskill b :body ((^ 1)))") ==
        std::pair(std::string("a"), std::size_t{1}));
  CHECK(main("(defskill a :monitor t :body ((^ 1))) (defskill b :body ((^ 1)))") ==
        std::pair(std::string("b"), std::size_t{1}));
  CHECK(main("(defskill a :body ((^ 1))) (defskill b :body ((^ 1)))") ==
        std::pair(std::string(), std::size_t{2}));
  CHECK(main("(defskill a :body ((^ 1))) (defskill b :body ((// ((^ 1)) ((if true (a))))))") ==
        std::pair(std::string("b"), std::size_t{1}));
}
