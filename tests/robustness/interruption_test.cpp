#include "tests/robustness/broken_text.h"
#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace proskill;
using test::Finished;
namespace fs = std::filesystem;

namespace {

const std::string kTour = PROSKILL_SOURCE_DIR "/docs/tour/dock.proskill";

/// Six counters of a thousand values each: too many states to explore.
constexpr const char* kEndless = "process p is\n"
                                 "states s\n"
                                 "var x : 0..999 := 0\n"
                                 "from s x := (x + 1) % 1000; loop\n"
                                 "component main is par p || p || p || p || p || p end\n"
                                 "property q is ltl [] <> (main/1/value x = 5)\n"
                                 "assert q\n"
                                 "main\n";

std::string contentOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::size_t filesIn(const std::string& directory) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

Finished shell(const std::string& script) {
  return test::run({"/bin/sh", "-c", "proskill=" PROSKILL_PROGRAM "; " + script});
}

/// Every kind of output, without its destination.
const std::vector<std::string> kPrinting{"check --format json " + kTour,
                                         "check --format sarif " + kTour,
                                         "emit fiacre " + kTour,
                                         "verify " + kTour,
                                         "verify --format json " + kTour,
                                         "verify --format junit " + kTour,
                                         "graph --kind calls " + kTour,
                                         "explain --markdown",
                                         "explain --list",
                                         "verify --help"};

/// Not by a crash, and not as an internal error.
bool endedInOrder(const Finished& done) {
  return done.exitCode <= 3 && done.err.find("internal error") == std::string::npos;
}

} // namespace

TEST_CASE("an output that nobody reads ends a command in order") {
  for (const auto& words : kPrinting) {
    INFO(words);
    const auto silent = shell("$proskill " + words + " >&-");
    CHECK(silent.exitCode == 2);
    CHECK(endedInOrder(silent));
    CHECK(silent.err.find("standard output") != std::string::npos);
    const auto gone = shell("trap '' PIPE; { $proskill " + words + "; echo $? >&2; } | : ; exit 0");
    CHECK(endedInOrder(gone));
  }
}

TEST_CASE("servers end when their client is gone") {
  for (const char* server : {"lsp", "dap"}) {
    INFO(server);
    const auto done = shell("timeout 20 $proskill " + std::string(server) + " </dev/null | :");
    CHECK(endedInOrder(done));
    const auto closed =
        shell("timeout 20 $proskill " + std::string(server) + " <&- >&-; [ $? -lt 4 ]");
    CHECK(closed.exitCode == 0);
  }
}

TEST_CASE("a verification that is interrupted ends soon, and leaves every file as it was") {
  for (const auto& [name, code] : {std::pair{"INT", 130}, {"TERM", 143}, {"HUP", 129}}) {
    INFO(name);
    const test::TemporaryDirectory files;
    const auto model = files.write("endless.fcr", kEndless);
    const auto graph = files.write("graph.aut", "before\n");
    const auto done =
        shell("timeout --kill-after 20 --preserve-status --signal " + std::string(name) +
              " 1 $proskill verify --graph " + graph + " " + model);
    CHECK((done.exitCode == code || done.exitCode == 3)); // by the signal, or undecided
    CHECK(contentOf(graph) == "before\n");
    CHECK(filesIn(files.path()) == 2);
  }
}

TEST_CASE("runs at the same time each leave a whole output") {
  const test::TemporaryDirectory files;
  const auto model = shell("$proskill emit fiacre " + kTour).out;
  const auto out = files.path("model.fcr");
  const auto done =
      shell("for i in 1 2 3 4 5 6 7 8; do $proskill emit fiacre -o " + out + " " + kTour +
            " & pids=\"$pids $!\"; done; for p in $pids; do wait $p || exit 1; done");
  CHECK(done.exitCode == 0);
  CHECK(done.err.empty());
  CHECK(contentOf(out) == model);
  CHECK(filesIn(files.path()) == 1);
}

TEST_CASE("directories that are links into themselves are read once") {
  const test::TemporaryDirectory files;
  fs::create_symlink(".", files.path("loop"));
  const auto root = files.write("main.proskill", "(include \"loop/loop/part.proskill\")\n"
                                                 "(include \"loop/part.proskill\")\n"
                                                 "(include \"loop/main.proskill\")\n");
  files.write("part.proskill", "(defsv lamp :states (On Off) :init Off :transitions :all)\n");
  const auto done = shell("timeout 20 $proskill check --format short " + root);
  INFO(done.out);
  CHECK(done.exitCode <= 1);
  CHECK(done.out.find("PS0201") == std::string::npos); // defined twice
}

TEST_CASE("a million parentheses are refused or read, by every command") {
  const test::TemporaryDirectory files;
  constexpr std::size_t kMany = 1'000'000;
  for (const auto& text : {test::repeated("(", kMany), test::repeated(")", kMany),
                           test::repeated("(", kMany) + test::repeated(")", kMany),
                           "(defskill s :body (" + test::repeated("(if true ", kMany) + "(s)" +
                               test::repeated(")", kMany) + "))"}) {
    const auto path = files.write("deep.proskill", text);
    for (const char* command : {"check", "fmt --check", "emit fiacre", "verify"}) {
      INFO(command << " " << text.substr(0, 30));
      CHECK(endedInOrder(shell("exec timeout 60 $proskill " + std::string(command) + " " + path)));
    }
  }
}

TEST_CASE("JSON that is nested too deep is refused by all that read it") {
  const test::TemporaryDirectory files;
  constexpr std::size_t kMany = 200'000;
  const auto list = test::repeated("[", kMany) + test::repeated("]", kMany);
  const auto path = files.write("deep.json", "{\"steps\": " + list + ", \"a\": 1, \"b\": 2}");
  for (const auto& command :
       std::vector{"view --no-open " + path, "conform " + path + " " + kTour,
                   "run --platform " + path + " " + kTour, "replay " + kTour + " " + path}) {
    const auto done = shell("exec timeout 60 $proskill " + command);
    INFO(command << "\n" << done.err);
    CHECK(done.exitCode == 2);
    CHECK(endedInOrder(done));
  }
}

TEST_CASE("nothing in a program becomes a part of the page that reports on it") {
  const test::TemporaryDirectory files;
  const std::string attack = "</script><script>alert(1)</script><img src=x onerror=alert(1)>";
  const std::string program = "(defsv lamp :states (On Off) :init Off :transitions ((On Off)))\n"
                              "(defskill s :start (lamp On) :action (a) :success ok)\n"
                              "(defskill m :time_interval [5,6] :success ok"
                              " :body ((s) (success ok)))\n";
  const auto pageOf = [&](const std::string& name, const std::string& text) {
    const auto path = files.write(name, text);
    const auto done =
        test::run({PROSKILL_PROGRAM, "verify", "--report", files.path("report"), path});
    CHECK(done.exitCode == 1);
    return contentOf(files.path("report/index.html"));
  };
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  const auto plain = pageOf("plain.proskill", "; a comment\n" + program);
  REQUIRE(count(plain, "<script") > 0);
  for (const auto& page : {pageOf("plain.proskill", "; " + attack + "\n" + program),
                           pageOf("<script>alert(1)<!--.proskill", program)}) {
    CHECK(count(page, "<script") == count(plain, "<script"));
    CHECK(count(page, "</script") == count(plain, "</script"));
    CHECK(count(page, "<img") == count(plain, "<img"));
    CHECK(count(page, "<!--") == count(plain, "<!--"));
  }
}
