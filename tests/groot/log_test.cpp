#include "groot/bytes.h"
#include "groot/log.h"
#include "tests/groot/watched_run.h"

#include <catch2/catch.hpp>

using namespace proskill;
using test::WatchedRun;

TEST_CASE("numbers of logs are little-endian, and times have six bytes") {
  std::string text;
  groot::addBytes(text, 0x0102, 3);
  CHECK(text == std::string("\2\1\0", 3));
  text.clear();
  groot::addChange(text, 0x010203040506, 0x0708, 9);
  CHECK(text == "\6\5\4\3\2\1\x08\7\x09");
}

TEST_CASE("the changes of a log give the statuses of the run") {
  WatchedRun it(R"(
    (defskill fly :action (fly) :success there)
    (defskill search :success found :body ((fly) (success found)))
    (defskill mission :body ((search) (^ 1))))");
  std::string log;
  const auto add = [&](std::string_view bytes) { log += bytes; };
  const auto logging = groot::logOf(it.tree, *it.executable, add, 5'000'000);
  groot::Statuses statuses(it.tree, *it.executable, [](groot::Uid, groot::Status) {});
  test::Watcher watcher([&](const runtime::Machine& machine, runtime::Nanoseconds date) {
    logging->onStep(machine, 0, date, 0);
    statuses.follow(machine.state().data());
  });
  test::execute(*it.executable, watcher, 0);
  const auto xml = groot::xmlOf(it.tree);
  std::string begin = "BTCPP4-FileLogger2\1";
  groot::addBytes(begin, xml.size(), 4);
  begin += xml;
  groot::addBytes(begin, 5'000, 8);
  REQUIRE(log.starts_with(begin));
  REQUIRE((log.size() - begin.size()) % 9 == 0);
  std::vector<std::uint8_t> last(it.tree.size());
  for (auto at = begin.size(); at < log.size(); at += 9)
    last[static_cast<std::uint8_t>(log[at + 6]) - 1U] = static_cast<std::uint8_t>(log[at + 8]);
  auto expected = statuses.bytes();
  for (auto& byte : expected) byte = byte >= 10 ? 0 : byte;
  CHECK(last == expected);
  CHECK(last.front() == 2);
}
