#include "tests/lsp/support/session.h"

#include <catch2/catch.hpp>

namespace proskill::test::notebook_test {

using test::MemoryFiles;
using test::rangeOf;
using test::Session;

namespace {

constexpr auto kNotebook = "file:///w/mission.ipynb";
const std::string kLamp = "(defsv lamp :states (On Off) :init Off)\n";
const std::string kSwitch = "(defevent e :effects (lamp On))\n";

std::string cellUri(const std::string& name) {
  return "vscode-notebook-cell:/w/mission.ipynb#" + name + "sZmlsZQ%3D%3D";
}

Json cell(const std::string& name) { return {{"kind", 2}, {"document", cellUri(name)}}; }

Json identifier(const std::string& name) { return {{"uri", cellUri(name)}}; }

Json item(const std::string& name, const std::string& text, const char* language = "proskill") {
  return {{"uri", cellUri(name)}, {"languageId", language}, {"version", 1}, {"text", text}};
}

/// A client with a notebook that requests diagnostics.
class Notebook {
public:
  using Cells = std::vector<std::pair<std::string, std::string>>; ///< names and texts

  explicit Notebook(const Cells& cells, Session::Options options = {.pull = true})
      : session(std::move(options)) {
    session.initialize();
    Json list = Json::array();
    Json texts = Json::array();
    for (const auto& [name, text] : cells) {
      list.push_back(cell(name));
      texts.push_back(item(name, text));
    }
    open(list, texts);
  }

  void open(const Json& cells, const Json& texts) {
    session.notify("notebookDocument/didOpen", {{"notebookDocument",
                                                 {{"uri", kNotebook},
                                                  {"notebookType", "jupyter-notebook"},
                                                  {"version", 1},
                                                  {"cells", cells}}},
                                                {"cellTextDocuments", texts}});
  }
  void change(const Json& cells) {
    session.notify("notebookDocument/didChange",
                   {{"notebookDocument", {{"uri", kNotebook}, {"version", ++version}}},
                    {"change", {{"cells", cells}}}});
  }
  /// Replaces cells; some texts are closed, others opened.
  void splice(unsigned start, unsigned count, const std::vector<std::string>& names,
              const Json& opened = Json::array(), const Json& closed = Json::array()) {
    Json cells = Json::array();
    for (const auto& name : names) cells.push_back(cell(name));
    change({{"structure",
             {{"array", {{"start", start}, {"deleteCount", count}, {"cells", cells}}},
              {"didOpen", opened},
              {"didClose", closed}}}});
  }
  void edit(const std::string& name, const Json& range, const std::string& text) {
    change({{"textContent",
             Json::array({{{"document", {{"uri", cellUri(name)}, {"version", version + 1}}},
                           {"changes", Json::array({{{"range", range}, {"text", text}}})}}})}});
  }
  void close(const Json& texts = Json::array()) {
    session.notify("notebookDocument/didClose",
                   {{"notebookDocument", {{"uri", kNotebook}}}, {"cellTextDocuments", texts}});
  }

  /// The codes of the findings in a cell.
  std::vector<std::string> codes(const std::string& name) {
    std::vector<std::string> result;
    const auto report =
        session.result("textDocument/diagnostic", {{"textDocument", identifier(name)}});
    for (const auto& each : report["items"])
      if (each["severity"] == 1) result.push_back(each["code"]);
    return result;
  }
  /// The texts that the server holds.
  std::vector<std::string> held() {
    std::vector<std::string> result;
    const auto status = session.result("proskill/status", nullptr);
    CHECK(status["errors"] == 0);
    for (const auto& each : status["documents"]) result.push_back(each["uri"]);
    return result;
  }
  std::string problem() { return session.notified("window/logMessage")["message"]; }

