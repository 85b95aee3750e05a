#include "lsp/uri.h"

#include <catch2/catch.hpp>

using namespace proskill::lsp;

TEST_CASE("a path goes to a URI and back") {
  for (auto path : {"/a/b.proskill", "/with space/é.proskill", "/100%/#x?.proskill", "/a:b"})
    CHECK(toPath(toUri(path)) == std::filesystem::path(path));
}

TEST_CASE("a URI is decoded however a client writes it") {
  CHECK(toPath("file:///a%20b/c%3Ad") == std::filesystem::path("/a b/c:d"));
  CHECK(toPath("file://localhost/a") == std::filesystem::path("/a"));
  CHECK(toPath("file:///a/../b") == std::filesystem::path("/b"));
  CHECK(toPath("file:///50%") == std::filesystem::path("/50%"));
  CHECK(normalised("file:///c%3A/x") == normalised("file:///c:/x"));
}

TEST_CASE("other schemes have no path and keep their spelling") {
  CHECK(!toPath("untitled:Untitled-1"));
  CHECK(normalised("untitled:Untitled-1") == "untitled:Untitled-1");
}
