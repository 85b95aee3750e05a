#pragma once

#include "tests/support/stand_ins.h"
#include "tests/tina/model.h"
#include "tina/backend.h"
#include "tina/graph_text.h"

#include <catch2/catch.hpp>

#include <sstream>

namespace proskill::test {

/// Counts to 2, a step every 1 to 2 units, then stops; `done` is passed in one way only.
inline constexpr auto kCount = R"(
process play_it is
states move, done
var n: 0..2 := 0
from move
    select
        wait [1,2]; on (n < 2); n := n + 1; to move
    []  wait [0,0]; on (n = 2); #stop; to done
    end
component main is par * in play_it end
main
property impossible is absent main/1/state done
property small is always main/1/value (n < 3)
property ends is absent main/1/tag stop
assert impossible
assert small
assert ends
)";

inline constexpr auto kFormulas =
    "op impossible = [] - play;\nop small = [] s;\nop ends = [] - e;\n"
    "impossible;\nsmall;\nends;\n";

inline tina::Tools toolsOf(const StandIns& programs) {
  auto tools = tina::findTools({}, [&](const std::string& name) -> std::optional<std::string> {
    if (name == "PATH") return programs.path();
    if (name == "FRACLIB") return programs.path("lib");
    return std::nullopt;
  });
  if (!tools) FAIL(tools.error().front());
  return std::move(*tools);
}

/// The model above, with fake tools.
struct Scene {
  Scene() : parsed(model(kCount)) {
    programs.formulas(kFormulas);
    programs.verdicts("FALSE\nTRUE\nFALSE\n");
    programs.counts("5 classe(s), 4 marking(s), 2 domain(s), 3 transition(s)\n0.000s\n");
    programs.graph(graphText());
  }

  [[nodiscard]] std::string graphText() const {
    std::ostringstream text;
    tina::writeKtzText(text, verify::stateGraph(parsed.program, verify::GraphKind::Classes).value(),
                       "main");
    return text.str();
  }
  std::expected<tina::Outcome, tina::Failure> run(tina::Options options = {}) {
    options.tools = toolsOf(programs);
    return tina::verify(parsed.program, parsed.provenance, {{0}, {1}, {2}}, options);
  }
  verify::Result result(const tina::Options& options = {}) {
    auto outcome = run(options);
    if (!outcome) FAIL(tina::explain(outcome.error()));
    return std::move(outcome->result);
  }
  tina::Failure failure(const tina::Options& options = {}) {
    auto outcome = run(options);
    REQUIRE_FALSE(outcome.has_value());
    return std::move(outcome.error());
  }

  fiacre::Parsed parsed;
  StandIns programs;
};

inline void checkTrace(const verify::Answer& answer) {
  CHECK(answer.truth == verify::Truth::False);
  INFO(answer.reason);
  REQUIRE(answer.trace.has_value());
  const auto& steps = answer.trace->steps;
  REQUIRE(steps.size() == 3);
  CHECK(steps[0].earliest.value == 1);
  CHECK(steps[1].earliest.value == 2);
  CHECK(steps[1].latest.value().value == 4);
  CHECK(steps[2].transitions == std::vector<std::string>{"play_it_1_t1"});
  REQUIRE(steps[0].changes.size() == 1);
  CHECK(steps[0].changes[0].after == "1");
}

} // namespace proskill::test
