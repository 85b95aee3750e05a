#include "tests/lsp/support/desk.h"
#include "tests/lsp/support/examples.h"
#include "tests/lsp/support/token_edits.h"
#include "tests/support/random/random_edits.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Encoding;
using test::Desk;
using test::Files;

/// Answers about a whole text reuse the parts that an edit did not touch.
namespace {

constexpr auto kTokens = "textDocument/semanticTokens/full";
constexpr auto kChangedTokens = "textDocument/semanticTokens/full/delta";

/// Strings begin with characters of several bytes, so that columns differ in every encoding.
std::string withWideStrings(const std::string& text) {
  std::string result;
  bool inString = false;
  for (const char c : text) {
    result += c;
    if (c == '"' && (inString = !inString)) result += "é\U0001f600";
  }
  return result;
}

/// A client that has tokens and requests their changes.
class TokenReader {
public:
  explicit TokenReader(const Desk& desk, const std::string& file)
      : desk(desk), file(file), last(desk.answer(kTokens, file)) {}

  /// All numbers after an answer to the request for changes, and how many of them the answer
  /// contained.
  std::pair<Json, std::size_t> next() {
    const auto answer = desk.answer(kChangedTokens, file, {{"previousResultId", last["resultId"]}});
    const auto data = test::afterEdits(last["data"], answer.at("edits"));
    std::size_t sent = 0;
    for (const auto& edit : answer["edits"]) sent += edit["data"].size();
    last = {{"resultId", answer["resultId"]}, {"data", data}};
    return {data, sent};
  }

private:
  const Desk& desk;
  std::string file;
  Json last;
};

struct Counts {
  std::size_t all = 0;
  std::size_t sent = 0;
};

void compare(const Desk& desk, TokenReader& tokens, const std::string& file, const Files& files,
             Encoding encoding, Counts& counts) {
  const Desk fresh(files, encoding);
  for (const auto* method :
       {"textDocument/documentSymbol", "textDocument/foldingRange", "textDocument/codeLens"}) {
    INFO(method);
    CHECK(desk.answer(method, file) == fresh.answer(method, file));
  }
  const auto all = fresh.answer(kTokens, file)["data"];
  CHECK(desk.answer("textDocument/semanticTokens/range", file)["data"] == all);
  const auto [changed, sent] = tokens.next();
  CHECK(changed == all);
  counts.all += all.size();
  counts.sent += sent;
}

/// Edits one file of a program, and sends requests after some of the edits.
void edit(Files files, const std::string& file, Encoding encoding, std::uint64_t seed,
          Counts& counts) {
  Desk desk(files, encoding);
  TokenReader tokens(desk, file);
  test::RandomEdits edits(seed);
  const auto original = files[file];
  for (int i = 0; i < 24; ++i) {
    auto& text = files[file];
    auto next = edits.pick(2) == 0 ? edits.slip(text) : edits.touch(text);
    if (edits.pick(8) == 0) next = {{0, static_cast<syntax::Offset>(text.size())}, original};
    INFO("edit " << i << " at " << next.range.begin << "-" << next.range.end << ": " << next.text
                 << "\nof\n"
                 << text);
    text.replace(next.range.begin, next.range.length(), next.text);
    desk.edit(file, next);
    if (edits.pick(3) != 0) compare(desk, tokens, file, files, encoding, counts);
  }
}

} // namespace

TEST_CASE("after any edits, answers about a text are those of who reads it afresh") {
  std::uint64_t seed = 1;
  Counts counts;
  for (const auto& name : test::examples()) {
    auto files = test::example(name);
    for (auto& [file, text] : files) text = withWideStrings(text);
    for (const auto encoding : {Encoding::Utf8, Encoding::Utf16, Encoding::Utf32})
      for (const auto& [file, text] : files) {
        INFO(name << "/" << file << ", encoding " << static_cast<int>(encoding));
        edit(files, file, encoding, seed++, counts);
      }
  }
  CHECK(counts.sent < counts.all / 2);
}

TEST_CASE("changes of tokens are edits where they happen, however far from each other") {
  const std::string uses = "(defskill s :precondition (p (lamp On)) :action (a))\n";
  std::string between;
  for (int i = 0; i < 100; ++i) between += "(defevent e" + std::to_string(i) + ")\n";
  const Files files{{"a.proskill", "(defsv lamp :states (On Off) :init Off)\n" + between + uses}};
  Desk desk(files, Encoding::Utf16);
  const auto before = desk.answer(kTokens, "a.proskill");
  desk.edit("a.proskill", {{7, 7}, "x"});
  const auto after =
      desk.answer(kChangedTokens, "a.proskill", {{"previousResultId", before["resultId"]}});
  // Here the name is longer, so that what follows moves; there it is unknown.
  const auto whole = desk.answer(kTokens, "a.proskill")["data"];
  REQUIRE(after["edits"].size() == 2);
  CHECK(after["edits"][0]["data"].size() == 10);
  CHECK(after["edits"][1]["data"].size() == 5);
  CHECK(test::afterEdits(before["data"], after["edits"]) == whole);
}

TEST_CASE("lists come in parts where a client wants them so") {
  const Desk desk({{"a.proskill", "(defevent e)\n(defevent f)\n; one\n; two\n"}}, Encoding::Utf16);
  for (const auto* method :
       {"textDocument/documentSymbol", "textDocument/foldingRange", "textDocument/codeLens"}) {
    INFO(method);
    const auto list = desk.answer(method, "a.proskill");
    CHECK_FALSE(list.empty());
    CHECK(desk.inParts(method, "a.proskill") == list);
  }
}
