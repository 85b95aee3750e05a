#include "record/recorder.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>

#include <condition_variable>
#include <fstream>
#include <mutex>
#include <sstream>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <thread>
#include <unistd.h>

using namespace proskill;
using record::Recorder;
using record::RunTime;

namespace {

/// A disk that hangs while a test wants it to.
struct Disk {
  std::mutex mutex;
  std::condition_variable changed;
  bool hangs = false;
  int waiting = 0; ///< writes that hang
  int writes = 0;
  int syncs = 0;

  void write() {
    std::unique_lock lock(mutex);
    ++writes;
    ++waiting;
    changed.notify_all();
    changed.wait(lock, [&] { return !hangs; });
    --waiting;
  }
  void sync() {
    const std::lock_guard lock(mutex);
    ++syncs;
    changed.notify_all();
  }
  void hang(bool from) {
    const std::lock_guard lock(mutex);
    hangs = from;
    changed.notify_all();
  }
  template <class Condition> void await(Condition&& holds) {
    std::unique_lock lock(mutex);
    changed.wait(lock, holds);
  }
} slow;

} // namespace

// Replace the functions of the C library.
extern "C" ssize_t pwritev(int file, const iovec* parts, int count, off_t at) {
  slow.write();
  return ::syscall(SYS_pwritev, file, parts, count, at, 0);
}
extern "C" int fdatasync(int file) {
  slow.sync();
  return static_cast<int>(::syscall(SYS_fdatasync, file));
}

namespace {

std::string recording(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("no step waits for a disk that hangs, and the recording ends with a warning") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  Recorder recorder(std::move(*disk::GrowingFile::create(path)), RunTime::Real);
  CHECK(recorder.add("[0", "]") == std::nullopt);
  slow.hang(true);
  CHECK(recorder.add(",1", "]") == std::nullopt);
  slow.await([] { return slow.waiting == 1; });
  // The disk hangs now: what is added waits in memory.
  const std::string step(std::size_t{1} << 20, ' ');
  std::optional<std::string> warning;
  int added = 0;
  for (; !warning && added < 100; ++added) warning = recorder.add(step, "]");
  CHECK(warning == "the disk does not keep up with the run");
  CHECK(added > 30);
  CHECK(recorder.add(",2", "]") == std::nullopt); // reported once
  slow.hang(false);
  CHECK(recorder.finish() == std::nullopt);
  CHECK(recording(path).starts_with("[0,1"));
  CHECK(recording(path).ends_with("]"));
}

TEST_CASE("in real time a step after a pause is written at once, and those after it together") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  Recorder recorder(std::move(*disk::GrowingFile::create(path)), RunTime::Real);
  CHECK(recorder.add("[0", "]") == std::nullopt);
  const int before = slow.writes;
  CHECK(recorder.add(",1", "]") == std::nullopt);
  slow.await([&] { return slow.writes > before; }); // without another step
  constexpr int kSteps = 20'000;
  for (int i = 0; i < kSteps; ++i) CHECK(recorder.add(",2", "]") == std::nullopt);
  CHECK(recorder.finish() == std::nullopt);
  CHECK(slow.writes < before + kSteps / 10);
  CHECK(recording(path).size() == std::string("[0,1]").size() + kSteps * 2);
}

TEST_CASE("a file is lost that had a name and has none any more") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  Recorder recorder(std::move(*disk::GrowingFile::create(path)), RunTime::Real);
  CHECK_FALSE(recorder.add("[", "]"));
  CHECK_FALSE(recorder.lost());
  unlink(path.c_str());
  CHECK_FALSE(recorder.finish());
  CHECK(recorder.lost() == path + " was removed or replaced during the run");
  const int memory = memfd_create("recording", MFD_CLOEXEC);
  Recorder unnamed(std::move(*disk::GrowingFile::create("/proc/self/fd/" + std::to_string(memory))),
                   RunTime::Real);
  CHECK_FALSE(unnamed.add("[", "]"));
  CHECK_FALSE(unnamed.finish());
  CHECK_FALSE(unnamed.lost());
  close(memory);
}

TEST_CASE("a part of a recording is replaced after it was written, and before what follows") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.mcap");
  {
    Recorder recorder(std::move(*disk::GrowingFile::create(path)), RunTime::Real);
    for (int i = 0; i < 100; ++i) {
      CHECK(recorder.add("____", "]") == std::nullopt);
      CHECK(recorder.replace(std::uint64_t(4 * i), "<") == std::nullopt);
    }
    CHECK(recorder.add("all", "]") == std::nullopt);
    CHECK(recorder.finish() == std::nullopt);
  }
  std::string expected;
  for (int i = 0; i < 100; ++i) expected += "<___";
  CHECK(recording(path) == expected + "all]");
}

TEST_CASE("a run in simulated time waits for a slow disk, and nothing is lost") {
  const test::TemporaryDirectory files;
  const auto path = files.path("run.json");
  {
    Recorder recorder(std::move(*disk::GrowingFile::create(path)), RunTime::Simulated);
    const std::string step(std::size_t{1} << 20, ' ');
    CHECK(recorder.add("[", "]") == std::nullopt);
    slow.hang(true);
    std::thread run([&] {
      for (int i = 0; i < 80; ++i) CHECK(recorder.add(step, "]") == std::nullopt);
    });
    slow.await([] { return slow.waiting == 1; });
    slow.hang(false);
    run.join();
  }
  CHECK(recording(path).size() == 2 + (std::size_t{80} << 20));
}

TEST_CASE("a recording is handed to the disk within a second, without another step") {
  const test::TemporaryDirectory files;
  Recorder recorder(std::move(*disk::GrowingFile::create(files.path("run.json"))), RunTime::Real);
  CHECK(recorder.add("[", "]") == std::nullopt);
  const int before = slow.syncs;
  CHECK(recorder.add("1", "]") == std::nullopt);
  slow.await([before] { return slow.syncs > before; });
}
