#include "lsp/protocol/convert.h"
#include "report/uri.h"

#include <catch2/catch.hpp>

using namespace proskill;
using lsp::pathOf;

TEST_CASE("a path goes to a URI and back") {
  for (auto path : {"/a/b.proskill", "/with space/é.proskill", "/100%/#x?.proskill", "/a:b"})
    CHECK(report::toPath(report::toUri(path)) == std::filesystem::path(path));
}

TEST_CASE("a URI is decoded however a client writes it") {
  CHECK(report::toPath("file:///a%20b/c%3Ad") == std::filesystem::path("/a b/c:d"));
  CHECK(report::toPath("file://localhost/a") == std::filesystem::path("/a"));
  CHECK(report::toPath("file:///a/../b") == std::filesystem::path("/b"));
  CHECK(report::toPath("file:///50%") == std::filesystem::path("/50%"));
  CHECK(report::normalised("file:///c%3A/x") == report::normalised("file:///c:/x"));
}

TEST_CASE("other schemes have no path and keep their spelling") {
  CHECK(!report::toPath("untitled:Untitled-1"));
  CHECK(report::normalised("untitled:Untitled-1") == "untitled:Untitled-1");
}

TEST_CASE("a text that is part of a file lies beside it, by a name without quotes and escapes") {
  CHECK(pathOf("vscode-notebook-cell:/w/a%20b.ipynb#W0sZmlsZQ%3D%3D") ==
        "/w/a b.ipynb#W0sZmlsZQ==");
  CHECK(pathOf("vscode-notebook-cell://host/w/x/../a.ipynb?q#%22a%2Fb%25") == "/w/a.ipynb?q#_a_b_");
  CHECK(pathOf("cell:Untitled-1#W0%3D").parent_path() == "/");
  CHECK(pathOf("cell:Untitled-1#W0%3D") == pathOf("cell:Untitled-1#W0="));
  CHECK(pathOf("cell:#") != pathOf("cell:?#"));
  CHECK(pathOf("cell://host#x").parent_path() == "/");
}

TEST_CASE("a path for a URI of another scheme is that URI again") {
  for (const auto* uri : {"untitled:Untitled-1", "git:/w/a.proskill?x", "untitled:/c:/w/%C3%A9"})
    CHECK(report::toUri(pathOf(uri)) == uri);
  CHECK(report::toUri("/c:/w") == "file:///c%3A/w");
  CHECK(report::toUri("/w/untitled:x") == "file:///w/untitled%3Ax");
}
