#include "disk/disk.h"
#include "lsp/server/client_folders.h"
#include "tests/lsp/server/support.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

constexpr const char* kLampFile = "(defsv lamp :states (On Off) :init Off)\n";

/// The folders of an editor. A reading ends when the test says so.
struct OpenFolders {
  test::Client client;
  lsp::Workspace workspace{std::make_shared<disk::DiskFileSystem>()};
  lsp::ClientFeatures features;
  rpc::Inbox inbox;
  int read = 0;
  rpc::Scheduler scheduler{2};
  lsp::ClientFolders folders{
      {workspace, client.peer, features, inbox, scheduler, [this] { ++read; }}};

  /// Waits for the files that were read in the background, and takes them over.
  void finishReading() {
    auto event = inbox.take(std::nullopt);
    REQUIRE(event);
    std::get<rpc::Task> (*event)();
  }
  [[nodiscard]] std::size_t files() const { return workspace.snapshot()->knownFiles().size(); }
};

} // namespace

TEST_CASE("the folders of an editor are read in the background") {
  const test::TemporaryDirectory folder;
  const auto lamp = folder.write("lamp.proskill", kLampFile);
  OpenFolders editor;
  editor.folders.set({folder.path()});
  CHECK(editor.files() == 0);
  editor.folders.readAll();
  CHECK(editor.files() == 0);
  editor.finishReading();
  CHECK(editor.read == 1);
  CHECK(editor.workspace.snapshot()->knows(lamp));
}

TEST_CASE("a folder that is added is read, and one that is removed is forgotten with its files") {
  const test::TemporaryDirectory one;
  const test::TemporaryDirectory other;
  one.write("lamp.proskill", kLampFile);
  const auto lamp = other.write("lamp.proskill", kLampFile);
  OpenFolders editor;
  editor.folders.set({one.path()});
  editor.folders.readAll();
  editor.finishReading();
  editor.folders.change({one.path()}, {other.path()});
  CHECK(editor.files() == 0);
  editor.finishReading();
  CHECK(editor.files() == 1);
  CHECK(editor.workspace.snapshot()->knows(lamp));
}

TEST_CASE("what changes while folders are read is newer than what was read") {
  const test::TemporaryDirectory folder;
  const auto lamp = folder.write("lamp.proskill", kLampFile);
  OpenFolders editor;
  editor.folders.set({folder.path()});
  editor.folders.readAll();
  test::settle(editor.scheduler);
  SECTION("a file") {
    folder.write("lamp.proskill", "(include \"door.proskill\")\n");
    editor.folders.filesChanged({lamp});
    editor.finishReading();
    CHECK(editor.workspace.snapshot()->knownFiles().at(0)->includes.size() == 1);
  }
  SECTION("a file that is gone") {
    std::filesystem::remove(lamp);
    editor.folders.filesChanged({lamp});
    editor.finishReading();
    CHECK(editor.files() == 0);
  }
  SECTION("a folder that the editor has closed") {
    editor.folders.change({folder.path()}, {});
    editor.finishReading();
    CHECK(editor.files() == 0);
  }
}

TEST_CASE("an editor that shows progress is asked for a place to show it") {
  const test::TemporaryDirectory folder;
  folder.write("lamp.proskill", kLampFile);
  OpenFolders editor;
  SECTION("it shows none") {}
  SECTION("it shows it") { editor.features.workDoneProgress = true; }
  editor.folders.change({}, {folder.path()});
  editor.finishReading();
  REQUIRE(editor.client.pipe.hasMore() == editor.features.workDoneProgress);
  if (editor.features.workDoneProgress)
    CHECK(editor.client.pipe.receive()["method"] == "window/workDoneProgress/create");
}
