#include "tests/cli/imports.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

using namespace proskill::test;

/// Imports over a program that was edited since it was imported.
namespace import_edits {

using imports::command;
using imports::contains;
using imports::contentOf;
using imports::kLeaves;
using imports::kPatrol;

TEST_CASE("what is printed has no digests, since it may become a part of another file") {
  const std::vector<std::string> import{"import", "bt", kPatrol, "--leaves", kLeaves};
  const auto printed = command(import);
  CHECK(printed.exitCode == 0);
  CHECK(contains(printed.out, "(defskill"));
  CHECK_FALSE(contains(printed.out, "digests"));
  for (const std::string output : {"-", "/dev/stdout", "/dev/fd/1"}) {
    INFO(output);
    auto words = import;
    words.insert(words.end(), {"-o", output});
    const auto same = command(words);
    CHECK(same.exitCode == 0);
    CHECK(same.out == printed.out);
  }
}

TEST_CASE("an import does not remove what was added to its output") {
  const TemporaryDirectory directory;
  const auto path = directory.write("patrol.proskill", "");
  const std::vector<std::string> import{"import", "bt", kPatrol, "--leaves", kLeaves, "-o", path};
  REQUIRE(command(import).exitCode == 0);
  const auto text = contentOf(path);
  CHECK(command(import).exitCode == 0);
  const auto more =
      text + "(defproperty\n  mine_can_end (never (running Charge)))\n(defplatform \"x.json\")\n";
  directory.write("patrol.proskill", more);
  const auto refused = command(import);
  CHECK(refused.exitCode == 2);
  CHECK(contains(refused.err, ": error: `defproperty mine_can_end` was added here"));
  CHECK(contains(refused.err, ": error: `(defplatform \"x.json\")` was added here"));
  CHECK(contentOf(path) == more);
  directory.write("patrol.proskill", text + "(defskill broken\n");
  CHECK(contains(command(import).err, "`defskill broken` was added here"));
}

TEST_CASE("an import does not undo edits of its output, unless told so") {
  const TemporaryDirectory directory;
  const auto path = directory.path("patrol.proskill");
  std::vector<std::string> import{"import", "bt", kPatrol, "--leaves", kLeaves, "-o", path};
  REQUIRE(command(import).exitCode == 0);
  const auto text = contentOf(path);
  const auto importOver = [&](const std::string& existing) {
    directory.write("patrol.proskill", existing);
    const auto done = command(import);
    CHECK(contentOf(path) == (done.exitCode == 0 ? text : existing));
    return std::pair(done.exitCode, done.err);
  };
  const auto at = text.find("(defskill Charge");
  auto edited = text;
  edited.insert(text.find(":success", at), ":precondition (free true)\n  ");
  const auto line = std::count(text.begin(), text.begin() + static_cast<int>(at), '\n') + 1;
  const auto [code, said] = importOver(edited);
  CHECK(code == 2);
  CHECK(said ==
        path + ":" + std::to_string(line) +
            ":1: error: `defskill Charge` was edited here, which another import would undo. "
            "Move additions to a program that includes `patrol.proskill`, or undo all of it "
            "by `--force`\n");
  auto commented = text;
  commented.insert(at, "; slow\n");
  CHECK(contains(importOver(commented).second, "`defskill Charge` was edited here"));
  CHECK(contains(importOver(text + "; mine\n").second, "a comment was added here"));
  for (const std::string stray : {"later", ")", "\"open"}) {
    INFO(stray);
    const auto added = importOver(text + stray + "\n");
    CHECK(added.first == 2);
    CHECK(contains(added.second, ":1: error: text was added here"));
    const auto before = text.find("; digests");
    CHECK(importOver(text.substr(0, before) + stray + "\n" + text.substr(before)).first == 2);
  }
  auto shorter = text;
  shorter.erase(at, text.find("\n; from", at) - at);
  CHECK(contains(importOver(shorter).second, ":1:1: error: 1 of its definitions were removed"));
  const auto last = shorter.rfind("\n(def");
  const auto copied = shorter.substr(last, shorter.find("\n\n", last) - last);
  shorter.insert(shorter.find("; digests"), copied + copied + "\n");
  CHECK(contains(importOver(shorter).second, "definitions were removed"));
  auto spaced = text;
  spaced.insert(at, "\n\n");
  CHECK(importOver(spaced).first == 0);
  CHECK(importOver("(defskill by_hand)\n").first == 2);
  import.insert(import.end(), {"--force"});
  CHECK(importOver(edited).first == 0);
}

TEST_CASE("an import replaces no file without digests, unless told so") {
  const TemporaryDirectory directory;
  const auto path = directory.path("patrol.proskill");
  std::vector<std::string> import{"import", "bt", kPatrol, "--leaves", kLeaves, "-o", path};
  REQUIRE(command(import).exitCode == 0);
  const auto text = contentOf(path);
  const auto older = text.substr(0, text.find("; digests"));
  const auto at = older.find("(defskill Charge");
  for (const std::string& existing :
       {std::string("remember the milk\n"), std::string("<root/>\n"), std::string("; mine\n"),
        older.substr(0, at) + "; slow\n" + older.substr(at)}) {
    INFO(existing);
    directory.write("patrol.proskill", existing);
    const auto refused = command(import);
    CHECK(refused.exitCode == 2);
    CHECK(refused.err == path + ":1:1: error: the file has no digests of an import, so it is "
                                "unknown whether it was edited. Replace it by `--force`\n");
    CHECK(contentOf(path) == existing);
  }
  for (const auto& existing : {older, std::string("\n \n")}) {
    directory.write("patrol.proskill", existing);
    CHECK(command(import).exitCode == 0);
    CHECK(contentOf(path) == text);
  }
  directory.write("patrol.proskill", "remember the milk\n");
  import.emplace_back("--force");
  CHECK(command(import).exitCode == 0);
  CHECK(contentOf(path) == text);
}

TEST_CASE("an import replaces its output when the original has changed") {
  const TemporaryDirectory directory;
  const auto tree = [](const std::string& leaf) {
    return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">" + leaf +
           "</BehaviorTree></root>\n";
  };
  const auto xml = directory.write("main.xml", tree("<Sequence><A/><B/></Sequence>"));
  const auto path = directory.path("main.proskill");
  REQUIRE(command({"import", "bt", xml, "-o", path}).exitCode == 0);
  directory.write("main.xml", tree("\n<Fallback><C/><A x=\"1\"/></Fallback>"));
  CHECK(command({"import", "bt", xml, "-o", path}).exitCode == 0);
  CHECK(contains(contentOf(path), "(defskill C"));
}

} // namespace import_edits
