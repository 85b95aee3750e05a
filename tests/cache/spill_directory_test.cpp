#include "cache/spill_directory.h"

#include <catch2/catch.hpp>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace proskill::test::spill_directory_test {

namespace {

namespace fs = std::filesystem;
using cache::SpillDirectory;

/// A directory that is removed at the end.
struct Place {
  fs::path directory = fs::temp_directory_path() / ("proskill-spill-" + std::to_string(::getpid()));

  Place() { fs::create_directories(directory); }
  ~Place() { fs::remove_all(directory); }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  [[nodiscard]] std::unique_ptr<verify::SpillFile> file() const {
    return SpillDirectory::open(directory.string()).value()->create().value();
  }
};

std::string contentOf(verify::SpillFile& file, std::uint64_t at, std::size_t bytes) {
  std::string content(bytes, '?');
  REQUIRE(file.read(at, content));
  return content;
}

} // namespace

TEST_CASE("a file of a search is read as it was written, and has no name") {
  const Place place;
  const auto file = place.file();
  const auto other = place.file();
  REQUIRE(file->append("one"));
  REQUIRE(other->append("other"));
  REQUIRE(file->append("two"));
  CHECK(contentOf(*file, 0, 6) == "onetwo");
  CHECK(contentOf(*file, 2, 2) == "et");
  CHECK(contentOf(*other, 0, 5) == "other");
  CHECK(fs::is_empty(place.directory));
  REQUIRE(file->clear());
  REQUIRE(file->append("new"));
  CHECK(contentOf(*file, 0, 3) == "new");
}

TEST_CASE("reading what a file of a search does not have any more is an error") {
  const Place place;
  const auto file = place.file();
  REQUIRE(file->append("short"));
  std::string content(6, ' ');
  const auto done = file->read(0, content);
  REQUIRE_FALSE(done);
  CHECK(done.error() == "cannot read the files of the search in `" + place.directory.string() +
                            "`: another program has shortened a file");
}

TEST_CASE("a directory that cannot be used for searches is an error at the start") {
  const Place place;
  const auto missing = SpillDirectory::open((place.directory / "missing").string());
  REQUIRE_FALSE(missing);
  CHECK_THAT(missing.error(), Catch::Matchers::EndsWith("`: No such file or directory"));
  const auto file = place.directory / "file";
  std::ofstream(file) << "content";
  const auto noDirectory = SpillDirectory::open(file.string());
  REQUIRE_FALSE(noDirectory);
  CHECK_THAT(noDirectory.error(), Catch::Matchers::EndsWith("`: Not a directory"));
}

TEST_CASE("a directory that is removed during a search is an error") {
  const Place place;
  const auto store = SpillDirectory::open(place.directory.string());
  REQUIRE(store);
  const auto file = (*store)->create();
  REQUIRE(file);
  fs::remove(place.directory);
  CHECK_FALSE((*store)->create());
  CHECK((*file)->append("still there"));
}

TEST_CASE("a disk without room for the files of a search is an error") {
  const Place place;
  const auto file = place.file();
  struct rlimit before {};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto earlier = std::signal(SIGXFSZ, SIG_IGN);
  const struct rlimit little { 1000, before.rlim_max };
  REQUIRE(setrlimit(RLIMIT_FSIZE, &little) == 0);
  const auto done = file->append(std::string(1500, 'x'));
  REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
  std::signal(SIGXFSZ, earlier);
  REQUIRE_FALSE(done);
  CHECK_THAT(done.error(), Catch::Matchers::EndsWith("`: File too large"));
}

} // namespace proskill::test::spill_directory_test
