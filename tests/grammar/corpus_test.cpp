#include "tests/where.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <tree_sitter/api.h>
#include <tree_sitter/tree-sitter-proskill.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <sstream>

namespace {

namespace fs = std::filesystem;

const fs::path kGrammar = fs::path(PROSKILL_SOURCE_DIR) / "tree-sitter-proskill";

std::string readFile(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// The files of the corpus by their names without `.txt`.
std::map<std::string, std::string> corpus() {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(kGrammar / "test/corpus"))
    files.emplace(entry.path().stem().string(), readFile(entry.path()));
  return files;
}

struct Example {
  std::string name;
  std::string text;
  std::string tree; ///< the expected S-expression
};

std::vector<std::string> linesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool isRule(const std::string& line, char sign) {
  return line.size() >= 3 && line.find_first_not_of(sign) == std::string::npos;
}

/// The examples in a file of the corpus: a name between two lines of `=`, a text, a line of `-`, a
/// tree.
std::vector<Example> examplesOf(const std::string& file) {
  std::vector<Example> examples;
  const auto lines = linesOf(file);
  bool inTree = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (isRule(lines[i], '=')) {
      examples.push_back({lines.at(i + 1), "", ""});
      i += 2;
      inTree = false;
    } else if (isRule(lines[i], '-')) {
      inTree = true;
    } else {
      auto& example = examples.at(examples.size() - 1);
      (inTree ? example.tree : example.text) += lines[i] + "\n";
    }
  }
  return examples;
}

/// An S-expression on one line, as tree-sitter prints it.
std::string onOneLine(const std::string& tree) {
  auto line = std::regex_replace(tree, std::regex(R"(\s+)"), " ");
  line = std::regex_replace(line, std::regex(R"( \))"), ")");
  return std::regex_replace(line, std::regex(R"(^ | $)"), "");
}

std::string treeOf(const std::string& text) {
  const std::unique_ptr<TSParser, decltype(&ts_parser_delete)> parser(ts_parser_new(),
                                                                      ts_parser_delete);
  REQUIRE(ts_parser_set_language(parser.get(), tree_sitter_proskill()));
  const std::unique_ptr<TSTree, decltype(&ts_tree_delete)> tree(
      ts_parser_parse_string(parser.get(), nullptr, text.data(),
                             static_cast<std::uint32_t>(text.size())),
      ts_tree_delete);
  const std::unique_ptr<char, decltype(&std::free)> shown(
      ts_node_string(ts_tree_root_node(tree.get())), std::free);
  return shown.get();
}

} // namespace

TEST_CASE("each example of the corpus has the tree that stands below it") {
  std::size_t count = 0;
  for (const auto& [name, file] : corpus())
    for (const auto& example : examplesOf(file)) {
      INFO(name << ".txt: " << example.name << "\n" << example.text);
      CHECK(treeOf(example.text) == onOneLine(example.tree));
      ++count;
    }
  CHECK(count > 120);
}

TEST_CASE("the corpus shows every kind of node, each in the file of its name") {
  const auto files = corpus();
  for (const auto& type : nlohmann::json::parse(readFile(kGrammar / "src/node-types.json"))) {
    if (!type["named"].get<bool>()) continue;
    const auto kind = type["type"].get<std::string>();
    INFO(kind);
    REQUIRE(files.contains(kind));
    CHECK(files.at(kind).find("(" + kind) != std::string::npos);
  }
}

TEST_CASE("no example of the corpus is beyond the grammar") {
  for (const auto& [name, file] : corpus()) {
    INFO(name);
    CHECK(file.find("(ERROR") == std::string::npos);
    CHECK(file.find("(MISSING") == std::string::npos);
  }
}
