#include "evaluate/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "evaluate/atomic_file.h"
#include "evaluate/metrics_file.h"
#include "terrains/input_error.h"
#include "terrains/input_file.h"
#include "tests/evaluate/results_folder.h"
#include "tests/terrains/refusal.h"

namespace headland {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class ResultsTest : public test::ResultsFolder {};

TEST_F(ResultsTest, AFolderInTheWayOfOneFileLeavesAllAsTheyWere) {
  write("a", "old");
  fs::create_directory(folder_ / "b");
  EXPECT_EQ(refusal([&] {
              write_together(folder_, {{"a", "new"}, {"b", "new"}, {"c", "new"}});
            }),
            (folder_ / "b").string() + ": cannot be written: a folder of that name is in the way");
  EXPECT_EQ(read_text(folder_ / "a"), "old");
  EXPECT_EQ(names_in_folder(), (std::set<std::string>{"a", "b"}));
}

TEST_F(ResultsTest, FilesAlreadyReplacedArePutBackWhenALaterOneFails) {
  write("a", "old");
  // Written and then gone: the same partial name twice, so that the second renaming finds nothing.
  EXPECT_THAT(refusal([&] {
                write_together(folder_, {{"a", "new"}, {"n", "new"}, {"n", "new"}});
              }),
              HasSubstr("/n: cannot be written: No such file"));
  EXPECT_EQ(read_text(folder_ / "a"), "old");
  EXPECT_EQ(names_in_folder(), (std::set<std::string>{"a"}));
}

TEST_F(ResultsTest, FoldersMadeForNothingGoAgain) {
  EXPECT_THAT(refusal([&] {
                write_together(folder_ / "x" / "y", {{"n", "new"}, {"n", "new"}});
              }),
              HasSubstr("cannot be written"));
  EXPECT_TRUE(names_in_folder().empty());
}

TEST_F(ResultsTest, AFolderUnderTheNameOfAResultIsRefusedBeforeAnyWork) {
  fs::create_directory(folder_ / kMetricsFile);
  EXPECT_EQ(refusal([&] { check_results_folder(folder_); }),
            (folder_ / kMetricsFile).string() +
                ": cannot be written: a folder of that name is in the way");
}

TEST_F(ResultsTest, AFullDiskLeavesTheOldFilesAndNothingHalfWritten) {
  write("a", "old");
  // The temporary name of the second file leads to a device that is always full.
  fs::create_symlink("/dev/full", folder_ / ".b.partial");
  EXPECT_THAT(
      [&] {
        write_together(folder_, {{"a", "new"}, {"b", "new"}});
      },
      ThrowsMessage<InputError>(AllOf(HasSubstr("b"), HasSubstr("No space left"))));
  EXPECT_EQ(read_text(folder_ / "a"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(ResultsTest, FoldersThatCannotBeAreRefused) {
  write("file", "x");
  EXPECT_THAT([&] { check_output_folder(folder_ / "file"); },
              ThrowsMessage<InputError>(HasSubstr("is not a folder")));
  EXPECT_THAT([&] { check_output_folder(folder_ / "file" / "below"); },
              ThrowsMessage<InputError>(HasSubstr("is not a folder")));
  EXPECT_THAT(
      [&] {
        write_together(folder_ / "file", {{"a", "x"}});
      },
      ThrowsMessage<InputError>(HasSubstr("file")));
  EXPECT_NO_THROW(check_output_folder(folder_ / "new" / "below"));
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

TEST_F(ResultsTest, DoingAStageAgainRemovesWhatFollowed) {
  for (const char* name : {kPathFile, kRunFile, kMetricsFile, kViewPicture, "notes.txt"}) {
    write(name, "x");
  }
  remove_results_from(folder_, kRunFile);
  EXPECT_TRUE(fs::exists(folder_ / kPathFile));
  EXPECT_FALSE(fs::exists(folder_ / kRunFile));
  EXPECT_FALSE(fs::exists(folder_ / kMetricsFile));
  EXPECT_FALSE(fs::exists(folder_ / kViewPicture));
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
}

}  // namespace
}  // namespace headland
