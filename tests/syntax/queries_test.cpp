#include "tests/syntax/programs.h"
#include "tests/where.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include <tree_sitter/api.h>
#include <tree_sitter/tree-sitter-proskill.h>

using namespace proskill;

/// The queries of the grammar, which editors use for colours, folds and indentation.
namespace {

struct Delete {
  void operator()(TSQuery* query) const { ts_query_delete(query); }
  void operator()(TSQueryCursor* cursor) const { ts_query_cursor_delete(cursor); }
  void operator()(TSParser* parser) const { ts_parser_delete(parser); }
  void operator()(TSTree* tree) const { ts_tree_delete(tree); }
};

const std::string kQueries = "tree-sitter-proskill/queries/";

std::unique_ptr<TSQuery, Delete> load(const std::string& name, const std::string& folder) {
  std::ostringstream source;
  source << std::ifstream(PROSKILL_SOURCE_DIR "/" + folder + name + ".scm").rdbuf();
  auto text = source.str();
  std::uint32_t place = 0;
  TSQueryError error = TSQueryErrorNone;
  std::unique_ptr<TSQuery, Delete> query(ts_query_new(tree_sitter_proskill(), text.data(),
                                                      static_cast<std::uint32_t>(text.size()),
                                                      &place, &error));
  INFO(name << ".scm, at: " << text.substr(place, 60));
  REQUIRE(text.size() > 0);
  REQUIRE(error == TSQueryErrorNone);
  return query;
}

/// What the query captures in a text: `capture text`.
std::set<std::string> capturesIn(const std::string& name, const std::string& text,
                                 const std::string& folder = kQueries) {
  auto query = load(name, folder);
  std::unique_ptr<TSParser, Delete> parser(ts_parser_new());
  ts_parser_set_language(parser.get(), tree_sitter_proskill());
  std::unique_ptr<TSTree, Delete> tree(ts_parser_parse_string(
      parser.get(), nullptr, text.data(), static_cast<std::uint32_t>(text.size())));
  std::unique_ptr<TSQueryCursor, Delete> cursor(ts_query_cursor_new());
  ts_query_cursor_exec(cursor.get(), query.get(), ts_tree_root_node(tree.get()));
  std::set<std::string> found;
  TSQueryMatch match;
  while (ts_query_cursor_next_match(cursor.get(), &match)) {
    for (std::uint16_t i = 0; i < match.capture_count; ++i) {
      const TSQueryCapture& capture = match.captures[i];
      std::uint32_t length = 0;
      std::string label = ts_query_capture_name_for_id(query.get(), capture.index, &length);
      auto begin = ts_node_start_byte(capture.node);
      found.insert(label + " " + text.substr(begin, ts_node_end_byte(capture.node) - begin));
    }
  }
  return found;
}

} // namespace

TEST_CASE("every query fits the grammar and finds something in the paper's listings") {
  for (std::string name : {"highlights", "folds", "indents", "locals", "tags", "injections"})
    CHECK_FALSE(capturesIn(name, test::paperProgram()).empty());
}

TEST_CASE("the queries of editors fit the grammar") {
  for (std::string name : {"highlights", "indents", "injections", "textobjects"}) {
    INFO(name);
    CHECK_FALSE(capturesIn(name, test::paperProgram(), "editors/helix/queries/proskill/").empty());
  }
  for (std::string name : {"highlights", "folds", "indents", "injections"}) {
    INFO(name);
    CHECK_FALSE(capturesIn(name, test::paperProgram(), "editors/nvim/queries/proskill/").empty());
  }
}

TEST_CASE("highlights tell names, words of the language, and values apart") {
  auto found =
      capturesIn("highlights", "(defskill fly :time_interval [1,3]\n"
                               "  :body ((takeoff height 3.0) ; up\n"
                               "         (if (= takeoff.status success) (success done))))");
  for (std::string expected :
       {"keyword defskill", "function fly", "property :body", "number 3.0", "comment ; up",
        "function.call takeoff", "keyword.conditional if", "constant.builtin success", "label done",
        "variable.parameter height", "variable.member status"}) {
    INFO(expected);
    CHECK(found.contains(expected));
  }
}

TEST_CASE("tags name the definitions and the calls") {
  auto found = capturesIn("tags", "(defsv level :init 1)\n(defskill fly :body ((takeoff)))");
  CHECK(found.contains("name level"));
  CHECK(found.contains("name fly"));
  CHECK(found.contains("reference.call (takeoff)"));
}

TEST_CASE("locals tie parameters to their definitions") {
  auto found = capturesIn("locals", "(defskill fly :input ($h float) :action (fly $h))");
  CHECK(found.contains("local.definition.parameter $h"));
  CHECK(found.contains("local.reference $h"));
}
