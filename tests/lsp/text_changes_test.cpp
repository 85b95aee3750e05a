#include "lsp/workspace/text_changes.h"
#include "rpc/pending.h"

#include <catch2/catch.hpp>

#include <random>
#include <set>
#include <string>

using namespace proskill;
using syntax::Encoding;

namespace {

Json change(unsigned line, unsigned from, unsigned toLine, unsigned to, const std::string& text) {
  return {{"range",
           {{"start", {{"line", line}, {"character", from}}},
            {"end", {{"line", toLine}, {"character", to}}}}},
          {"text", text}};
}

/// The text after the changes, applied one by one.
std::string oneByOne(std::string text, const Json& changes) {
  for (const auto& each : changes)
    text =
        lsp::changed(syntax::Document::parse(text), Json::array({each}), Encoding::Utf16)->text();
  return text;
}

std::string longText() {
  std::string text = "; 😀 é\r\n";
  for (int i = 0; i < 600; ++i)
    text += "(defsv lamp" + std::to_string(i) + " :states (On Off) :init Off) ; ü\n";
  return text;
}

Json randomChanges(std::mt19937& random, int count) {
  const std::string pieces[] = {"", "x", "\n", "(", "😀", "(defsv b :init 1 :min 1 :max 2)\n"};
  Json result = Json::array();
  for (int i = 0; i < count; ++i) {
    const auto line = static_cast<unsigned>(random() % 500);
    const auto from = static_cast<unsigned>(random() % 40);
    const auto lines = static_cast<unsigned>(random() % 3);
    const auto to = lines > 0 ? static_cast<unsigned>(random() % 9) : from;
    result.push_back(change(line, from, line + lines, to, pieces[random() % std::size(pieces)]));
  }
  return result;
}

} // namespace

TEST_CASE("many changes of a text at once are the same as one after the other") {
  std::mt19937 random(1);
  const std::string text = longText();
  for (int round = 0; round < 20; ++round) {
    const Json changes = randomChanges(random, 2 + round * 2);
    const auto all = lsp::changed(syntax::Document::parse(text), changes, Encoding::Utf16);
    REQUIRE(all);
    CHECK(all->text() == oneByOne(text, changes));
    CHECK(all->dump() == syntax::Document::parse(all->text()).dump());
  }
}

TEST_CASE("a change within, before and behind the one before it") {
  const auto after = [](Json changes) {
    return lsp::changed(syntax::Document::parse("abcdef\n"), changes, Encoding::Utf8)->text();
  };
  CHECK(after({change(0, 2, 0, 4, "XYZ"), change(0, 3, 0, 4, "")}) == "abXZef\n");
  CHECK(after({change(0, 2, 0, 4, ""), change(0, 1, 0, 3, "-")}) == "a-f\n");
  CHECK(after({change(0, 4, 0, 5, "E"), change(0, 0, 0, 1, "AA")}) == "AAbcdEf\n");
  CHECK(after({change(0, 0, 0, 1, "AA"), change(0, 5, 0, 7, "!")}) == "AAbcd!\n");
  CHECK(after({change(0, 0, 0, 1, "A"), {{"text", "new\n"}}, change(0, 3, 0, 3, "er")}) ==
        "newer\n");
  CHECK(after(Json::array()) == "abcdef\n");
}

TEST_CASE("changes of which one does not fit are none") {
  const auto document = syntax::Document::parse("a\n");
  for (const Json& bad :
       {change(5, 0, 5, 0, "x"), change(0, 1, 0, 0, "x"), Json{{"range", nullptr}}, Json("x"),
        Json{{"text", "x"}, {"range", {{"start", 1}}}}}) {
    CHECK_FALSE(lsp::changed(document, Json::array({bad}), Encoding::Utf8));
    CHECK_FALSE(lsp::changed(document, {change(0, 0, 0, 0, "x"), bad}, Encoding::Utf8));
  }
  CHECK_FALSE(lsp::changed(document, nullptr, Encoding::Utf8));
}

TEST_CASE("a whole text heals the changes before it that do not fit") {
  const auto document = syntax::Document::parse("a\n");
  const Json bad = change(5, 0, 5, 0, "x");
  const Json whole{{"text", "new\n"}};
  for (const Json& healed : {Json{bad, whole}, Json{change(0, 0, 0, 1, "b"), bad, whole}}) {
    const auto after = lsp::changed(document, healed, Encoding::Utf8);
    REQUIRE(after);
    CHECK(after->text() == "new\n");
  }
  CHECK(lsp::changed(document, {bad, whole, change(0, 3, 0, 3, "er")}, Encoding::Utf8)->text() ==
        "newer\n");
  CHECK_FALSE(lsp::changed(document, {whole, bad}, Encoding::Utf8));
}

TEST_CASE("an edit makes only those requests stale that came before it") {
  rpc::Pending pending;
  const auto hover = [](int id) {
    rpc::Message message;
    message.kind = rpc::MessageKind::Request;
    message.id = id;
    message.method = "textDocument/hover";
    message.params = {{"textDocument", {{"uri", "file:///a"}}}};
    return message;
  };
  const std::set<std::string> methods{"textDocument/hover"};
  REQUIRE(pending.begin(hover(1)));
  const auto edit = pending.count();
  REQUIRE(pending.begin(hover(2)));
  const auto stale = pending.about("file:///a", methods, edit);
  REQUIRE(stale.size() == 1);
  CHECK(stale[0].id == 1);
}

TEST_CASE("an edit within a character of two units leaves each half as one unit") {
  const auto after = [](const Json& edit) {
    return lsp::changed(syntax::Document::parse("a😀b\nc"), Json::array({edit}), Encoding::Utf16)
        ->text();
  };
  CHECK(after(change(0, 2, 0, 3, "")) == "a\uFFFDb\nc");
  CHECK(after(change(0, 1, 0, 2, "")) == "a\uFFFDb\nc");
  CHECK(after(change(0, 2, 0, 2, "x")) == "a\uFFFDx\uFFFDb\nc");
  CHECK(after(change(0, 1, 0, 3, "x")) == "axb\nc");
  CHECK(after(change(0, 2, 1, 0, "")) == "a\uFFFDc");
  CHECK(after(change(0, 9, 0, 9, "x")) == "a😀bx\nc");
}
