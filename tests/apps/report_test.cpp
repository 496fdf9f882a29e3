// headland report from end to end; what the page does is tested in web/test.
#include <gmock/gmock.h>

#include "tests/apps/command.h"

namespace headland {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ReportTest : public CommandTest {
 protected:
  void drive() const {
    ASSERT_LE(headland("evaluate tiny.yaml --size 640x400 -o A -q").exit_code, 1);
  }

  std::string refused(const std::string& arguments) const {
    const CommandResult result = headland("report " + arguments);
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(result.out, "");
    return result.err;
  }
};

TEST_F(ReportTest, IsMadeOfTheFolderAlone) {
  drive();
  const std::string page = text_of(folder_ / "A" / "report.html");
  EXPECT_THAT(page.substr(0, 100), StartsWith("<!doctype html>"));
  ASSERT_EQ(headland("report A").out, "A/report.html\n");
  EXPECT_TRUE(text_of(folder_ / "A" / "report.html") == page);
  ASSERT_EQ(headland("report A -o elsewhere/page.html --json").exit_code, 0);
  EXPECT_TRUE(text_of(folder_ / "elsewhere" / "page.html") == page);
}

TEST_F(ReportTest, TellsWhatIsMissing) {
  drive();
  const std::string run = text_of(folder_ / "A" / "run.csv");
  write("A/run.csv", run.substr(0, run.size() / 2));
  fs::remove(folder_ / "A" / "view.png");
  write("A/field.png", text_of(folder_ / "A" / "field.png").substr(0, 2000));
  const CommandResult told = headland("report A -q");
  EXPECT_EQ(told.exit_code, 0);
  EXPECT_THAT(told.err, HasSubstr("headland: The time series ends after"));
  EXPECT_THAT(told.err, HasSubstr("headland: The picture view.png is missing"));
  EXPECT_THAT(told.err, HasSubstr("headland: The picture field.png is missing"));
  const std::string page = text_of(folder_ / "A" / "report.html");
  EXPECT_THAT(page, HasSubstr("The time series ends after"));
  EXPECT_THAT(page, HasSubstr("The picture view.png is missing"));
}

TEST_F(ReportTest, RefusesFoldersThatAreNone) {
  EXPECT_THAT(refused("nowhere"), HasSubstr("nowhere: no such folder"));
  EXPECT_THAT(refused("tiny.yaml"), HasSubstr("tiny.yaml: no folder"));
  fs::create_directory(folder_ / "empty");
  EXPECT_THAT(refused("empty"), HasSubstr("neither scenario.yaml of a run nor compare.json of a "
                                          "comparison nor tune.json of a tuning"));
  ASSERT_EQ(headland("plan tiny.yaml -o planned -q").exit_code, 0);
  EXPECT_THAT(refused("planned"), HasSubstr("'headland drive' or 'headland evaluate' writes it"));
  fs::create_directory(folder_ / "other");
  write("other/compare.json", "{\"runs\": []}");
  EXPECT_THAT(refused("other"), HasSubstr("'headland compare' writes such a file"));
  fs::create_directory(folder_ / "tuned");
  write("tuned/tune.json", "{\"name\": \"x\"}");
  EXPECT_THAT(refused("tuned"), HasSubstr("'headland tune' writes such a file"));
  for (const char* folder : {"empty", "planned", "other", "tuned"}) {
    EXPECT_FALSE(fs::exists(folder_ / folder / "report.html"));
  }
}

TEST_F(ReportTest, RefusesPlacesThatCannotBeWritten) {
  drive();
  EXPECT_THAT(refused("A -o tiny.yaml/page.html"), HasSubstr("is not a folder"));
  fs::create_directory(folder_ / "way.html");
  EXPECT_THAT(refused("A -o way.html"), HasSubstr("a folder of that name is in the way"));
  EXPECT_THAT(refused("A -o /proc/page.html"), HasSubstr("cannot"));
}

TEST_F(ReportTest, AComparisonHasOne) {
  write("compare.yaml",
        "repeats: 2\nmaps: [{name: made up, generator: {columns: 5, rows: 5}}]\n"
        "planners: [{name: grid_boustrophedon}]\nstop: {evaluations: 100}\n");
  ASSERT_EQ(headland("compare compare.yaml -o C -q").exit_code, 0);
  const std::string page = text_of(folder_ / "C" / "report.html");
  EXPECT_THAT(page, HasSubstr("data-picture=\"plans_made_up.png\""));
  ASSERT_EQ(headland("report C -q").exit_code, 0);
  EXPECT_TRUE(text_of(folder_ / "C" / "report.html") == page);
}

}  // namespace
}  // namespace headland
