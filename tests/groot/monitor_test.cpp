#include "groot/monitor.h"
#include "tests/groot/watched_run.h"

#include <catch2/catch.hpp>

#include <semaphore>

using namespace proskill;
using groot::Parts;
using test::WatchedRun;

namespace {

/// A viewer that asks for statuses when the test says so. Meanwhile the thread of a monitor sleeps.
class Viewer final : public groot::Sockets {
public:
  [[nodiscard]] std::uint16_t port() const override { return 0; }
  void wait(int, long) override {
    if (!isGone) turn.acquire();
  }
  [[nodiscard]] std::optional<Parts> receive() override {
    return isGone ? std::nullopt : std::optional(Parts{"\2S1234"});
  }
  void reply(const Parts& parts) override {
    answer = parts.at(1);
    answered.release();
  }

  void publish(const Parts&) override {}

  /// The test's.
  std::string ask() {
    turn.release();
    answered.acquire();
    return answer;
  }
  void leave() {
    isGone = true;
    turn.release();
  }

private:
  std::string answer;
  std::binary_semaphore turn{0};
  std::binary_semaphore answered{0};
  std::atomic<bool> isGone{false};
};

/// The nodes that run, according to a reply.
std::set<std::size_t> running(const std::string& statuses) {
  std::set<std::size_t> all;
  for (std::size_t at = 2; at < statuses.size(); at += 3)
    if (statuses[at] == 1) all.insert(at / 3 + 1);
  return all;
}

} // namespace

TEST_CASE("in real time a full queue skips states, and with the next one statuses are right") {
  WatchedRun it(R"(
    (defskill fly :time_interval [1,2] :action (fly) :success there :failure lost)
    (defskill look :body ((fly) (^ 1)))
    (defskill mission :body (
      (while true (// ((look)) ((^ 1))) (if (= fly.status success) (look) else (^ 2))))))");
  auto made = std::make_unique<Viewer>();
  auto& viewer = *made;
  groot::Monitor monitor(it.tree, *it.executable, std::move(made), false, {});
  std::vector<verify::Word> last;
  std::set<std::size_t> expected;
  std::size_t steps = 0;
  it.run(
      [&](const groot::Statuses& statuses, runtime::Nanoseconds, const auto& state) {
        monitor.push(state);
        last = state;
        expected.clear();
        for (std::size_t i = 0; i < statuses.bytes().size(); ++i)
          if (statuses.bytes()[i] == 1) expected.insert(i + 1);
        ++steps;
      },
      0, "", 20'000);
  CHECK(steps > 40'000); // the queue has room for fewer than half of them
  CHECK(expected.size() > 2);
  std::ignore = viewer.ask(); // after this, the queue is empty
  monitor.push(last);
  CHECK(running(viewer.ask()) == expected);
  viewer.leave();
}
