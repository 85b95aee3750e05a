#include "tests/support/stand_ins.h"

#include <cstdlib>
#include <filesystem>

namespace proskill::test {

namespace fs = std::filesystem;

namespace {

constexpr auto kFrac = R"(mkdir "$2" && cp "$here/model.ltl" "$2/model.ltl" && : > "$2/model.c")";
constexpr auto kCc = ": > model.tts/model.so";
constexpr auto kSift = R"(: > model.ktz; cat "$here/counts")";
constexpr auto kKtzio = R"(cp "$here/graph.txt" "$2")";
constexpr auto kSelt = R"(scenario=
while [ $# -gt 0 ]; do
  if [ "$1" = -S ]; then scenario=$2; fi
  shift
done
if [ -z "$scenario" ]; then cat "$here/verdicts"; exit; fi
if [ -f "$here/scenario" ]; then cp "$here/scenario" "$scenario"; fi
if [ -f "$here/proof" ]; then cat "$here/proof"; fi)";

} // namespace

StandIns::StandIns() {
  replace("frac", kFrac);
  replace("cc", kCc);
  replace("sift", kSift);
  replace("selt", kSelt);
  replace("ktzio", kKtzio);
  fs::create_directories(path("lib") + "/avl");
  formulas("");
  verdicts("");
  counts("1 classe(s), 1 marking(s), 1 domain(s), 0 transition(s)\n0.000s\n");
}

void StandIns::counterexample(const std::string& scenario, const std::string& text) {
  if (!scenario.empty()) write("scenario", scenario);
  write("proof", text);
}

void StandIns::replace(const std::string& tool, const std::string& body) {
  write(tool, "#!/bin/sh\nhere=$(dirname \"$0\")\n" + body + "\n");
  fs::permissions(path(tool), fs::perms::owner_all);
}

void StandIns::remove(const std::string& tool) { fs::remove(path(tool)); }

std::string StandIns::searchPath() const {
  const char* before = std::getenv("PATH");
  return "PATH=" + path() + ":" + (before == nullptr ? "" : before);
}

} // namespace proskill::test
