#include "ide/features/rename.h"
#include "tests/ide/marked_program.h"
#include "tests/support/memory_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::MarkedProgram;

namespace {

std::expected<ide::RenamePlan, std::string> plan(const MarkedProgram& program,
                                                 std::string_view name) {
  return ide::rename(program.snapshot(), program.view(), program.at(), name);
}

/// The places of the renaming are the marked ones, in all files of the program.
void checkPlaces(const MarkedProgram& program, std::string_view name) {
  auto renaming = plan(program, name);
  if (!renaming) FAIL(renaming.error());
  std::vector<analysis::Location> places;
  const auto& files = program.view().program().files;
  for (analysis::FileId file = 0; file < files.size(); ++file)
    for (auto range : renaming->places[files[file].path]) places.push_back({file, range});
  CHECK(places == program.marked());
}

std::string refusal(const std::string& text, std::string_view name) {
  auto renaming = plan(MarkedProgram(text), name);
  return renaming ? std::string() : renaming.error();
}

} // namespace

TEST_CASE("a name is renamed where it is defined and used, and not in strings and comments") {
  checkPlaces(MarkedProgram("; lamp\n(defsv [[^lamp]] :states (On Off) :init On) ; lamp\n"
                            "(defevent lamp :effects ([[lamp]] On))\n"
                            "(defskill m :body ((printf \"lamp %s\" [[lamp]])))"),
              "light");
}

TEST_CASE("every kind of name") {
  checkPlaces(
      MarkedProgram("(defsv lamp :states ([[On]] Off) :init [[O^n]] :transitions (([[On]] Off)))"
                    "(defsv other :states (On) :init On)"
                    "(defevent e :effects (lamp [[On]]))"),
      "Bright");
  checkPlaces(MarkedProgram("(defskill [[go]] :input ($x int) :action (go $x))"
                            "(defskill m :body (([[g^o]] x 1) (if (= [[go]].status failure) "
                            "([[go]].interrupt))))"),
              "drive");
  checkPlaces(MarkedProgram("(defskill go :input ($[[x]] int) :action (go $[[x^]]))"
                            "(defskill m :body ((go [[x]] 1)))"),
              "$distance");
  checkPlaces(MarkedProgram("(defskill go :input ($[[soft]] bool) :precondition (p $[[soft]])"
                            ":body ((if (not $[[so^ft]]) (^ 1)) (^ (= $[[soft]] true))))"
                            "(defskill m :body ((go [[soft]] true)))"),
              "gently");
  checkPlaces(MarkedProgram("(defskill m :body ((label [[^again]]) (goto [[again]])))"), "top");
  checkPlaces(MarkedProgram("(defskill m :success [[do^ne]] :body ((success [[done]])))"), "ready");
}

TEST_CASE("over the files of a program, and over the programs of a file") {
  checkPlaces(MarkedProgram({{"main.proskill", "(include \"lib.proskill\")\n"
                                               "(defevent e :effects ([[la^mp]] On))"},
                             {"lib.proskill", "(defsv [[lamp]] :states (On Off) :init On)"}}),
              "light");
  const MarkedProgram two(
      {{"a.proskill", "(include \"lib.proskill\")\n(defevent a :effects (lamp On))"},
       {"b.proskill", "(include \"lib.proskill\")\n(defevent b :effects (lamp On))"},
       {"lib.proskill", "(defsv la^mp :states (On Off) :init On)"}});
  auto renaming = plan(two, "light");
  REQUIRE(renaming);
  CHECK(renaming->places.size() == 3);
}

TEST_CASE("a name that two programs define, and a file of both uses, is renamed in both") {
  const std::string use = "(defevent e :effects (lamp On))";
  const std::string include = "(include \"use.proskill\")\n";
  MarkedProgram program({{"use.proskill", use},
                         {"a.proskill", include + "(defsv la^mp :states (On Off) :init Off)"},
                         {"b.proskill", include + "(defsv lamp :states (On) :init On)"}});
  auto renaming = plan(program, "light");
  REQUIRE(renaming);
  for (const auto* file : {"/w/use.proskill", "/w/a.proskill", "/w/b.proskill"}) {
    INFO(file);
    CHECK(renaming->places[file].size() == 1);
  }
}

