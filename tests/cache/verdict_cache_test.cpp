#include "cache/verdict_cache.h"
#include "report/report_json.h"
#include "tests/support/random/random_program.h"
#include "tests/support/random/seeds.h"
#include "tests/support/run.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <random>

using namespace proskill;
namespace fs = std::filesystem;

namespace {

struct Subject {
  explicit Subject(const std::string& text)
      : program(test::programOfText(text)), model(codegen::generate(program, {}).value()) {}

  analysis::Program program;
  codegen::Model model;
};

/// A report as users get it, and how many of its verdicts were known from before.
struct Verified {
  std::string report;
  std::uint64_t known = 0;
  std::size_t checks = 0;
  std::uint64_t classes = 0;
};

Verified verified(const Subject& subject, const fs::path& directory,
                  const std::vector<std::string>& names = {}) {
  verify::Options options;
  const auto cache = cache::cacheFor(directory, subject.model);
  options.answers = cache.get();
  const auto result = ide::verifyModel(subject.model, names, options);
  REQUIRE(result);
  auto json = report::reportJson({subject.program, subject.model, *result, ""});
  json.erase("exploration");
  return {json.dump(1), result->exploration.known, result->rows.size(),
          result->exploration.classes};
}

/// Whether some verdict needs a large state space. A few random programs do.
bool isLarge(const Subject& subject) {
  verify::Options options;
  options.limits.classes = 30'000;
  options.wantsTrace = [](std::size_t) { return false; };
  const auto result = ide::verifyModel(subject.model, {}, options);
  REQUIRE(result);
  return std::ranges::any_of(
      result->rows, [](const auto& row) { return row.verdict == ide::Verdict::Inconclusive; });
}

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void replace(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

std::vector<fs::path> filesIn(const fs::path& directory,
                              const std::string& extension = ".verdicts") {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(directory))
    if (entry.path().extension() == extension) files.push_back(entry.path());
  return files;
}

std::vector<std::string> verdictsIn(const std::string& report) {
  std::vector<std::string> verdicts;
  const auto json = OrderedJson::parse(report);
  for (const auto& property : json["properties"])
    verdicts.push_back(property["verdict"].get<std::string>() + property.value("reason", ""));
  return verdicts;
}

bool isCorrect(const std::string& text) {
  const auto program = test::programOfText(text);
  return test::isWellFormed(program) && codegen::generate(program, {}).has_value();
}

/// Changes a number of a program such that it stays correct. \return whether there is one
bool editNumber(std::string& text, std::mt19937& random) {
  for (int tries = 0; tries < 50; ++tries) {
    auto other = text;
    auto& letter = other[random() % other.size()];
    if (letter < '0' || letter > '9') continue;
    letter = static_cast<char>('0' + random() % 4);
    if (other == text || !isCorrect(other)) continue;
    text = std::move(other);
    return true;
  }
  return false;
}

const std::string kLamp = "(defsv lamp :states (On Off) :init Off :transitions ((Off On)))\n"
                          "(defevent on :effects (lamp On))\n"
                          "(defskill m :body ((^ (lamp On)) (set (lamp Off))))\n"
                          "(defproperty p (leadsto (running m) (ended m) :within [0,3]))\n";

} // namespace

TEST_CASE("kept verdicts and their traces are those that are found without them") {
  std::size_t violated = 0;
  const auto [first, end] = test::seedsOr(0, 150);
  for (auto seed = first; seed < end; ++seed) {
    const test::TemporaryDirectory directory;
    const auto text = test::textOf(test::randomProgram(seed, {.scopes = 50}));
    INFO("seed " << seed << "\n" << text);
    const Subject subject(text);
    if (isLarge(subject)) continue;
    const auto without = verified(subject, "");
    CHECK(without.known == 0);
    CHECK(verified(subject, directory.path()).report == without.report);
    const auto again = verified(subject, directory.path());
    CHECK(again.report == without.report);
    CHECK(again.known >= again.checks); // the question whether time goes on may be added
    violated += without.report.find("\"violated\"") != std::string::npos ? 1 : 0;
  }
  CHECK(violated > 10);
}

