#include "tests/support/run.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <sys/stat.h>
#include <unistd.h>

namespace proskill::test::output_test {

using proskill::test::Finished;
using proskill::test::run;
using proskill::test::TemporaryDirectory;
namespace fs = std::filesystem;

namespace {

const std::string kDock = PROSKILL_SOURCE_DIR "/docs/tour/dock.proskill";
const std::string kOld = "what was there before\n";

std::string contentOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::size_t filesIn(const std::string& directory) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

Finished runWords(const std::string& words, const std::string& before = "") {
  return run({"/bin/sh", "-c", before + " " PROSKILL_PROGRAM " " + words});
}

/// As on a disk with some hundred bytes of free space.
Finished onFullDisk(const std::string& words) {
  return runWords(words, "ulimit -f 1; trap '' XFSZ; exec");
}

/// Runs a program with a recording, as on a disk without free space. \return its errors
std::string recordOnFullDisk(const std::string& path, const std::string& before = "") {
  return runWords("run --record " + path + " " + kDock + " 2>&1 >/dev/null | cat",
                  "ulimit -f 0; trap '' XFSZ; " + before)
      .out;
}

/// Shell prefix that makes permissions effective for root, too.
std::string withoutPrivileges() {
  return geteuid() == 0 ? "exec setpriv --bounding-set -dac_override --inh-caps -dac_override"
                        : "exec";
}

std::uintmax_t namesOf(const std::string& path) { return fs::hard_link_count(path); }

/// A directory in which no file can be created while this lives.
class ReadOnlyDirectory {
public:
  explicit ReadOnlyDirectory(std::string directory) : path(std::move(directory)) {
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_exec);
  }
  ~ReadOnlyDirectory() { fs::permissions(path, fs::perms::owner_all); }
  ReadOnlyDirectory(const ReadOnlyDirectory&) = delete;
  ReadOnlyDirectory& operator=(const ReadOnlyDirectory&) = delete;

private:
  std::string path;
};

/// A badly formatted program, larger than the free space.
std::string untidy() {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "(defevent   event_number_" + std::to_string(i) + ")\n";
  return text;
}

} // namespace

TEST_CASE("a full disk leaves every earlier output as it was, and nothing beside it") {
  const TemporaryDirectory files;
  const auto old = files.path("old");
  const std::vector<std::pair<std::string, std::string>> commands{
      {"emit fiacre -o " + old + "/model.fcr " + kDock, "model.fcr"},
      {"graph --kind calls -o " + old + "/calls.svg " + kDock, "calls.svg"},
      {"graph --kind calls --out-dir " + old + " " + kDock, "calls.svg"},
      {"verify --report " + old + " " + kDock, "index.html"},
      {"verify --save-traces " + old + " " + kDock, "recharge_min_time.json"},
      {"verify --graph " + old + "/graph.aut " + kDock, "graph.aut"}};
  for (const auto& [command, name] : commands) {
    INFO(command);
    fs::create_directory(old);
    const auto path = files.write("old/" + name, kOld);
    const auto done = onFullDisk(command);
    CHECK(done.exitCode == 2);
    CHECK(done.err.find(" cannot be written: ") != std::string::npos);
    CHECK(contentOf(path) == kOld);
    CHECK(filesIn(old) == 1);
    fs::remove_all(old);
  }
}

TEST_CASE("a full disk leaves an earlier recording as it was, and the run says so") {
  const TemporaryDirectory files;
  for (const std::string name : {"run.json", "run.mcap"}) {
    INFO(name);
    const auto path = files.write(name, kOld);
    CHECK(recordOnFullDisk(path) ==
          "warning: " + path + " cannot be written: File too large; the recording ends here\n");
    CHECK(contentOf(path) == kOld);
    fs::remove(path);
    CHECK(filesIn(files.path()) == 0);
  }
}

