#include "analysis/program/originals.h"

#include <catch2/catch.hpp>

using namespace proskill;
using analysis::Originals;

namespace originals_test {

namespace {

/// The original of the place of a mark, as a comment writes it, or "none".
std::string originalAt(const std::string& text, const std::string& mark) {
  const Originals originals(text);
  const auto* found = originals.at(static_cast<syntax::Offset>(text.find(mark)));
  return found ? toString(*found) : "none";
}

} // namespace

TEST_CASE("a comment says where the list below it comes from") {
  const std::string text = R"(; A comment.
(defsv other :states (A B) :init A)

; The robot drives.
; from trees/a b.xml:12:3 Sequence "x:1:2 y"
(defskill drive
  :success done
  :body
    (; from c:9:1
     (first)
     (second "; from no.xml:1:1 (")
     ; from d.xml:7:5 Action
     ; more
     (third (^ 3))
     break))
(defevent e :effects (other B)) ; from e.xml:1:1 (
(defevent f :effects (other A))
)";
  CHECK(originalAt(text, "other :states") == "none");
  CHECK(originalAt(text, "drive\n") == "trees/a b.xml:12:3 Sequence \"x:1:2 y\"");
  CHECK(originalAt(text, "first") == "c:9:1");
  CHECK(originalAt(text, "second") == "trees/a b.xml:12:3 Sequence \"x:1:2 y\"");
  CHECK(originalAt(text, "^ 3") == "d.xml:7:5 Action");
  CHECK(originalAt(text, "break") == "trees/a b.xml:12:3 Sequence \"x:1:2 y\"");
  CHECK(originalAt(text, "e :effects") == "none");
  CHECK(originalAt(text, "f :effects") == "e.xml:1:1 (");
}

TEST_CASE("other comments name no original") {
  for (const std::string comment :
       {"; from a:0:1 x", "; from a:1 x", "; from a:1:1x", ";from a:1:1", "; from :1:1 x",
        "; From a:1:1 x", "; from a:99999999999:1 x"})
    CHECK(originalAt(comment + "\n(a)", "(a") == "none");
}

TEST_CASE("a text that is damaged has originals as far as it goes") {
  CHECK(originalAt(") ; from a:1:1\n(b (c", "c") == "a:1:1");
  CHECK(originalAt("; from a:1:1", ";") == "none");
  CHECK(originalAt("\"; from a:1:1\n(b)", "(b") == "none");
}

} // namespace originals_test
