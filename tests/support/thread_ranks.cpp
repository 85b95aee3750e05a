#include "tests/support/thread_ranks.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace proskill::test {

class ThreadRanks::Rank : public verify::Ranks {
public:
  Rank(ThreadRanks& of, unsigned number)
      : team(of), me(number), generator(of.seed * of.count + number) {}

  [[nodiscard]] unsigned self() const override { return me; }
  [[nodiscard]] unsigned count() const override { return team.count; }

  void send(unsigned to, std::string bytes) override {
    const std::lock_guard lock(team.guard);
    team.mailboxes[to].push_back({{me, std::move(bytes)}, static_cast<unsigned>(generator() % 4)});
    ++team.underWay[me];
  }
  [[nodiscard]] bool isBusy() override {
    const std::lock_guard lock(team.guard);
    return team.underWay[me] > 3;
  }

  [[nodiscard]] std::optional<Message> receive() override {
    const std::lock_guard lock(team.guard);
    auto& mailbox = team.mailboxes[me];
    std::vector<bool> isHeld(team.count); // by rank: an earlier message of it is delayed
    for (auto mail = mailbox.begin(); mail != mailbox.end(); ++mail) {
      const unsigned from = mail->message.from;
      if (mail->delay > 0) --mail->delay;
      if (mail->delay > 0 || isHeld[from]) {
        isHeld[from] = true;
        continue;
      }
      Message message = std::move(mail->message);
      mailbox.erase(mail);
      --team.underWay[from];
      return message;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool isRoundOver() override {
    const std::lock_guard lock(team.guard);
    if (team.underWay[me] > 0) return false;
    if (!std::exchange(hasFinished, true)) ++team.finished;
    if (team.finished < (rounds + 1) * team.count) return false;
    ++rounds;
    hasFinished = false;
    return true;
  }

  void sum(std::span<std::uint64_t> numbers) override {
    const std::string_view own(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    const auto all = gather(std::string(own));
    std::ranges::fill(numbers, 0);
    for (const auto& each : all)
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        std::uint64_t number = 0;
        std::copy_n(each.data() + i * sizeof number, sizeof number,
                    reinterpret_cast<char*>(&number));
        numbers[i] += number;
      }
  }

  [[nodiscard]] std::vector<std::string> gather(const std::string& own) override {
    std::unique_lock lock(team.guard);
    const auto number = team.gatherings;
    team.given[me] = own;
    if (++team.givers == team.count) {
      team.gathered = team.given;
      team.givers = 0;
      ++team.gatherings;
      team.changed.notify_all();
    }
    team.changed.wait(lock, [&] { return team.gatherings != number; });
    return team.gathered;
  }

private:
  ThreadRanks& team;
  unsigned me;
  std::mt19937_64 generator;
  std::uint64_t rounds = 0; ///< that are over
  bool hasFinished = false; ///< the present round
};

ThreadRanks::ThreadRanks(unsigned ranks, std::uint64_t of)
    : count(ranks), seed(of), mailboxes(ranks), underWay(ranks), given(ranks) {}

void ThreadRanks::run(const std::function<void(verify::Ranks&)>& work) {
  std::vector<std::jthread> threads;
  for (unsigned i = 0; i < count; ++i)
    threads.emplace_back([&, i] {
      Rank rank(*this, i);
      work(rank);
    });
}

} // namespace proskill::test