TEST_CASE("what is not kept is explored, whatever else is") {
  std::mt19937 random(7);
  const auto [first, end] = test::seedsOr(1000, 100);
  for (auto seed = first; seed < end; ++seed) {
    const test::TemporaryDirectory directory;
    const auto text = test::textOf(test::randomProgram(seed, {.scopes = 50}));
    INFO("seed " << seed << "\n" << text);
    const Subject subject(text);
    if (isLarge(subject)) continue;
    std::vector<std::string> some;
    for (const auto& check : subject.model.checks)
      if (random() % 3 == 0) some.push_back(check.name);
    if (some.empty()) continue;
    (void)verified(subject, directory.path(), some);
    const auto mixed = verified(subject, directory.path());
    CHECK(mixed.known > 0);
    // Traces may differ if fewer questions are asked together; verdicts may not.
    const Subject fresh(text);
    CHECK(verdictsIn(mixed.report) == verdictsIn(verified(fresh, "").report));
  }
}

TEST_CASE("comments and layout cost nothing, a change of meaning is another model") {
  const test::TemporaryDirectory directory;
  (void)verified(Subject(kLamp), directory.path());
  const auto commented = verified(Subject("; a comment\n\n" + kLamp), directory.path());
  CHECK(commented.known == commented.checks);
  auto other = kLamp;
  other.replace(other.find("[0,3]"), 5, "[0,4]"); // one question differs
  const auto asked = verified(Subject(other), directory.path());
  CHECK(asked.known == asked.checks - 1);
  CHECK(filesIn(directory.path()).size() == 1);
  other = kLamp;
  other.replace(other.find("((Off On))"), 10, "((On Off))");
  CHECK(verified(Subject(other), directory.path()).known < asked.checks);
  CHECK(filesIn(directory.path()).size() == 2);
  other = kLamp;
  other.replace(other.find(":init Off"), 9, ":init (On Off)");
  CHECK(verified(Subject(other), directory.path()).known < asked.checks);
  CHECK(filesIn(directory.path()).size() == 3);
}

TEST_CASE("verdicts after an edit are those of the edited program") {
  std::mt19937 random(5);
  std::uint64_t known = 0;
  const auto [first, end] = test::seedsOr(3000, 150);
  for (auto seed = first; seed < end; ++seed) {
    const test::TemporaryDirectory directory;
    const auto text = test::textOf(test::randomProgram(seed, {.scopes = 50}));
    auto edited = text;
    if (!editNumber(edited, random) || isLarge(Subject(text)) || isLarge(Subject(edited))) continue;
    (void)verified(Subject(text), directory.path());
    INFO("seed " << seed << "\n" << text << "\n--- edited:\n" << edited);
    const Subject subject(edited);
    const auto with = verified(subject, directory.path());
    CHECK(verdictsIn(with.report) == verdictsIn(verified(subject, "").report));
    known += with.known;
  }
  CHECK(known > 50);
}

TEST_CASE("times and what is lost are kept, with the runs that show them") {
  const test::TemporaryDirectory directory;
  const Subject subject("(defsv n :states (Idle Done) :init Idle)\n"
                        "(defskill drive :time_interval [2,5[ :action (go) :failure stuck)\n"
                        "(defskill m :body ((^ [1,10]) (drive)\n"
                        "  (if (= drive.status success) (set (n Done)))))\n"
                        "(defproperty p (longest (running drive) (ended drive)))\n"
                        "(defproperty q (longest (running drive) (n Done)))\n"
                        "(defproperty r (shortest (n Done) (running drive)))\n"
                        "(defproperty s (always_reachable (n Done)))\n");
  const std::vector<std::string> names{"p", "q", "r", "s"};
  const auto first = verified(subject, directory.path(), names);
  const auto again = verified(subject, directory.path(), names);
  CHECK(again.report == first.report);
  CHECK(again.known == 5); // with whether time can always go on, which the times depend on
  CHECK(again.report.find("\"less than 5 s\"") != std::string::npos);
}

