#include "evaluate/run_key.h"

#include <fmt/format.h>

#include <array>
#include <fstream>

#include "evaluate/digest.h"
#include "evaluate/program_version.h"
#include "terrains/dataset_files.h"
#include "terrains/input_error.h"
#include "vehicle_models/vehicle_loader.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

void add_content(Digest& digest, const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 1U << 16U> block{};
  // What a file is to its dataset its ending tells; its length parts it from the next.
  add(digest, file.extension().string() + "\n");
  std::uintmax_t length = 0;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    const auto read = static_cast<std::size_t>(stream.gcount());
    add(digest, {block.data(), read});
    length += read;
  }
  if (stream.bad() || !stream.eof()) throw InputError(file.string(), "", "", "cannot be read");
  add(digest, fmt::format("\n{}\n", length));
}

}  // namespace

template <typename Make>
std::string ContentDigests::known(const std::string& name, Make make) {
  const std::scoped_lock lock(mutex_);
  const auto [entry, is_new] = digests_.try_emplace(name);
  if (!is_new) return entry->second;
  try {
    return entry->second = make();
  } catch (...) {
    digests_.erase(entry);
    throw;
  }
}

std::string ContentDigests::of_file(const fs::path& file) {
  return known("file " + file.string(), [&] {
    Digest digest;
    for (const fs::path& part : dataset_files(file)) add_content(digest, part);
    return hexadecimal(digest);
  });
}

std::string ContentDigests::of_vehicle(const std::string& name_or_folder) {
  return known("vehicle " + name_or_folder, [&] {
    const fs::path folder = load_vehicle(name_or_folder).folder;
    Digest digest;
    // Meshes are for pictures alone.
    for (const char* part : {"vehicle.urdf", "drive.yaml"}) add_content(digest, folder / part);
    return hexadecimal(digest);
  });
}

std::string run_key(const Scenario& scenario, ContentDigests& digests) {
  Scenario content = scenario;
  content.name.clear();
  for (fs::path* file :
       {&content.field.file, &content.field.grid_map, &content.terrain.file, &content.soil.file,
        &content.path_file, &content.planner.cost_file, &content.planner.predict_file}) {
    // As if they lay in the root: the folder the program runs in is no part of the run.
    if (!file->empty()) *file = fs::path("/") / digests.of_file(*file);
  }
  content.vehicle = digests.of_vehicle(scenario.vehicle);
  return digest_of(std::string(program_version()) + "\n" + scenario_yaml(content));
}

}  // namespace headland
