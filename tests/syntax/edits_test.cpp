#include "tests/support/random/random_edits.h"
#include "tests/support/sanitized.h"
#include "tests/syntax/programs.h"

#include <catch2/catch.hpp>

using namespace proskill;
using syntax::Document;
using syntax::Range;

namespace {

/// Everything that a document contains, for comparison.
std::string everything(const Document& document) {
  std::string all = document.dump();
  auto add = [&](Range range) { all += fmt::format(" {}-{}", range.begin, range.end); };
  for (const auto& form : document.forms()) {
    all += fmt::format("\nform {} {} {}", form.node().index(), form.keyword.text, form.name.text);
    for (Range range : {form.range, form.keyword.range, form.name.range, form.comment}) add(range);
    const auto& [calls, labels, parallels] = form.bodyIndexAsRead();
    for (const auto* statements : {&calls, &labels, &parallels})
      for (const auto* each : *statements) add(each->range.moved(form.offset()));
    if (const auto* skill = form.as<syntax::Skill>()) {
      for (const auto& field : skill->fields) add(field.range);
      if (skill->body)
        for (const auto& statement : skill->body->statements) add(statement.range);
    }
  }
  for (Range comment : document.comments()) add(comment);
  for (const auto& region : document.regions()) add(region.range);
  for (std::uint32_t line = 0; line < document.lines().lineCount(); ++line)
    add(document.lines().line(line, document.text()));
  for (const auto& diagnostic : document.diagnostics()) {
    all += "\n" + diagnostic.message;
    add(diagnostic.location.range);
    for (const auto& related : diagnostic.related) add(related.location.range);
    for (const auto& fix : diagnostic.fixes) {
      all += fix.text;
      add(fix.location.range);
    }
  }
  return all;
}

} // namespace

TEST_CASE("after any edit the document equals a fresh parse, and undo restores it") {
  unsigned seed = 1;
  for (const auto& program : test::allPrograms()) {
    test::RandomEdits edits(seed++);
    Document document = Document::parse(program);
    for (int i = 0; i < (test::kSanitized ? 100 : 300); ++i) {
      auto edit = edits.slip(document.text());
      Document edited = document.edit(edit.range, edit.text);
      INFO("edit " << i << " at " << edit.range.begin << "-" << edit.range.end << ": "
                   << edit.text);
      REQUIRE(everything(edited) == everything(Document::parse(edited.text())));

      auto replaced = document.text().substr(edit.range.begin, edit.range.length());
      Range back{edit.range.begin,
                 static_cast<syntax::Offset>(edit.range.begin + edit.text.size())};
      Document undone = edited.edit(back, replaced);
      REQUIRE(undone.text() == document.text());
      REQUIRE(everything(undone) == everything(document));
      // Errors accumulate for a while, then the text is valid again.
      document = edits.pick(12) == 0 ? Document::parse(program) : edited;
    }
  }
}

TEST_CASE("what an edit only moved is read no second time, and is in place when somebody looks") {
  const Document before = Document::parse("(defevent gust :effects (a 2))\n"
                                          "(defskill land :body ((use) (label here)))\n");
  const Document after = before.edit({0, 0}, "; more\n").edit({7, 7}, "\n");
  REQUIRE(after.forms().size() == 2);
  for (std::size_t i : {0u, 1u}) CHECK(after.forms()[i].isSameRead(before.forms()[i]));
  const auto& land = after.forms()[1];
  CHECK(land.offset() == 8);
  CHECK(&land.node() == &land.node());
  const auto& call = land.as<syntax::Skill>()->body->statements.at(0);
  CHECK(after.text().substr(call.range.begin, call.range.length()) == "(use)");
  const auto& asRead = *land.bodyIndexAsRead().calls.at(0);
  CHECK(asRead.range.moved(land.offset()) == call.range);

  const Document back = after.edit({0, 8}, "");
  CHECK(&back.forms()[1].node() == &before.forms()[1].node());
}

TEST_CASE("of several forms in a line the first has the comment above it, also after edits") {
  const std::string comment = "; what it is\n";
  const std::string forms = "(defsv a :init 1 :min 0 :max 2) (defsv b :init 1 :min 0 :max 2)\n";
  const Document with = Document::parse(comment + forms);
  REQUIRE(with.forms().size() == 2);
  CHECK(with.forms()[0].comment == Range{0, 12});
  CHECK(with.forms()[1].comment.empty());
  const auto end = static_cast<syntax::Offset>(comment.size());
  const Document without = with.edit({0, end}, "");
  CHECK(everything(without) == everything(Document::parse(forms)));
  CHECK(everything(without.edit({0, 0}, comment)) == everything(with));
}

TEST_CASE("the names of an edited document live as long as it does") {
  std::optional<Document> first = Document::parse("(defsv a :init 1 :min 0 :max 2)\n"
                                                  "(defevent gust :effects (a 2))\n");
  Document second = first->edit({0, 0}, "; more\n");
  first.reset();
  const auto& gust = std::get<syntax::Event>(second.forms().at(1).node());
  CHECK(gust.name.text == "gust");
  CHECK(second.text().substr(gust.name.range.begin, gust.name.range.length()) == "gust");
}
