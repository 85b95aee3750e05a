#include "tests/lsp/support/desk.h"
#include "tests/lsp/support/examples.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace proskill;
using syntax::Encoding;
using syntax::Offset;
using test::Desk;
using test::Files;

/// Performs the edits that the server offers: for every name and every action in the examples.
namespace {

std::string nameOf(const std::string& uri) { return uri.substr(std::string("file:///w/").size()); }

/// Performs the edits of one text, which must not overlap.
void carryOut(std::string& text, std::vector<Json> edits) {
  // From the end, so that earlier positions stay valid.
  std::sort(edits.begin(), edits.end(),
            [](const Json& a, const Json& b) { return b["range"] < a["range"]; });
  Offset last = static_cast<Offset>(text.size());
  for (const auto& edit : edits) {
    auto begin = edit["range"][0].get<Offset>();
    auto end = edit["range"][1].get<Offset>();
    INFO(edit.dump());
    REQUIRE(end <= last);
    text.replace(begin, end - begin, edit["newText"].get<std::string>());
    last = begin;
  }
}

/// The texts after a `WorkspaceEdit`, whose positions are in bytes.
Files after(Files files, const Json& edit) {
  if (edit.contains("changes"))
    for (const auto& [uri, edits] : edit["changes"].items()) carryOut(files.at(nameOf(uri)), edits);
  if (edit.contains("documentChanges"))
    for (const auto& it : edit["documentChanges"])
      carryOut(files.at(nameOf(it["textDocument"]["uri"])), it["edits"]);
  return files;
}

/// How often each code occurs in the findings of the texts.
std::map<std::string, int> findings(const Files& files) {
  const Desk desk(files, Encoding::Utf8);
  std::map<std::string, int> result;
  for (const auto& [file, text] : files)
    for (const auto& item : desk.ask("textDocument/diagnostic", file, 0)["items"])
      ++result[item["code"].get<std::string>()];
  return result;
}

/// The places that an edit changes: `file:byte`.
std::set<std::string> placesOf(const Json& edit) {
  std::set<std::string> result;
  for (const auto& it : edit["documentChanges"])
    for (const auto& change : it["edits"])
      result.insert(nameOf(it["textDocument"]["uri"]) + ":" + change["range"][0].dump());
  return result;
}

} // namespace

TEST_CASE("scan: whatever is renamed, the findings stay the same") {
  std::size_t renamed = 0;
  for (const auto& name : test::examples()) {
    const auto files = test::example(name);
    const Desk desk(files, Encoding::Utf16);
    const auto before = findings(files);
    std::set<std::string> done;
    for (const auto& [file, text] : files)
      for (auto at : test::placesIn(text, false)) {
        if (done.contains(file + ":" + std::to_string(at))) continue;
        const auto edit = desk.ask("textDocument/rename", file, at);
        if (edit.is_null() || edit.contains("error") || !done.insert(edit.dump()).second) continue;
        done.merge(placesOf(edit));
        INFO(name << "/" << file << ", byte " << at << ": " << edit.dump());
        const auto changed = after(files, edit);
        CHECK(changed != files);
        CHECK(findings(changed) == before);
        ++renamed;
      }
  }
  CHECK(renamed > 100);
}