  Session session;
  int version = 1;
};

using Codes = std::vector<std::string>;
const Codes kUnknown{"PS0202"}; ///< an undefined name
const Codes kNone;

} // namespace

TEST_CASE("the cells of a notebook are one program, and each has what is said of it") {
  Notebook notebook({{"a", kLamp}, {"b", kSwitch}});
  auto& session = notebook.session;
  CHECK(notebook.codes("a") == kNone);
  CHECK(notebook.codes("b") == kNone);
  CHECK(session.at("textDocument/definition", cellUri("b"), 0, 22) ==
        Json::array({{{"uri", cellUri("a")}, {"range", rangeOf(0, 7, 11)}}}));
  const auto references = session.at("textDocument/references", cellUri("a"), 0, 8,
                                     {{"context", {{"includeDeclaration", true}}}});
  REQUIRE(references.size() == 2);
  CHECK(references[1]["uri"] == cellUri("b"));

  const auto edits = session.at("textDocument/rename", cellUri("b"), 0, 22, {{"newName", "light"}});
  REQUIRE(edits["documentChanges"].size() == 2);
  CHECK(edits["documentChanges"][0]["textDocument"] == Json{{"uri", cellUri("a")}, {"version", 1}});
  CHECK(edits["documentChanges"][1]["textDocument"]["uri"] == cellUri("b"));

  CHECK(session.result("workspace/symbol", {{"query", "lamp"}})[0]["location"]["uri"] ==
        cellUri("a"));
  CHECK(session.result("textDocument/documentSymbol", {{"textDocument", identifier("b")}}).size() ==
        1);
  notebook.edit("b", rangeOf(0, 0, 0), "  ");
  const auto layout = session.result(
      "textDocument/formatting",
      {{"textDocument", identifier("b")}, {"options", {{"tabSize", 2}, {"insertSpaces", true}}}});
  CHECK(layout == Json::array({{{"range", rangeOf(0, 0, 2)}, {"newText", ""}}}));
}

TEST_CASE("a notebook itself is in no answer") {
  Notebook notebook({{"a", kLamp}, {"b", kSwitch}});
  auto& session = notebook.session;
  CHECK(notebook.held() == std::vector{cellUri("a"), cellUri("b")});
  const auto whole = session.result("workspace/diagnostic", {{"previousResultIds", Json::array()}});
  REQUIRE(whole["items"].size() == 2);
  for (const auto& each : whole["items"]) CHECK(each["uri"] != kNotebook);
  const Json itself{{"textDocument", {{"uri", kNotebook}}}};
  CHECK(session.ask("textDocument/documentSymbol", itself)["error"]["code"] == -32602);
  CHECK(session.result("textDocument/diagnostic", itself)["items"].empty());
  const Json moved{{"oldUri", "file:///w"}, {"newUri", "file:///elsewhere"}};
  CHECK(session.result("workspace/willRenameFiles", {{"files", {moved}}}).is_null());
  // Neither it nor a cell can be included.
  notebook.edit("b", rangeOf(0, 0, 0), "(include \"\")");
  CHECK(session.at("textDocument/completion", cellUri("b"), 0, 10)["items"].empty());
}

TEST_CASE("a cell that includes its notebook hears nothing of the notebook's text") {
  Notebook notebook({{"a", "(include \"mission.ipynb\")" + kLamp}, {"b", kSwitch}});
  for (const auto* name : {"a", "b"}) {
    const auto report =
        notebook.session.result("textDocument/diagnostic", {{"textDocument", identifier(name)}});
    CHECK_FALSE(report.dump().contains(kNotebook));
  }
}

TEST_CASE("findings of cells are told at the cells") {
  Notebook notebook({{"a", "(defsv lamp :states (On Off) :init Of)"}, {"b", kSwitch}},
                    {.debounce = std::chrono::milliseconds(0)});
  std::set<std::string> told;
  while (told.size() < 2)
    told.insert(notebook.session.notified("textDocument/publishDiagnostics")["uri"]);
  CHECK(told == std::set{cellUri("a"), cellUri("b")});
}

TEST_CASE("cells come, go and move, and are edited") {
  Notebook notebook({{"a", kLamp}, {"b", kSwitch}});
  notebook.splice(0, 1, {}, Json::array(), Json::array({identifier("a")}));
  CHECK(notebook.codes("b") == kUnknown);
  notebook.splice(1, 0, {"c"}, Json::array({item("c", kLamp)})); // dependencies may come later
  CHECK(notebook.codes("b") == kNone);
  CHECK(notebook.held() == std::vector{cellUri("b"), cellUri("c")});
  // of two definitions the later one is the duplicate
  notebook.splice(2, 0, {"d"}, Json::array({item("d", kLamp)}));
  CHECK(notebook.codes("c") == kNone);
  CHECK(notebook.codes("d").size() == 1);
  notebook.splice(1, 2, {"d", "c"}); // moved
  CHECK(notebook.codes("c").size() == 1);
  CHECK(notebook.codes("d") == kNone);
  notebook.edit("d", rangeOf(0, 7, 11), "door");
  CHECK(notebook.codes("c") == kNone);
  // A cell that one message closes and opens is open.
  notebook.splice(1, 1, {"d"}, Json::array({item("d", kLamp)}), Json::array({identifier("d")}));
  CHECK(notebook.codes("c").size() == 1);
}

TEST_CASE("edits of cells are counted as negotiated") {
  for (const auto& [encoding, column] :
       {std::pair{"utf-8", 23U}, std::pair{"utf-16", 21U}, std::pair{"utf-32", 20U}}) {
    INFO(encoding);
    Notebook notebook({{"a", kLamp}, {"b", "(defevent e) ; 😀 é\n" + kSwitch}},
                      {.encoding = encoding, .pull = true});
    notebook.edit("b", rangeOf(0, 15, column - 1), "x y");
    notebook.edit("b", rangeOf(0, 0, 18), "; ");
    CHECK(notebook.codes("b") == kNone);
    CHECK(notebook.session.at("textDocument/definition", cellUri("b"), 1, 22).size() == 1);
  }
}

TEST_CASE("cells include what lies beside their notebook, and a notebook may have no file") {
  const std::map<std::string, std::string> files{{"/w/lamp.proskill", kLamp}};
  Notebook notebook({{"a", "(include \"lamp.proskill\")"}, {"b", kSwitch}},
                    {.disk = std::make_shared<MemoryFiles>(files), .pull = true});
  auto& session = notebook.session;
  CHECK(notebook.codes("a") == kNone);
  CHECK(session.at("textDocument/definition", cellUri("b"), 0, 22)[0]["uri"] ==
        "file:///w/lamp.proskill");

  const Json moved{{"oldUri", kNotebook}, {"newUri", "file:///w/deep/mission.ipynb"}};
  const auto edits =
      session.result("workspace/willRenameFiles", {{"files", {moved}}})["documentChanges"];
  REQUIRE(edits.size() == 1);
  CHECK(edits[0]["textDocument"]["uri"] == cellUri("a"));
  CHECK(edits[0]["edits"][0]["newText"] == "../lamp.proskill");

  const std::string one = "vscode-notebook-cell:Untitled-1.ipynb?jupyter#W0sdW50aXRsZWQ%3D";
  const std::string two = "vscode-notebook-cell:Untitled-1.ipynb?jupyter#W1sdW50aXRsZWQ%3D";
  auto text = [](const std::string& uri, const std::string& content) -> Json {
    return {{"uri", uri}, {"languageId", "proskill"}, {"version", 1}, {"text", content}};
  };
  session.notify(
      "notebookDocument/didOpen",
      {{"notebookDocument",
        {{"uri", "untitled:Untitled-1.ipynb?jupyter"},
         {"notebookType", "any"},
         {"version", 1},
         {"cells", {{{"kind", 2}, {"document", one}}, {{"kind", 2}, {"document", two}}}}}},
       {"cellTextDocuments", {text(one, kLamp), text(two, kSwitch)}}});
  CHECK(session.at("textDocument/definition", two, 0, 22)[0]["uri"] == one);
  const auto tests = session.result("proskill/tests", {{"textDocument", {{"uri", two}}}});
  CHECK(tests["programs"][0]["uri"] == "untitled:Untitled-1.ipynb?jupyter");
}

TEST_CASE("cells in other languages are none of the server's") {
  Notebook notebook({});
  notebook.splice(
      0, 0, {"a", "text", "b"},
      Json::array({item("a", kLamp), item("text", "# Lamps", "markdown"), item("b", kSwitch)}));
  notebook.edit("text", rangeOf(0, 0, 1), "##");
  CHECK(notebook.codes("b") == kNone);
  CHECK(notebook.held() == std::vector{cellUri("a"), cellUri("b")});
  notebook.splice(1, 1, {}, Json::array(), Json::array({identifier("text")}));
  CHECK(notebook.codes("b") == kNone);
  CHECK_FALSE(notebook.session.hasMore()); // there were no findings
}

TEST_CASE("a notebook that is closed leaves nothing, whatever is said of its cells") {
  Notebook notebook({{"a", kLamp}, {"b", kSwitch}});
  notebook.close(Json::array({identifier("a")}));
  CHECK(notebook.held().empty());
  const auto whole =
      notebook.session.result("workspace/diagnostic", {{"previousResultIds", Json::array()}});
  CHECK(whole["items"].empty());
  notebook.open(Json::array({cell("b")}), Json::array({item("b", kSwitch)}));
  CHECK(notebook.codes("b") == kUnknown);
  notebook.open(Json::array({cell("a")}), Json::array({item("a", kLamp)})); // never closed
  CHECK(notebook.held() == std::vector{cellUri("a")});
}

TEST_CASE("the user is told how to get a lost cell back, whatever the client does for files") {
  const Json dynamic{{"textDocument", {{"synchronization", {{"dynamicRegistration", true}}}}}};
  Notebook notebook({{"a", kLamp}}, {.pull = true, .capabilities = dynamic});
  notebook.edit("a", rangeOf(99, 0, 0), "x");
  const auto report =
      notebook.session.result("textDocument/diagnostic", {{"textDocument", identifier("a")}});
  REQUIRE(report["items"].size() == 1);
  CHECK(report["items"][0]["message"].get<std::string>().ends_with(
      "; please close the notebook and open it again"));
}

TEST_CASE("what is wrong with a message about a notebook is told, and nothing is lost") {
  Notebook notebook({{"a", kLamp}, {"b", kSwitch}});
  auto& session = notebook.session;
  auto stillThere = [&] {
    CHECK(notebook.codes("b") == kNone);
    CHECK(notebook.held() == std::vector{cellUri("a"), cellUri("b")});
  };
  notebook.edit("nobody", rangeOf(0, 0, 0), "x");
  CHECK(notebook.problem() == "a change of a cell that is not open in its notebook");
  notebook.change({{"structure", {{"array", {{"start", 1}, {"deleteCount", 7}}}}}});
  CHECK(notebook.problem().starts_with("a change of a notebook's cells does not fit them"));
  notebook.splice(3, 0, {});
  CHECK(notebook.problem().starts_with("a change of a notebook's cells does not fit them"));
  for (const auto& array : {Json{{"start", -1}, {"deleteCount", 0}}, Json("x"), Json()}) {
    notebook.change({{"structure", {{"array", array}}}});
    CHECK(notebook.problem().starts_with("a change of a notebook's cells does not fit them"));
  }
  notebook.change("x");
  notebook.change({{"structure", 1}, {"textContent", {{"x", 1}}}});
  notebook.change({{"textContent", Json::array({1})}});
  CHECK(notebook.problem() == "`document.uri` is missing");
  stillThere();

  notebook.splice(2, 0, {"c"}, Json::array({item("c", "; nothing")}));
  const auto closed = Json::array({identifier("c"), identifier("c")});
  notebook.splice(2, 1, {}, Json::array(), closed);
  CHECK(notebook.problem() == "a cell was closed that is not open in its notebook");
  notebook.splice(0, 0, {}, Json::array({{{"uri", cellUri("c")}, {"languageId", "proskill"}}}));
  CHECK(notebook.problem() == "`textDocument.text` is missing");
  stillThere();

  auto other = [](const char* uri) -> Json { return {{"notebookDocument", {{"uri", uri}}}}; };
  session.notify("notebookDocument/didChange", other("file:///w/other.ipynb"));
  CHECK(notebook.problem() == "a change of a notebook that is not open");
  session.notify("notebookDocument/didClose", other("file:///w/other.ipynb"));
  CHECK(notebook.problem() == "a notebook was closed that is not open");
  session.notify("notebookDocument/didOpen", {{"notebookDocument", 1}});
  CHECK(notebook.problem() == "`notebookDocument.uri` is missing");
  session.notify("notebookDocument/didSave", other(kNotebook));
  stillThere();

  // An edit that does not fit closes its cell, as with a text.
  notebook.edit("a", rangeOf(99, 0, 0), "x");
  CHECK(notebook.problem().contains("does not fit its text"));
  CHECK(notebook.held() == std::vector{cellUri("b")});
  notebook.splice(0, 1, {"a"}, Json::array({item("a", kLamp)}));
  stillThere();
}

TEST_CASE("the program of a notebook is verified, and its verdicts are stale when a cell comes") {
  Notebook notebook({{"a", "(defsv lamp :states (On Off) :init Off :transitions ((Off On)))\n"},
                     {"b", kSwitch + "(defevent off :effects (lamp Off))\n"}});
  auto& session = notebook.session;
  const auto done = session.result("proskill/verify", {{"textDocument", identifier("b")}});
  CHECK(done["program"] == kNotebook);
  REQUIRE(done["texts"].size() == 2);
  CHECK(done["texts"][0] == Json{{"uri", cellUri("a")}, {"version", 1}});
  const auto trace = session.result("proskill/trace", {{"textDocument", {{"uri", kNotebook}}},
                                                       {"name", "lamp.no_forbidden_transition"}});
  CHECK(trace["steps"].back()["location"]["uri"] == cellUri("b"));
  auto current = [&](bool stale) {
    while (true) {
      const auto news = session.notified("proskill/verdicts");
      if (news["verdicts"].empty() || news["stale"] != stale) continue;
      CHECK(news["label"] == "mission.ipynb");
      return;
    }
  };
  current(false);
  notebook.splice(2, 0, {"c"}, Json::array({item("c", "(defevent more :effects (lamp On))")}));
  current(true);
}

} // namespace proskill::test::notebook_test
