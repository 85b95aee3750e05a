#include "rpc/scheduler.h"

#include <catch2/catch.hpp>

#include <latch>
#include <string>

using namespace proskill;
using namespace proskill::rpc;
using namespace std::chrono_literals;

TEST_CASE("background work gives way to what somebody waits for") {
  std::string order;
  std::latch begun(1), waiting(1), done(2);
  {
    rpc::Scheduler scheduler(3, 1h);
    scheduler.post(rpc::Priority::Interactive, [&] {
      begun.count_down();
      waiting.wait();
      order += "answer ";
      done.count_down();
    });
    scheduler.post(rpc::Priority::Background, [&] {
      begun.wait();
      waiting.count_down();
      scheduler.giveWay();
      order += "rest";
      done.count_down();
    });
    done.wait();
  }
  CHECK(order == "answer rest");
}

TEST_CASE("background work does not give way for ever") {
  std::latch begun(1), end(1), passed(1);
  rpc::Scheduler scheduler(3, 0ms);
  scheduler.post(rpc::Priority::Interactive, [&] {
    begun.count_down();
    end.wait();
  });
  scheduler.post(rpc::Priority::Background, [&] {
    begun.wait();
    scheduler.giveWay();
    passed.count_down();
  });
  passed.wait(); // otherwise this would wait for ever
  end.count_down();
}
