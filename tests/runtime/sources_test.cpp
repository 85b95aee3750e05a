#include "report/sources.h"
#include "tests/support/texts.h"

#include <catch2/catch.hpp>

#include <map>

using namespace proskill;

namespace {

using Names = std::vector<std::string>;

/// The files that have changed since a trace of a program was made.
Names edited(const OrderedJson& trace, const std::map<std::string, std::string>& now) {
  using Text = std::expected<std::string, std::string>;
  return report::editedSources(trace, [&](const std::string& file) -> Text {
    const auto found = now.find(file);
    if (found == now.end()) return std::unexpected("there is no such file");
    return found->second;
  });
}

} // namespace

TEST_CASE("a trace says which texts it is about") {
  const std::string text = "(defskill m :body ((^ 1)))";
  const auto program = test::programOfText(text);
  const auto name = program.files.front().path.generic_string();
  const OrderedJson trace{{"sources", report::sourcesJson(program)}};
  CHECK(trace["sources"].size() == 1);
  CHECK(edited(trace, {{name, text}}).empty());
  CHECK(edited(trace, {{name, "\xEF\xBB\xBF" + text}}).empty()); // as editors on Windows save it
  CHECK(edited(trace, {{name, text + " "}}) == Names{name});
  CHECK(edited(trace, {}).empty()); // moved, or elsewhere
}

TEST_CASE("of a trace that names very many files, some are compared") {
  OrderedJson trace;
  for (int i = 0; i < 3'000; ++i) trace["sources"]["file" + std::to_string(i)] = "0";
  int read = 0;
  const auto textOf = [&](const std::string&) -> std::expected<std::string, std::string> {
    ++read;
    return "";
  };
  CHECK(report::editedSources(trace, textOf).size() == 1'000);
  CHECK(read == 1'000);
}

TEST_CASE("nothing is known of traces without their texts, or with other members of that name") {
  for (const auto* trace : {"{}", "[]", "3", "null", R"({"sources": 3})", R"({"sources": ["a"]})",
                            R"({"sources": {"a": 3, "b": null}})"})
    CHECK(edited(OrderedJson::parse(trace), {{"a", ""}, {"b", ""}}).empty());
}
