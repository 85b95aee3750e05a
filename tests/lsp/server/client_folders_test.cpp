#include "disk/disk.h"
#include "lsp/server/client_folders.h"
#include "tests/lsp/server/support.h"
#include "tests/support/run.h"

#include <catch2/catch.hpp>

using namespace proskill;

namespace {

using Paths = std::vector<std::filesystem::path>;

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

  /// Opens a folder, and waits until it is read.
  void open(const std::filesystem::path& folder) {
    folders.set({folder});
    folders.readAll();
    finishReading();
  }
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
  editor.open(one.path());
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

TEST_CASE("a folder that comes or goes stands for its program files") {
  const test::TemporaryDirectory folder;
  OpenFolders editor;
  editor.folders.set({folder.path()});
  const auto lamp = folder.write("arm/left/lamp.proskill", kLampFile);
  folder.write("arm/build/lamp.proskill", kLampFile);
  folder.write("arm/notes.txt", "");
  const auto arm = folder.path("arm");
  CHECK(editor.folders.filesOf({arm}) == Paths{lamp});
  CHECK(editor.folders.filesOf({folder.path("arm/build")}).empty());
  CHECK(editor.folders.filesOf({folder.path("arm/notes.txt")}).empty());
  editor.folders.filesChanged(editor.folders.filesOf({arm}));
  CHECK(editor.workspace.snapshot()->knows(lamp));
  std::filesystem::remove_all(arm);
  editor.folders.filesChanged(editor.folders.filesOf({arm}));
  CHECK(editor.files() == 0);
}

TEST_CASE("a folder that is not open in the editor is not read") {
  const test::TemporaryDirectory open;
  const test::TemporaryDirectory other;
  other.write("arm/lamp.proskill", kLampFile);
  OpenFolders editor;
  editor.folders.set({open.path()});
  CHECK(editor.folders.filesOf({other.path("arm")}).empty());
}

TEST_CASE("a file whose name begins like that of a folder stays when the folder goes") {
  const test::TemporaryDirectory folder;
  folder.write("arm.proskill", kLampFile);
  const auto part = folder.write("arm/part.proskill", kLampFile);
  OpenFolders editor;
  editor.open(folder.path());
  std::filesystem::remove_all(folder.path("arm"));
  CHECK(editor.folders.filesOf({folder.path("arm")}) == Paths{part});
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
