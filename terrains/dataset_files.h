// The files that what a user names consists of.
#pragma once

#include <filesystem>
#include <vector>

namespace headland {

// `file` and, for formats of several files (shapefiles, world and projection files, virtual
// rasters), those that GDAL reads along with it, sorted; of a folder all files in it. Throws
// InputError when `file` is missing or may not be read.
std::vector<std::filesystem::path> dataset_files(const std::filesystem::path& file);

}  // namespace headland