TEST_CASE("a recording that replaces another is complete, and shorter if it has less") {
  const TemporaryDirectory files;
  const auto fresh = files.path("fresh.json");
  CHECK(runWords("run --seed 1 --record " + fresh + " " + kDock).exitCode == 0);
  const auto longer = files.write("run.json", std::string(1'000'000, 'x'));
  fs::create_symlink("run.json", files.path("link.json"));
  CHECK(runWords("run --seed 1 --record " + files.path("link.json") + " " + kDock).exitCode == 0);
  CHECK(contentOf(longer) == contentOf(fresh));
  CHECK(fs::is_symlink(files.path("link.json")));
}

TEST_CASE("a recording with several names, or in a locked directory, is overwritten in place") {
  const TemporaryDirectory files;
  fs::create_directory(files.path("locked"));
  const auto path = files.write("locked/run.json", kOld);
  fs::create_hard_link(path, files.path("other.json"));
  const auto record = "run --record " + path + " " + kDock;
  CHECK(recordOnFullDisk(path).find("the recording ends here") != std::string::npos);
  CHECK(contentOf(path) == kOld);
  CHECK(runWords(record).exitCode == 0);
  CHECK(namesOf(path) == 2);
  CHECK(contentOf(files.path("other.json")).ends_with("]}\n"));
  fs::remove(files.path("other.json"));
  files.write("locked/run.json", kOld);
  const ReadOnlyDirectory locked(files.path("locked"));
  CHECK(recordOnFullDisk(path, withoutPrivileges()).find("File too large") != std::string::npos);
  CHECK(contentOf(path) == kOld);
  CHECK(runWords(record, withoutPrivileges()).exitCode == 0);
  CHECK(contentOf(path).ends_with("]}\n"));
}

TEST_CASE("a full disk leaves a program that was to be laid out or fixed as it was") {
  const TemporaryDirectory files;
  const auto path = files.write("main.proskill", untidy());
  CHECK(onFullDisk("fmt " + path).exitCode == 2);
  CHECK(contentOf(path) == untidy());
  const auto open = untidy() + "(defevent last\n"; // `--fix` writes the parenthesis
  files.write("main.proskill", open);
  CHECK(onFullDisk("check --fix " + path).exitCode == 2);
  CHECK(contentOf(path) == open);
  CHECK(filesIn(files.path()) == 1);
}