TEST_CASE("a name of more programs than are kept is renamed in all of them") {
  constexpr int kPrograms = 30;
  const std::string shared = "(defsv lamp :states (On Off) :init On)\n";
  std::map<std::string, std::string> files;
  files["/w/shared.proskill"] = shared + ";" + std::string(50'000, 'x');
  for (int i = 0; i < kPrograms; ++i)
    files[fmt::format("/w/{}.proskill", i)] =
        "(include \"shared.proskill\")\n(defevent e :effects (lamp On))\n";
  const auto disk = std::make_shared<test::MemoryFiles>(files);
  ide::OpenTexts texts; // all of them, since any may include others
  for (const auto& [path, text] : files)
    texts[path] = {"file://" + path, 1, syntax::Document::parse(text)};
  const auto graph = ide::graphOf(*disk, texts);
  const ide::Snapshot snapshot(disk, {}, graph);
  REQUIRE(snapshot.views("/w/shared.proskill").size() == kPrograms);
  const auto renaming = ide::rename(snapshot, snapshot.view("/w/shared.proskill"), 8, "light");
  if (!renaming) FAIL(renaming.error());
  CHECK(renaming->places.size() == kPrograms + 1);
}

TEST_CASE("what is no name, or stands where no name is, is refused") {
  const std::string text = "(defsv la^mp :states (On Off) :init On)";
  for (const auto* name : {"", "3d", "take-off", "élan", "a b", "$x", ":init", "skill.status"})
    CHECK(refusal(text, name).contains("is not a name"));
  CHECK(refusal("(def^sv lamp :states (On) :init On)", "x") == "not a name of the program");
  CHECK(refusal("; la^mp", "x") == "not a name of the program");
}

TEST_CASE("a name that is taken is refused, with the place of who has it") {
  CHECK(refusal("(defsv ^a :states (On) :init On)\n(defsv b :states (On) :init On)", "b") ==
        "there is already a state variable `b`, at main.proskill:2");
  CHECK(refusal("(defsv a :states (^On Off) :init On)", "Off")
            .contains("there is already a value `Off`"));
  CHECK(refusal("(defskill f :success ^a :failure b :action (x))", "b")
            .contains("there is already a tag"));
  CHECK(refusal("(defsv ^a :states (On) :init On) (defevent b :effects (a On))", "b").empty());
}

TEST_CASE("a name that would be captured is refused") {
  // `(= a b)` compares two variables; as a value of `a`, the second would be that value
  const std::string compare = "(defsv a :states (On Off) :init On)\n"
                              "(defsv ^b :states (On Off) :init On)\n"
                              "(defskill m :body ((^ (= a b))))";
  CHECK(refusal(compare, "Off") == "`Off` would get another meaning at main.proskill:3");
  CHECK(refusal(compare, "c").empty());
  // Keywords at places where they are keywords.
  CHECK_FALSE(refusal("(defskill ^f :action (x)) (defskill m :body ((f)))", "while").empty());
  CHECK_FALSE(refusal("(defsv ^a :states (On Off) :init On) (defskill m :body ((^ (a On))))", "not")
                  .empty());
  CHECK_FALSE(
      refusal("(defsv ^a :states (On Off) :init On) (defskill f :input ($x a) :action (f $x))",
              "int")
          .empty());
}

TEST_CASE("labels and tags are edited as one, other names are not") {
  const MarkedProgram label("(defskill m :body ((label [[aga^in]]) (goto [[again]])))");
  std::vector<syntax::Range> expected;
  for (auto place : label.marked()) expected.push_back(place.range);
  CHECK(ide::linkedPlaces(label.view(), label.at()) == expected);
  const MarkedProgram tag("(defskill m :success d^one :body ((success done)))");
  CHECK(ide::linkedPlaces(tag.view(), tag.at()).size() == 2);
  const MarkedProgram skill("(defskill ^go :action (x)) (defskill m :body ((go)))");
  CHECK(ide::linkedPlaces(skill.view(), skill.at()).empty());
  const MarkedProgram far(
      {{"main.proskill", "(include \"lib.proskill\")\n"
                         "(defskill m :body ((go) (if (= go.res don^e) (^ 1))))"},
       {"lib.proskill", "(defskill go :action (x) :success done)"}});
  CHECK(ide::linkedPlaces(far.view(), far.at()).empty());
}

TEST_CASE("a constant is renamed in conditions, fields, waits and intervals") {
  checkPlaces(MarkedProgram("(defconst [[^few]] 2)(defsv n :init [[few]] :min 0 :max [[few]])"
                            "(defskill m :time_interval [ [[few]],[[few]] ]"
                            " :body ((^ [[few]]) (^ (< n [[few]]) :timeout [[few]])))"),
              "many");
}
