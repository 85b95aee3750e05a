#include "ide/snapshot/include_graph.h"
#include "tests/support/linked_files.h"

#include <catch2/catch.hpp>

using namespace proskill;
using ide::IncludeGraph;
using Paths = std::vector<std::filesystem::path>;

namespace {

/// Files in the folder `/w`, with the paths that each includes.
struct Text {
  std::string name;
  std::vector<std::string> includes;
};

ide::KnownFile known(const analysis::FileSystem& disk, const Text& text) {
  std::string source;
  for (const auto& path : text.includes) source += "(include \"" + path + "\")\n";
  const auto name = std::filesystem::path("/w") / text.name;
  return ide::knownFile(disk, name, disk.canonical(name).native(), syntax::Document::parse(source));
}

IncludeGraph graphOf(const std::vector<Text>& texts, test::LinkedFiles::Links links = {}) {
  const test::LinkedFiles disk({}, std::move(links));
  std::vector<IncludeGraph::File> files;
  for (const auto& text : texts)
    files.push_back(std::make_shared<const ide::KnownFile>(known(disk, text)));
  return IncludeGraph(std::move(files));
}

} // namespace

TEST_CASE("a root is what nothing includes, and one of those that include each other") {
  const auto graph = graphOf(
      {{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {}}, {"d", {"c"}}, {"x", {"y"}}, {"y", {"x"}}});
  CHECK(graph.roots() == Paths{"/w/a", "/w/d", "/w/x"});
  CHECK(graph.rootsOf("/w/c") == Paths{"/w/a", "/w/d"});
  CHECK(graph.rootsOf("/w/b") == Paths{"/w/a"});
  CHECK(graph.rootsOf("/w/a") == Paths{"/w/a"});
  CHECK(graph.rootsOf("/w/y") == Paths{"/w/y"});
}

TEST_CASE("a file that nobody knows belongs to those that include it") {
  const auto graph = graphOf({{"a", {"gone"}}, {"self", {"self"}}});
  CHECK(graph.named("/w/gone") == nullptr);
  CHECK(graph.rootsOf("/w/gone") == Paths{"/w/a"});
  CHECK(graph.rootsOf("/w/nobody") == Paths{"/w/nobody"});
  CHECK(graph.roots() == Paths{"/w/a", "/w/self"});
}

TEST_CASE("a link leads to the file, from wherever it is included") {
  const auto graph = graphOf({{"a", {"link"}}, {"b", {"far/b"}}, {"lib", {"more"}}, {"more", {}}},
                             {{"/w/link", "/w/lib"}, {"/w/far/b", "/w/more"}});
  CHECK(graph.roots() == Paths{"/w/a", "/w/b"});
  CHECK(graph.rootsOf("/w/lib") == Paths{"/w/a"});
  CHECK(graph.rootsOf("/w/more") == Paths{"/w/a", "/w/b"});
}

TEST_CASE("of two things that are said of a file the last counts") {
  const auto graph = graphOf({{"link", {"b"}}, {"lib", {"c"}}}, {{"/w/link", "/w/lib"}});
  REQUIRE(graph.files().size() == 1);
  CHECK(graph.files().front()->name == "/w/lib");
  CHECK(graph.rootsOf("/w/b") == Paths{"/w/b"});
}

TEST_CASE("a graph never changes: what is known now is a new one") {
  const test::MemoryFiles disk;
  const auto graph = graphOf({{"a", {"b"}}, {"b", {}}});
  const auto more = graph.with(known(disk, {"c", {"b"}}));
  const auto other = more->with(known(disk, {"a", {}}));
  const auto less = other->without("/w/c");
  CHECK(graph.rootsOf("/w/b") == Paths{"/w/a"});
  CHECK(more->rootsOf("/w/b") == Paths{"/w/a", "/w/c"});
  CHECK(other->rootsOf("/w/b") == Paths{"/w/c"});
  CHECK(less->rootsOf("/w/b") == Paths{"/w/b"});
  CHECK(less->files().size() == 2);
  CHECK(less->find("/w/c") == nullptr);
  CHECK(graph.differenceTo(graph).empty());
  CHECK(graph.differenceTo(*other) == std::vector<std::string_view>{"/w/a", "/w/c"});
  CHECK(other->differenceTo(graph) == std::vector<std::string_view>{"/w/a", "/w/c"});
  CHECK(other->differenceTo(*less) == std::vector<std::string_view>{"/w/c"});
}
