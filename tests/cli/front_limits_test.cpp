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
