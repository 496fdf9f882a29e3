#include "render/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/report_assets.h"

namespace headland {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page(const std::string& title, const std::string& text) {
  return report_html({title, "PASS", {"line"}}, {{"text", text}},
                     {{"a.png", "A <title>", "what \"it\" shows", {1, 1, {9, 8, 7, 255}}}});
}

TEST(ReportPage, TakesTextsForTexts) {
  const std::string html = page("<b>&co", "</script><script>alert(1)</script><!--");
  EXPECT_THAT(html, HasSubstr("<h1>&lt;b&gt;&amp;co</h1>"));
  EXPECT_THAT(html, HasSubstr("alt=\"what &quot;it&quot; shows\""));
  EXPECT_THAT(html, Not(HasSubstr("alert(1)</script>")));
  EXPECT_THAT(html, HasSubstr(R"(\u003c/script>\u003cscript>alert(1))"));
}

TEST(ReportPage, ForbidsItselfToLoadAnything) {
  const std::string html = page("t", "x");
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
  EXPECT_THAT(html, Not(HasSubstr("<link")));
  EXPECT_THAT(html, Not(HasSubstr("<script src")));
  EXPECT_THAT(html, Not(HasSubstr("@import")));
}

TEST(ReportPage, HoldsTheBundleWhole) {
  EXPECT_GT(report_script().size(), 500000U);
  EXPECT_GT(report_style().size(), 10000U);
  EXPECT_THAT(page("t", "x"), HasSubstr(std::string(report_style())));
  // The end tag would end the script.
  EXPECT_EQ(report_script().find("</script"), std::string_view::npos);
}

TEST(ReportPage, IsTheSameAgain) { EXPECT_EQ(page("t", "x"), page("t", "x")); }

}  // namespace
}  // namespace headland
