#include "terrains/input_file.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <cstring>

#include "refusal.h"
#include "scratch_folder.h"

namespace headland {
namespace {

using InputFileTest = ScratchFolder;

TEST_F(InputFileTest, AFileIsReadWhole) {
  const std::string text("a\0b\r\n\xFF", 6);
  EXPECT_EQ(read_text(written("file", text)), text);
  EXPECT_EQ(read_text(written("empty", "")), "");
}

TEST_F(InputFileTest, MissingFilesAndFoldersAreRefused) {
  EXPECT_EQ(refusal([&] { read_text(path("none")); }), path("none").string() + ": no such file");
  EXPECT_EQ(refusal([&] { read_text(path("")); }), path("").string() + ": is a folder, not a file");
  EXPECT_EQ(refusal([&] { require_file_or_folder(path("")); }), "accepted");
}

TEST_F(InputFileTest, APipeASocketAndADeviceAreRefusedAtOnce) {
  const std::string what = ": is a pipe, a socket or a device; a file is needed";
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal([&] { read_text(path("pipe")); }), path("pipe").string() + what);
  EXPECT_EQ(refusal([&] { require_file_or_folder(path("pipe")); }), path("pipe").string() + what);
  EXPECT_EQ(refusal([&] { require_file_or_folder(path("")); }), path("pipe").string() + what);
  EXPECT_EQ(refusal([] { read_text("/dev/zero"); }), "/dev/zero" + what);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = path("socket").string();
  ASSERT_LT(name.size(), sizeof(address.sun_path));
  std::memcpy(address.sun_path, name.c_str(), name.size());
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_EQ(refusal([&] { read_text(name); }), name + what);
  ::close(descriptor);
}

TEST_F(InputFileTest, ALinkThatLeadsToItselfIsRefused) {
  std::filesystem::create_symlink(path("loop"), path("loop"));
  EXPECT_EQ(refusal([&] { read_text(path("loop")); }),
            path("loop").string() + ": cannot be read: Too many levels of symbolic links");
}

}  // namespace
}  // namespace headland
