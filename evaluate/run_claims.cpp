#include "evaluate/run_claims.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "terrains/input_error.h"

namespace headland {
namespace {

// One byte of the file, which need not be that long, for each run: the odds that two share one are
// nil, and the later of them would only wait for the other.
struct flock lock_of(const std::string& key, short type) {
  constexpr std::size_t kDigits = 15;  // 60 bits of a file's 63
  constexpr int kHexadecimal = 16;
  struct flock lock {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(std::stoll(key.substr(0, kDigits), nullptr, kHexadecimal));
  lock.l_len = 1;
  return lock;
}

}  // namespace

RunClaims::RunClaims(const std::filesystem::path& store) : file_(store.string() + "-claims") {
  constexpr int kReadWrite = 0666;
  descriptor_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kReadWrite);
  if (descriptor_ >= 0) return;
  throw InputError(file_.string(), "", "",
                   "cannot be written: " + std::generic_category().message(errno));
}

RunClaims::~RunClaims() { ::close(descriptor_); }

bool RunClaims::claim(const std::string& key) {
  struct flock lock = lock_of(key, F_WRLCK);
  if (::fcntl(descriptor_, F_OFD_SETLK, &lock) == 0) return true;
  if (errno == EAGAIN || errno == EACCES) return false;
  throw InputError(file_.string(), "", "",
                   "cannot be locked: " + std::generic_category().message(errno));
}

void RunClaims::release(const std::string& key) {
  struct flock lock = lock_of(key, F_UNLCK);
  ::fcntl(descriptor_, F_OFD_SETLK, &lock);
}

}  // namespace headland
