// Claims on runs: of several programs that share a store, one drives each run.
#pragma once

#include <filesystem>
#include <string>

namespace headland {

// A lock on the file STORE-claims for each run that this program drives. The system takes them back
// when the program ends, however it ends, so that none is ever stale.
class RunClaims {
 public:
  // Throws InputError when the file can be neither made nor opened.
  explicit RunClaims(const std::filesystem::path& store);
  ~RunClaims();
  RunClaims(const RunClaims&) = delete;
  RunClaims& operator=(const RunClaims&) = delete;

  // False when another program has the run. Of one program's threads each must ask for other runs.
  bool claim(const std::string& key);
  void release(const std::string& key);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace headland