TEST_CASE("a run of an earlier version does not show that something has become impossible") {
  const test::TemporaryDirectory directory;
  const std::string text = "(defsv n :states (A B C) :init A :transitions :all)\n"
                           "(defsv o :states (Off On) :init Off)\n"
                           "(defevent switch :effects (o On))\n"
                           "(defskill m :body ((set (n B))))\n"
                           "(defproperty p (always_reachable (o Off)))\n"
                           "(defproperty q (longest (n A) (n B)))\n";
  (void)verified(Subject(text), directory.path());
  auto edited = text; // now it can be switched off again
  edited.replace(edited.find("switch :effects (o On)"), 22, "switch :effects (o Off)");
  const Subject subject(edited);
  CHECK(verdictsIn(verified(subject, directory.path(), {"p", "q"}).report) ==
        verdictsIn(verified(subject, "", {"p", "q"}).report));
}

TEST_CASE("an edit of one of many parts leaves what is known of the others") {
  const auto skills = [](int last) {
    std::string text;
    for (int i = 0; i < 12; ++i)
      text += fmt::format(
          "(defsv dev_{0} :states (Off Ready Busy) :init Ready)\n"
          "(defevent off_{0} :effects (dev_{0} Off))\n"
          "(defskill step_{0} :precondition (p (dev_{0} Ready)) :start (dev_{0} Busy)\n"
          "  :invariant (on (:guard (/= dev_{0} Off))) :time_interval [1,{1}] :action (a)\n"
          "  :success done (:effects (dev_{0} Ready)) :failure lost)\n"
          "(defskill look_{0} :monitor t :time_interval [1,9] :body ((step_{0}) (^ 2) "
          "(step_{0})))\n",
          i, i == 3 ? last : 5);
    return text;
  };
  const test::TemporaryDirectory directory;
  const auto before = verified(Subject(skills(5)), directory.path());
  const Subject edited(skills(6));
  const auto after = verified(edited, directory.path());
  CHECK(after.classes * 10 < before.classes);
  CHECK(verdictsIn(after.report) == verdictsIn(verified(edited, "").report));
}

TEST_CASE("a damaged file counts as none") {
  const test::TemporaryDirectory directory;
  const Subject subject(kLamp);
  const auto good = verified(subject, directory.path()).report;
  const auto file = filesIn(directory.path()).at(0);
  const auto bytes = bytesOf(file);
  for (const auto& damaged :
       {std::string(), std::string(5, 'x'), bytes.substr(0, bytes.size() / 2), bytes + "x",
        std::string(1 << 20, '\xff'), bytes.substr(0, 40) + "y" + bytes.substr(41)}) {
    replace(file, damaged);
    const auto found = verified(subject, directory.path());
    CHECK(found.known == 0);
    CHECK(found.report == good);
    CHECK(bytesOf(file) == bytes); // and is written again
  }
}

