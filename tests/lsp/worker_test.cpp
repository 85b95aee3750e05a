#include "worker/run_worker.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

constexpr std::string_view kBegin =
    R"({"begin":{"properties":[{"name":"a","verdict":"inconclusive"},{"name":"b","verdict":"inconclusive"}],)"
    R"("exploration":{"stopped":""}}})";
constexpr std::string_view kDecided =
    R"({"decided":{"index":1,"property":{"name":"b","verdict":"holds"}}})";

/// The result of a process that prints these lines and ends.
std::expected<OrderedJson, worker::WorkerFailure> heard(const std::vector<std::string_view>& lines,
                                                        const std::string& afterwards = "exit 7") {
  std::string script;
  for (auto line : lines) script += "echo '" + std::string(line) + "'\n";
  return worker::runWorker({"/bin/sh", "-c", script + afterwards}, {}, rpc::Cancellation(), {});
}

} // namespace

TEST_CASE("what a process has decided is kept, whatever ends it") {
  SECTION("its death") {
    const auto report = heard({kBegin, kDecided}, "kill -9 $$");
    REQUIRE(report.has_value());
    CHECK((*report)["properties"][0]["verdict"] == "inconclusive");
    CHECK_THAT((*report)["properties"][0]["reason"].get<std::string>(),
               Catch::Contains("ended by signal 9"));
    CHECK((*report)["properties"][1] == OrderedJson({{"name", "b"}, {"verdict", "holds"}}));
    CHECK_THAT((*report)["exploration"]["stopped"].get<std::string>(),
               Catch::Contains("gave no answer"));
  }
  SECTION("its memory") {
    const auto report = heard({kBegin, kDecided, R"({"stopped":"there was not enough"})"});
    REQUIRE(report.has_value());
    CHECK((*report)["properties"][0]["reason"] == "there was not enough");
    CHECK((*report)["properties"][1]["verdict"] == "holds");
  }
}

TEST_CASE("a process that has decided nothing gives no report") {
  const auto nothing = heard({kBegin}, "exit 7");
  REQUIRE_FALSE(nothing.has_value());
  CHECK_THAT(nothing.error().message, Catch::Contains("exit code 7"));
  const auto refused = heard({kBegin, kDecided, R"({"error":"it cannot be explored"})"});
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().message == "it cannot be explored");
}

TEST_CASE("a report says null where a verdict was told before") {
  const auto report = heard(
      {kBegin, kDecided, R"({"report":{"properties":[{"name":"a","verdict":"violated"},null]}})"});
  REQUIRE(report.has_value());
  CHECK((*report)["properties"][0]["verdict"] == "violated");
  CHECK((*report)["properties"][1]["verdict"] == "holds");
}
