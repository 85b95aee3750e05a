#include "cache/checkpoint_file.h"
#include "disk/disk.h"
#include "disk/output.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>

#include <csignal>
#include <sys/resource.h>

namespace proskill::test::checkpoint_file_test {

namespace {

namespace fs = std::filesystem;

const cache::CheckpointKey kKey{.build = std::string(32, 'b'),
                                .model = std::string(32, 'm'),
                                .questions = std::string(32, 'q'),
                                .settings = std::string(32, 's')};

/// A directory of its own, with a checkpoint in it.
struct Place {
  Place() {
    fs::remove_all(directory);
    fs::create_directories(directory);
  }
  ~Place() { fs::remove_all(directory); }

  fs::path directory =
      fs::temp_directory_path() / ("proskill-checkpoint-" + std::to_string(getpid()));
  fs::path file = directory / "state";
  std::vector<std::string> said;

  auto open(const cache::CheckpointKey& key = kKey) {
    return cache::CheckpointFile::open(file, 60, key,
                                       [this](const std::string& line) { said.push_back(line); });
  }
  std::unique_ptr<cache::CheckpointFile> opened() {
    auto made = open();
    INFO((made ? "" : made.error()));
    REQUIRE(made);
    return std::move(*made);
  }
};

void save(cache::CheckpointFile& file, const std::vector<std::string>& pieces) {
  file.replace([&](const verify::CheckpointStore::Put& put) {
    for (const auto& piece : pieces)
      if (!put(piece)) return;
  });
}

/// All pieces of a state; nothing if an error is reported.
std::optional<std::vector<std::string>> readAll(cache::CheckpointFile& file) {
  std::vector<std::string> pieces;
  for (;;) {
    auto piece = file.next();
    if (!piece) return std::nullopt;
    if (piece->empty()) return pieces;
    pieces.push_back(std::move(*piece));
  }
}

} // namespace

TEST_CASE("a checkpoint is read as it was written") {
  Place place;
  const std::vector<std::string> pieces{"one", std::string(70'000, 'x'), "three"};
  const auto first = place.opened();
  CHECK_FALSE(first->hasState());
  save(*first, {"old"});
  save(*first, pieces);
  CHECK(first->savedAt());
  const auto second = place.opened();
  REQUIRE(second->hasState());
  CHECK(readAll(*second) == pieces);
  second->removeIfFinished();
  CHECK(fs::exists(place.file));
  second->finished();
  second->removeIfFinished();
  CHECK(fs::is_empty(place.directory));
}

TEST_CASE("every damage of a checkpoint is reported, and the file is left as it is") {
  Place place;
  save(*place.opened(), {"some", "bytes of a state", "more"});
  const auto whole = disk::DiskFileSystem().read(place.file).value();
  const auto isUsed = [&](const std::string& bytes) {
    REQUIRE_FALSE(disk::writeFile(place.file, bytes));
    const auto file = place.open();
    const bool isRead = file && readAll(**file);
    CHECK(disk::DiskFileSystem().read(place.file) == bytes);
    return isRead;
  };
  REQUIRE(isUsed(whole));
  CHECK_FALSE(isUsed(whole + "x"));
  CHECK_FALSE(isUsed(whole + whole));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    INFO(i);
    CHECK_FALSE(isUsed(whole.substr(0, i)));
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = whole;
      damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
      CHECK_FALSE(isUsed(damaged));
    }
  }
}

TEST_CASE("a checkpoint of something else is refused with its reason") {
  Place place;
  save(*place.opened(), {"state"});
  const auto refusal = [&](std::string cache::CheckpointKey::*part) {
    auto key = kKey;
    (key.*part)[0] = 'x';
    const auto file = place.open(key);
    return file ? "" : file.error();
  };
  using Catch::Matchers::Contains;
  CHECK_THAT(refusal(&cache::CheckpointKey::build), Contains("another build of proskill"));
  CHECK_THAT(refusal(&cache::CheckpointKey::model), Contains("another program"));
  CHECK_THAT(refusal(&cache::CheckpointKey::questions), Contains("other properties"));
  CHECK_THAT(refusal(&cache::CheckpointKey::settings), Contains("other reductions"));
  CHECK(place.opened()->hasState());
}

TEST_CASE("a place where nothing can be written is an error at the start") {
  Place place;
  place.file = place.directory / "missing" / "state";
  CHECK_FALSE(place.open());
  place.file = place.directory;
  CHECK_FALSE(place.open());
  place.file = "/dev/full";
  CHECK_FALSE(place.open());
}

TEST_CASE("if the disk is full, the earlier checkpoint stays and one warning is given") {
  Place place;
  const auto file = place.opened();
  save(*file, {"small"});
  struct rlimit before {};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto earlier = std::signal(SIGXFSZ, SIG_IGN);
  const struct rlimit little { 100'000, before.rlim_max };
  REQUIRE(setrlimit(RLIMIT_FSIZE, &little) == 0);
  save(*file, {std::string(90'000, 'x'), std::string(90'000, 'y')});
  save(*file, {std::string(90'000, 'x'), std::string(90'000, 'y')});
  REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
  std::signal(SIGXFSZ, earlier);
  REQUIRE(place.said.size() == 1);
  CHECK_THAT(place.said[0], Catch::Matchers::StartsWith("warning: "));
  CHECK(std::distance(fs::directory_iterator(place.directory), {}) == 1);
  CHECK(readAll(*place.opened()) == std::vector<std::string>{"small"});
}

TEST_CASE("a link to a checkpoint stays a link") {
  Place place;
  const auto target = place.directory / "target";
  fs::create_symlink(target, place.file);
  save(*place.opened(), {"state"});
  CHECK(fs::is_symlink(place.file));
  CHECK(fs::is_regular_file(target));
}

} // namespace proskill::test::checkpoint_file_test
