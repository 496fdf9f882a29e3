// Keys of runs: the same for the same run, wherever its files lie and whatever it is called.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>

#include "evaluate/scenario.h"

namespace headland {

// Digests of what scenarios name, each read once. For any number of threads.
class ContentDigests {
 public:
  // Of all files that a file or folder consists of, see dataset_files. Throws InputError.
  std::string of_file(const std::filesystem::path& file);
  // Of the files that describe a vehicle. Throws InputError as load_vehicle.
  std::string of_vehicle(const std::string& name_or_folder);

 private:
  template <typename Make>
  std::string known(const std::string& name, Make make);

  std::mutex mutex_;
  std::map<std::string, std::string> digests_;
};

// A digest of everything that decides the run's result: the scenario with every default, the
// contents of its files in place of their names, and the program's version. Its name is no part.
// Throws InputError for a file that cannot be read.
std::string run_key(const Scenario& scenario, ContentDigests& digests);

}  // namespace headland
