#include "mpi/mpi_ranks.h"

#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <list>
#include <memory>
#include <mpi.h>
#include <numeric>
#include <thread>
#include <utility>

namespace proskill::mpi {

namespace {

/// Waits without taking a processor from others for long: a search may leave a rank idle for hours.
class Patience {
public:
  void reset() { looks = 0; }
  void wait() {
    constexpr int kLooks = 1000;
    constexpr std::chrono::microseconds kPause{100};
    if (++looks < kLooks)
      std::this_thread::yield();
    else
      std::this_thread::sleep_for(kPause);
  }

private:
  int looks = 0;
};

bool isDone(MPI_Request& request) {
  int done = 0;
  MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  return done != 0;
}

void await(MPI_Request request) {
  for (Patience patience; !isDone(request);) patience.wait();
}

/// Errors of MPI end all ranks with a message of its own, which is its default.
class MpiRanks final : public verify::Ranks {
public:
  MpiRanks() {
    int provided = 0; // threads of a rank leave MPI to the first one
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    int number = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &number);
    me = static_cast<unsigned>(number);
    MPI_Comm_size(MPI_COMM_WORLD, &number);
    ranks = static_cast<unsigned>(number);
  }
  /// A rank that an exception ends, as want of memory may, ends the others: they wait for it.
  ~MpiRanks() override {
    if (std::uncaught_exceptions() > 0) {
      std::cerr << "error: rank " << me << " cannot go on, probably for want of memory\n";
      MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    }
    MPI_Finalize();
  }

  [[nodiscard]] unsigned self() const override { return me; }
  [[nodiscard]] unsigned count() const override { return ranks; }

  /// Synchronous, so that a message which is done has been received.
  void send(unsigned to, std::string bytes) override {
    patience.reset();
    auto& sent = underWay.emplace_back(std::move(bytes), MPI_REQUEST_NULL);
    MPI_Issend(sent.first.data(), static_cast<int>(sent.first.size()), MPI_BYTE,
               static_cast<int>(to), kTag, MPI_COMM_WORLD, &sent.second);
  }

  [[nodiscard]] bool isBusy() override {
    constexpr std::size_t kMostUnderWay = 64;
    if (underWay.size() < kMostUnderWay) return false;
    forgetReceived();
    if (underWay.size() < kMostUnderWay) return false;
    patience.wait();
    return true;
  }

  [[nodiscard]] std::optional<Message> receive() override {
    int isThere = 0;
    MPI_Message handle = MPI_MESSAGE_NULL;
    MPI_Status status;
    MPI_Improbe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &isThere, &handle, &status);
    if (isThere == 0) return std::nullopt;
    patience.reset();
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{static_cast<unsigned>(status.MPI_SOURCE),
                    std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Mrecv(message.bytes.data(), size, MPI_BYTE, &handle, MPI_STATUS_IGNORE);
    return message;
  }

  /// Once its own messages have been received, a rank enters a barrier that does not block; when
  /// all have entered it, no message is left.
  [[nodiscard]] bool isRoundOver() override {
    forgetReceived();
    if (underWay.empty() && !std::exchange(isInBarrier, true))
      MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
    if (isInBarrier && isDone(barrier)) {
      isInBarrier = false;
      patience.reset();
      return true;
    }
    patience.wait();
    return false;
  }

  void sum(std::span<std::uint64_t> numbers) override {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_UINT64_T,
                   MPI_SUM, MPI_COMM_WORLD, &request);
    await(request);
  }

  [[nodiscard]] std::vector<std::string> gather(const std::string& own) override {
    const int size = static_cast<int>(own.size());
    std::vector<int> sizes(ranks);
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, MPI_COMM_WORLD, &request);
    await(request);
    std::vector<int> places(ranks);
    std::exclusive_scan(sizes.begin(), sizes.end(), places.begin(), 0);
    std::string all(static_cast<std::size_t>(places.back() + sizes.back()), '\0');
    MPI_Iallgatherv(own.data(), size, MPI_BYTE, all.data(), sizes.data(), places.data(), MPI_BYTE,
                    MPI_COMM_WORLD, &request);
    await(request);
    std::vector<std::string> parts;
    for (unsigned i = 0; i < ranks; ++i)
      parts.push_back(
          all.substr(static_cast<std::size_t>(places[i]), static_cast<std::size_t>(sizes[i])));
    return parts;
  }

private:
  static constexpr int kTag = 1;

  void forgetReceived() {
    underWay.remove_if([](auto& sent) { return isDone(sent.second); });
  }

  unsigned me = 0;
  unsigned ranks = 1;
  std::list<std::pair<std::string, MPI_Request>> underWay;
  MPI_Request barrier = MPI_REQUEST_NULL;
  bool isInBarrier = false;
  Patience patience;
};

} // namespace

} // namespace proskill::mpi

proskill::verify::Ranks* proskillMpiRanks() {
  return std::make_unique<proskill::mpi::MpiRanks>().release();
}
