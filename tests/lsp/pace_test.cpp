#include "lsp/server/pace.h"

#include <catch2/catch.hpp>

#include <thread>

using namespace proskill;
using namespace std::chrono_literals;

TEST_CASE("diagnostics do not wait where those of all texts took next to no time") {
  lsp::Pace pace;
  CHECK_FALSE(pace.isQuick());
  pace.begin(1, 2);
  pace.finish(1, 1ms);
  CHECK_FALSE(pace.isQuick());
  pace.finish(1, 4ms);
  CHECK(pace.isQuick());
  pace.begin(2, 1);
  CHECK_FALSE(pace.isQuick());
  pace.finish(1, 1ms); // of the previous round
  CHECK_FALSE(pace.isQuick());
  pace.finish(2, 7ms);
  CHECK_FALSE(pace.isQuick());
  pace.begin(3, 0);
  CHECK(pace.isQuick());
}

TEST_CASE("the work of others does not count as a thread's own") {
  const auto began = lsp::ThreadClock::now();
  lsp::ThreadClock::duration others{};
  std::thread([&] {
    const auto begin = lsp::ThreadClock::now();
    while (others < lsp::Pace::kUnnoticed) others = lsp::ThreadClock::now() - begin;
  }).join();
  CHECK(lsp::ThreadClock::now() - began < others);
}
