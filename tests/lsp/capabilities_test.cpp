#include "tests/lsp/support/session.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <set>
#include <sstream>

using namespace proskill;
using test::Session;

namespace {

const std::filesystem::path kSources = PROSKILL_SOURCE_DIR;

/// A row of the manual's table: a capability, its requests, its sources, its tests.
struct Row {
  std::string capability;
  std::vector<std::string> requests;
  std::vector<std::string> files;
};

/// The text in backquotes.
std::vector<std::string> codeIn(const std::string& text) {
  std::vector<std::string> result;
  for (auto at = text.find('`'); at != std::string::npos; at = text.find('`', at + 1)) {
    const auto end = text.find('`', at + 1);
    result.push_back(text.substr(at + 1, end - at - 1));
    at = end;
  }
  return result;
}

std::vector<Row> rowsOfManual() {
  std::ifstream manual(kSources / "docs/lsp.md");
  std::vector<Row> rows;
  bool inside = false;
  for (std::string line; std::getline(manual, line);) {
    if (line.starts_with("#")) inside = line == "## Capabilities";
    if (!inside || !line.starts_with("| `")) continue;
    std::istringstream cells(line.substr(1));
    std::string capability, requests, files, tests;
    std::getline(cells, capability, '|'), std::getline(cells, requests, '|');
    std::getline(cells, files, '|'), std::getline(cells, tests, '|');
    rows.push_back({codeIn(capability).at(0), codeIn(requests), codeIn(files + tests)});
  }
  return rows;
}

} // namespace

TEST_CASE("the manual's table of capabilities is what the server announces") {
  Session session;
  const Json pulls{{"textDocument", {{"diagnostic", Json::object()}}}};
  const auto announced = session.result("initialize", {{"capabilities", pulls}});
  session.notify("initialized", Json::object());
  std::set<std::string> told;
  for (const auto& row : rowsOfManual()) told.insert(row.capability);
  std::set<std::string> found;
  for (const auto& [name, value] : announced["capabilities"].items()) found.insert(name);
  CHECK(told == found);
}

TEST_CASE("each request of the table is served, and each that is served stands in it") {
  Session session;
  session.initialize();
  std::set<std::string> told;
  for (const auto& row : rowsOfManual())
    for (const auto& request : row.requests) {
      INFO(request);
      CHECK(told.insert(request).second);
      if (request.contains("Document/did") || request.starts_with("workspace/did")) continue;
      const auto answer = session.ask(request, Json::object());
      CHECK((!answer.contains("error") || answer["error"]["code"] != -32601));
    }
  for (const auto& [method, handler] : lsp::allFeatures().methods) {
    INFO(method);
    CHECK((method.starts_with("proskill/") || told.contains(method)));
  }
}

TEST_CASE("the files of the table are there") {
  for (const auto& row : rowsOfManual())
    for (const auto& file : row.files) {
      INFO(file);
      CHECK(std::filesystem::exists(kSources / file));
    }
}
