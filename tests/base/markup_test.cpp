#include "base/markup.hpp"

#include <doctest/doctest.h>

using namespace trilith;

TEST_CASE("text in HTML and XML keeps its meaning in elements and in attributes of both quotes") {
  CHECK(markup_text("a<b> & \"c\" 'd'\n") == "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;\n");
  CHECK(markup_text("&amp;") == "&amp;amp;");
  CHECK(markup_text("θ") == "θ");
  CHECK(markup_text("").empty());
}
