#include "fuzz/targets.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace proskill;

namespace {

namespace fs = std::filesystem;

/// Runs all texts of a folder. \return their number
std::size_t tryAll(const fs::path& folder, void (*target)(std::string_view)) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(PROSKILL_SOURCE_DIR / folder)) {
    if (!entry.is_regular_file()) continue;
    std::ostringstream text;
    text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
    INFO(entry.path());
    CHECK_NOTHROW(target(text.str()));
    ++count;
  }
  return count;
}

} // namespace

TEST_CASE("what the fuzzers have found stays fixed") {
  CHECK(tryAll("fuzz/corpus/proskill", fuzz::proskill) > 0);
  CHECK(tryAll("fuzz/corpus/fiacre", fuzz::fiacre) > 0);
  CHECK(tryAll("fuzz/corpus/bt", fuzz::bt) > 1);
  CHECK(tryAll("fuzz/corpus/gen", fuzz::gen) > 0);
  CHECK(tryAll("fuzz/corpus/leaves", fuzz::leaves) > 0);
  CHECK(tryAll("fuzz/corpus/rl", fuzz::rl) > 1);
  CHECK(tryAll("fuzz/corpus/protocol", fuzz::protocol) > 0);
  CHECK(tryAll("fuzz/corpus/http", fuzz::http) > 5);
  CHECK(tryAll("fuzz/corpus/tina", fuzz::tina) > 8);
}

TEST_CASE("what is fuzzed holds for the examples") {
  CHECK(tryAll("examples/fiacre", fuzz::fiacre) > 10);
  CHECK(tryAll("examples/patrol", fuzz::bt) > 4);
  CHECK(tryAll("examples/crane", fuzz::rl) > 2);
  CHECK(tryAll("examples/gripper", fuzz::gen) > 4);
  CHECK(tryAll("examples/rover", fuzz::proskill) > 3);
}

TEST_CASE("a fuzzer notices what is not so") {
  CHECK_THROWS(fuzz::expect(false, "two is one"));
  CHECK_NOTHROW(fuzz::expect(true, "one is one"));
}