TEST_CASE("steps that do not show what they are kept for are not believed") {
  std::mt19937 random(11);
  const Subject subject(kLamp);
  const auto good = verified(subject, "").report;
  for (int round = 0; round < 200; ++round) {
    const test::TemporaryDirectory directory;
    {
      const auto cache = cache::cacheFor(directory.path(), subject.model);
      const auto asked = ide::askedOf(subject.model, {});
      for (const auto& question : asked.questions) {
        verify::KnownAnswer forged;
        for (auto i = random() % 4; i > 0; --i)
          forged.evidence.steps.push_back(static_cast<verify::TransitionId>(random() % 30));
        for (auto i = random() % 3; i > 0; --i)
          forged.evidence.marks.push_back({.after = random() % 4,
                                           .until = random() % 4,
                                           .atStep = random() % 2 == 0,
                                           .ticks = random() % 4 == 0,
                                           .location = static_cast<std::uint32_t>(random() % 4),
                                           .edge = static_cast<std::uint32_t>(random() % 4)});
        if (random() % 3 == 0) forged.evidence.loop = random() % 5;
        if (random() % 3 == 0) forged.evidence.rest = random() % 5;
        cache->keep(question, forged);
      }
    }
    const auto found = OrderedJson::parse(verified(subject, directory.path()).report);
    const auto expected = OrderedJson::parse(good);
    for (std::size_t i = 0; i < expected["properties"].size(); ++i)
      CHECK(found["properties"][i]["verdict"] == expected["properties"][i]["verdict"]);
  }
}

TEST_CASE("where time is up before a kept violation is replayed, what needs no replay is said") {
  const test::TemporaryDirectory directory;
  const Subject subject(kLamp);
  (void)verified(subject, directory.path());
  verify::Options options;
  double now = 0;
  options.limits.seconds = 1;
  options.clock = [&now] { return now; };
  const auto cache = cache::cacheFor(directory.path(), subject.model);
  options.answers = cache.get();
  const auto result = ide::verifyModel(subject.model, {}, options, [&](std::size_t, const auto&) {
    now = 2; // from the first verdict on
  });
  REQUIRE(result);
  std::size_t decided = 0;
  for (const auto& row : result->rows) decided += row.verdict != ide::Verdict::Inconclusive;
  CHECK(decided > 1);
  CHECK(result->exploration.stopped == "the time limit was reached");
}

TEST_CASE("two processes add to what is kept of a model") {
  const test::TemporaryDirectory directory;
  const Subject subject(kLamp);
  const auto questions = ide::askedOf(subject.model, {}).questions;
  const auto first = cache::cacheFor(directory.path(), subject.model);
  const auto second = cache::cacheFor(directory.path(), subject.model);
  first->keep(questions.at(0), {true, {}});
  second->keep(questions.at(1), {true, {}});
  CHECK_FALSE(first->save());
  CHECK_FALSE(second->save());
  const auto third = cache::cacheFor(directory.path(), subject.model);
  CHECK(third->find(questions.at(0)));
  CHECK(third->find(questions.at(1)));
  CHECK_FALSE(third->find(questions.at(2)));
}

TEST_CASE("what was not used for the longest time goes first") {
  const test::TemporaryDirectory directory;
  const auto now = fs::file_time_type::clock::now();
  for (const int hour : {1, 2, 3, 4}) {
    const auto file = directory.write(std::to_string(hour) + ".verdicts", "");
    fs::resize_file(file, 20'000'000);
    fs::last_write_time(file, now - std::chrono::hours(hour));
  }
  directory.write("notes.txt", "not one of ours");
  (void)verified(Subject(kLamp), directory.path());
  CHECK(fs::exists(directory.path("1.verdicts")));
  CHECK(fs::exists(directory.path("2.verdicts")));
  CHECK_FALSE(fs::exists(directory.path("3.verdicts")));
  CHECK_FALSE(fs::exists(directory.path("4.verdicts")));
  CHECK(fs::exists(directory.path("notes.txt")));
  CHECK(filesIn(directory.path()).size() == 3);
}

TEST_CASE("where nothing can be kept, verdicts are as ever") {
  const test::TemporaryDirectory directory;
  const auto file = directory.write("file", "");
  const Subject subject(kLamp);
  CHECK(verified(subject, file + "/below").report == verified(subject, "").report);
  const auto cache = cache::cacheFor(file + "/below", subject.model);
  cache->keep(ide::askedOf(subject.model, {}).questions.at(0), {true, {}});
  const auto problem = cache->save();
  REQUIRE(problem);
  CHECK(problem->starts_with("the directory"));
}
