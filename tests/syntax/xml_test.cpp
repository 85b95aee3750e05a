#include "syntax/text/xml.h"

#include <catch2/catch.hpp>

namespace proskill::syntax {

TEST_CASE("a text in XML is read as it was, and what XML cannot hold is replaced") {
  CHECK(xmlText("a < b && \"c\" > d\n\tend") == "a &lt; b &amp;&amp; &quot;c&quot; &gt; d\n\tend");
  CHECK(xmlText("\r") == "&#13;");
  CHECK(xmlText("a\x01z\xFF\xEF\xBF\xBE") == "a\xEF\xBF\xBDz\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(xmlText("\xC3\xA9 \xF0\x9F\xA4\x96") == "\xC3\xA9 \xF0\x9F\xA4\x96");
}

TEST_CASE("an attribute keeps its line ends and tabs") {
  CHECK(xmlAttribute("a\n\tb\r'<'") == "a&#10;&#9;b&#13;'&lt;'");
}

} // namespace proskill::syntax
