#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <utility>

#include <unistd.h>

using proskill::test::run;

namespace {

const std::string kDock = PROSKILL_SOURCE_DIR "/docs/tour/dock.proskill";

/// A program of 30,000 lines, whose model needs much more than 64 MiB.
class LargeProgram {
public:
  LargeProgram() {
    std::ofstream out(path);
    for (int i = 0; i < 6000; ++i)
      out << fmt::format("(defskill s{}\n  :time_interval [1,3]\n  :action (go)\n  :success ok\n"
                         "  :failure bad)\n",
                         i);
  }
  ~LargeProgram() { std::filesystem::remove(path); }
  LargeProgram(const LargeProgram&) = delete;
  LargeProgram& operator=(const LargeProgram&) = delete;

  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / fmt::format("front_limits_{}.proskill", ::getpid());
};

} // namespace

TEST_CASE("A limit that is met while the model is generated leaves nothing decided") {
  const LargeProgram program;
  const auto memory =
      run({PROSKILL_PROGRAM, "verify", "--memory-limit", "64", program.path.string()});
  CHECK(memory.exitCode == 3);
  CHECK(memory.out.empty());
  CHECK(memory.err == "error: nothing was decided: the memory limit was reached while the model "
                      "was generated; `--memory-limit` raises it\n");
}

TEST_CASE("A small program is read whatever the limit") {
  const std::pair<const char*, const char*> limits[] = {{"--time-limit", "0.000001"},
                                                        {"--memory-limit", "1"}};
  for (const auto& [option, least] : limits) {
    const auto done = run({PROSKILL_PROGRAM, "verify", option, least, kDock});
    INFO(option << ": " << done.err);
    CHECK(done.exitCode == 3);
    CHECK(done.out.find(" inconclusive\n") != std::string::npos);
    CHECK(done.out.find(fmt::format("`{}` raises it", option)) != std::string::npos);
  }
}

namespace {

long kibibytes(long mebibytes) { return mebibytes * 1024 * 110 / 100; }

/// Each of the variables is changed by an event, and one condition reads them all.
std::string manyVariables(int count) {
  std::string variables;
  std::string condition;
  for (int i = 0; i < count; ++i) {
    variables += fmt::format("(defsv v{0} :states (A B) :init A)\n"
                             "(defevent e{0} :effects (v{0} B))\n",
                             i);
    condition += fmt::format(" (v{} A)", i);
  }
  return variables + "(defskill m :precondition (ok (and" + condition +
         ")) :time_interval [1,2] :action (a) :success done)\n";
}

} // namespace

TEST_CASE("A trace of tens of thousands of steps holds the memory limit, and so does its report") {
  const proskill::test::TemporaryDirectory files;
  const auto day = files.write("day.proskill", R"(
(defsv go :states (Yes No) :init Yes)
(defevent stop :effects (go No))
(defskill look :time_interval [1,2] :action (l) :success d)
(defskill mission :time_interval [43200,86400] :success done
  :body ((while (go Yes) (look) (^ 1)) (success done)))
)");
  const auto verify = [&](const char* limit) {
    return run({PROSKILL_PROGRAM, "verify", "--format", "json", "--traces", "all", "--memory-limit",
                limit, day});
  };
  const auto cut = verify("160");
  CHECK(cut.peakKiB < kibibytes(160));
  CHECK(cut.out.find("without a trace: the memory limit was reached") != std::string::npos);
  CHECK(cut.out.find("inconclusive") == std::string::npos);
  const auto whole = verify("400"); // the tree of the JSON alone would take a gigabyte
  CHECK(whole.peakKiB < kibibytes(400));
  CHECK(whole.out.find("without a trace") == std::string::npos);
}

TEST_CASE("A condition over many variables holds the memory limit") {
  const proskill::test::TemporaryDirectory files;
  const auto path = files.write("many.proskill", manyVariables(2000));
  for (const long limit : {100, 150}) {
    CAPTURE(limit);
    const auto done =
        run({PROSKILL_PROGRAM, "verify", "--memory-limit", std::to_string(limit), path});
    CHECK(done.exitCode == 3);
    CHECK(done.peakKiB < kibibytes(limit));
  }
}
