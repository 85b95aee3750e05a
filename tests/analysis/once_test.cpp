#include "analysis/program/once.h"
#include "analysis/program/stop.h"

#include <catch2/catch.hpp>

#include <thread>
#include <vector>

using namespace proskill;

TEST_CASE("what is computed once is there for all who ask, at whatever time") {
  analysis::Once once;
  int computed = 0;
  std::atomic<int> right = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i)
      threads.emplace_back([&] {
        once([&] { ++computed; });
        right += computed == 1;
      });
  }
  CHECK(right == 8);
}

TEST_CASE("what was cancelled is computed by one of those who wait for it") {
  analysis::Once once;
  int begun = 0;
  int computed = 0;
  std::atomic<int> stopped = 0;
  std::atomic<int> right = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i)
      threads.emplace_back([&] {
        try {
          once([&] {
            const analysis::StopWhen stop([first = begun++ == 0] { return first; });
            analysis::stopIfAsked();
            ++computed;
          });
          right += computed == 1;
        } catch (const analysis::Stopped&) {
          ++stopped;
        }
      });
  }
  CHECK(begun == 2);
  CHECK(stopped == 1);
  CHECK(right == 7);
}
