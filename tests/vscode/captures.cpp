/// Prints how tree-sitter colours a file: `first-byte end-byte capture` for each capture; later
/// ones override earlier ones. Used to test that the TextMate grammar colours alike.

#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <tree_sitter/api.h>
#include <tree_sitter/tree-sitter-proskill.h>

namespace {

struct Delete {
  void operator()(TSQuery* query) const { ts_query_delete(query); }
  void operator()(TSQueryCursor* cursor) const { ts_query_cursor_delete(cursor); }
  void operator()(TSParser* parser) const { ts_parser_delete(parser); }
  void operator()(TSTree* tree) const { ts_tree_delete(tree); }
};

std::string read(const char* path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::uint32_t size(const std::string& text) { return static_cast<std::uint32_t>(text.size()); }

std::string stringOf(const TSQuery* query, std::uint32_t id) {
  std::uint32_t length = 0;
  const char* text = ts_query_string_value_for_id(query, id, &length);
  return {text, length};
}

/// `#any-of?` is the only predicate of our queries: its words, for a pattern that has it.
std::vector<std::string> wordsOf(const TSQuery* query, std::uint32_t pattern) {
  std::uint32_t count = 0;
  const auto* steps = ts_query_predicates_for_pattern(query, pattern, &count);
  std::vector<std::string> words;
  for (std::uint32_t i = 2; i < count; ++i)
    if (steps[i].type == TSQueryPredicateStepTypeString)
      words.push_back(stringOf(query, steps[i].value_id));
  return words;
}

bool fits(const std::vector<std::string>& words, const std::string& text) {
  if (words.empty()) return true;
  for (const auto& word : words)
    if (word == text) return true;
  return false;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: highlight_captures QUERY FILE\n";
    return 2;
  }
  auto source = read(argv[1]);
  auto text = read(argv[2]);
  std::uint32_t place = 0;
  TSQueryError error = TSQueryErrorNone;
  std::unique_ptr<TSQuery, Delete> query(
      ts_query_new(tree_sitter_proskill(), source.data(), size(source), &place, &error));
  if (!query) {
    std::cerr << "the query has an error at byte " << place << "\n";
    return 1;
  }
  std::unique_ptr<TSParser, Delete> parser(ts_parser_new());
  ts_parser_set_language(parser.get(), tree_sitter_proskill());
  std::unique_ptr<TSTree, Delete> tree(
      ts_parser_parse_string(parser.get(), nullptr, text.data(), size(text)));
  std::unique_ptr<TSQueryCursor, Delete> cursor(ts_query_cursor_new());
  ts_query_cursor_exec(cursor.get(), query.get(), ts_tree_root_node(tree.get()));
  TSQueryMatch match;
  while (ts_query_cursor_next_match(cursor.get(), &match))
    for (std::uint16_t i = 0; i < match.capture_count; ++i) {
      const TSQueryCapture& capture = match.captures[i];
      auto begin = ts_node_start_byte(capture.node);
      auto end = ts_node_end_byte(capture.node);
      if (!fits(wordsOf(query.get(), match.pattern_index), text.substr(begin, end - begin)))
        continue;
      std::uint32_t length = 0;
      std::string name = ts_query_capture_name_for_id(query.get(), capture.index, &length);
      std::cout << begin << ' ' << end << ' ' << match.pattern_index << ' ' << name << '\n';
    }
}
