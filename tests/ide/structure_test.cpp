#include "ide/features/structure.h"
#include "tests/support/marked_source.h"

#include <catch2/catch.hpp>

using namespace proskill;
using ide::Fold;
using ide::FoldKind;
using syntax::Document;

TEST_CASE("forms, fields and comments of several lines can be folded, once for each first line") {
  auto document = Document::parse("; one\n; two\n"
                                  "(defskill m ; trailing\n"
                                  "  ; alone\n"
                                  "  :success done\n"
                                  "  :body\n"
                                  "    ((if (a B)\n"
                                  "        (f))\n"
                                  "     (g)))\n");
  CHECK(ide::folds(document) == std::vector<Fold>{{0, 1, FoldKind::Comment},
                                                  {2, 8, FoldKind::Form},
                                                  {5, 8, FoldKind::Form},
                                                  {6, 8, FoldKind::Form}});
}

TEST_CASE("a selection grows from the word to the whole text") {
  test::MarkedSource source("; c\n(defskill m :success ok (:effects (a ^B)))\n");
  auto document = Document::parse(source.text);
  std::vector<std::string> words;
  for (auto range : ide::selections(document, source.point()))
    words.push_back(source.text.substr(range.begin, range.length()));
  CHECK(words == std::vector<std::string>{"B", "a B", "(a B)", ":effects (a B)", "(:effects (a B))",
                                          "ok (:effects (a B))", ":success ok (:effects (a B))",
                                          "defskill m :success ok (:effects (a B))",
                                          "(defskill m :success ok (:effects (a B)))",
                                          "; c\n(defskill m :success ok (:effects (a B)))",
                                          source.text});
}

TEST_CASE("each selection holds the one before it, everywhere") {
  auto document = Document::parse("; c\n(defskill m :body ((printf \"a b\" (+ 1 2)) (f.interrupt)\n"
                                  "(defsv a :init (1\n)\n");
  for (syntax::Offset at = 0; at <= document.text().size(); ++at) {
    auto ranges = ide::selections(document, at);
    REQUIRE_FALSE(ranges.empty());
    CHECK(ranges.back() == syntax::Range{0, static_cast<syntax::Offset>(document.text().size())});
    for (std::size_t i = 0; i < ranges.size(); ++i) {
      CHECK((ranges[i].begin <= at && at <= ranges[i].end));
      if (i > 0) CHECK(ranges[i - 1] != ranges[i]);
    }
  }
}

TEST_CASE("an include links to the file that it names") {
  test::MarkedSource source("(include \"[[../lib/a.proskill]]\") (include \"\") (include");
  auto links = ide::links("/w/x/main.proskill", Document::parse(source.text));
  REQUIRE(links.size() == 1);
  CHECK(links[0].range == source.range());
  CHECK(links[0].target == "/w/lib/a.proskill");
}

TEST_CASE("a platform links to its file") {
  test::MarkedSource source("(defplatform \"[[robot/arm.json]]\") (defplatform robot)");
  auto links = ide::links("/w/x/main.proskill", Document::parse(source.text));
  REQUIRE(links.size() == 1);
  CHECK(links[0].range == source.range());
  CHECK(links[0].target == "/w/x/robot/arm.json");
}