TEST_CASE("an output keeps the permissions of the file that it replaces, and follows links") {
  const TemporaryDirectory files;
  const auto file = files.write("model.fcr", kOld);
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("model.fcr", files.path("link"));
  fs::create_symlink("below/fresh.fcr", files.path("to_nothing_yet"));
  fs::create_directory(files.path("below"));
  CHECK(runWords("emit fiacre -o " + files.path("link") + " " + kDock).exitCode == 0);
  CHECK(fs::is_symlink(files.path("link")));
  CHECK(contentOf(file).find("process ") != std::string::npos);
  CHECK(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(runWords("emit fiacre -o " + files.path("to_nothing_yet") + " " + kDock).exitCode == 0);
  CHECK(fs::is_symlink(files.path("to_nothing_yet")));
  CHECK(contentOf(files.path("below/fresh.fcr")) == contentOf(file));
}

TEST_CASE("a new output has the permissions that the user's mask leaves") {
  const TemporaryDirectory files;
  const auto file = files.path("model.fcr");
  CHECK(runWords("emit fiacre -o " + file + " " + kDock, "umask 027;").exitCode == 0);
  struct stat found {};
  REQUIRE(stat(file.c_str(), &found) == 0);
  CHECK((found.st_mode & 0777) == 0640);
}

TEST_CASE("pipes, devices and the standard streams are outputs that nothing replaces") {
  const TemporaryDirectory files;
  const auto model = runWords("emit fiacre " + kDock).out;
  CHECK(runWords("emit fiacre -o /dev/stdout " + kDock).out == model);
  CHECK(runWords("emit fiacre -o - " + kDock).out == model);
  CHECK(runWords("emit fiacre -o /dev/stderr " + kDock).err == model);
  CHECK(runWords("emit fiacre -o /dev/fd/5 " + kDock + " 5>&1 >/dev/null").out == model);
  const auto fifo = files.path("pipe");
  REQUIRE(mkfifo(fifo.c_str(), 0600) == 0);
  const auto piped = run(
      {"/bin/sh", "-c",
       "cat " + fifo + " & " PROSKILL_PROGRAM " emit fiacre -o " + fifo + " " + kDock + "; wait"});
  CHECK(piped.out == model);
  CHECK(fs::is_fifo(fifo));
  CHECK(runWords("emit fiacre -o /dev/null " + kDock).exitCode == 0);
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("what a shell writes into the file that is /dev/stdout stays before and behind it") {
  const TemporaryDirectory files;
  const auto all = files.path("all");
  const auto done = run({"/bin/sh", "-c",
                         "{ echo before; " PROSKILL_PROGRAM " emit fiacre -o /dev/stdout " + kDock +
                             "; echo behind; } >" + all});
  CHECK(done.exitCode == 0);
  CHECK(contentOf(all) == "before\n" + runWords("emit fiacre " + kDock).out + "behind\n");
}

TEST_CASE("a file that may not be written is not replaced either") {
  const TemporaryDirectory files;
  const auto file = files.write("model.fcr", kOld);
  fs::permissions(file, fs::perms::owner_read);
  const auto done = runWords("emit fiacre -o " + file + " " + kDock, withoutPrivileges());
  CHECK(done.exitCode == 2);
  CHECK(contentOf(file) == kOld);
}

TEST_CASE("a file is written in place where nothing can be created beside it") {
  const TemporaryDirectory files;
  const auto model = runWords("emit fiacre " + kDock).out;
  for (const auto& old : {kOld, std::string(2 * model.size(), 'x')}) {
    fs::create_directory(files.path("locked"));
    const auto file = files.write("locked/model.fcr", old);
    {
      const ReadOnlyDirectory locked(files.path("locked"));
      const auto emit = "emit fiacre -o " + file + " " + kDock;
      const auto full = runWords(emit, "ulimit -f 1; trap '' XFSZ; " + withoutPrivileges());
      CHECK(full.exitCode == 2);
      CHECK(full.err.find(" cannot be written: ") != std::string::npos);
      CHECK(contentOf(file) == old);
      CHECK(runWords(emit, withoutPrivileges()).exitCode == 0);
      CHECK(contentOf(file) == model);
      const auto other = "emit fiacre -o " + files.path("locked/new.fcr") + " " + kDock;
      CHECK(runWords(other, withoutPrivileges()).exitCode == 2);
      CHECK(filesIn(files.path("locked")) == 1);
    }
    fs::remove_all(files.path("locked"));
  }
}

TEST_CASE("a file of several names keeps them, and its content on a full disk") {
  const TemporaryDirectory files;
  const auto file = files.write("main.proskill", untidy());
  const auto other = files.path("other.proskill");
  fs::create_hard_link(file, other);
  CHECK(onFullDisk("fmt " + file).exitCode == 2);
  CHECK(contentOf(other) == untidy());
  CHECK(runWords("fmt " + file).exitCode == 0);
  CHECK(contentOf(other) == contentOf(file));
  CHECK(contentOf(other).find("(defevent event_number_0)") != std::string::npos);
  CHECK(namesOf(file) == 2);
  CHECK(filesIn(files.path()) == 2);
}

TEST_CASE("an output that is a link to itself is refused, and stays") {
  const TemporaryDirectory files;
  const auto link = files.path("round.fcr");
  fs::create_symlink("round.fcr", link);
  const auto done = runWords("emit fiacre -o " + link + " " + kDock);
  CHECK(done.exitCode == 2);
  CHECK(done.err.find(link + " cannot be written: ") != std::string::npos);
  CHECK(fs::is_symlink(link));
  CHECK(filesIn(files.path()) == 1);
}

} // namespace proskill::test::output_test
