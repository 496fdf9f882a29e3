#include "terrains/dataset_files.h"

#include <gdal_priv.h>

#include <algorithm>
#include <memory>

#include "terrains/gdal_scope.h"
#include "terrains/input_file.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

struct FreeList {
  void operator()(char** list) const { CSLDestroy(list); }
};

void add_listed(const fs::path& file, std::vector<fs::path>& files) {
  const GdalScope gdal;
  const GDALDatasetUniquePtr dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (dataset == nullptr) return;  // none of GDAL's: a track or a grid map
  const std::unique_ptr<char*, FreeList> list(dataset->GetFileList());
  if (list == nullptr) return;
  for (char** name = list.get(); *name != nullptr; ++name) {
    if (fs::is_regular_file(*name)) files.emplace_back(*name);
  }
}

}  // namespace

std::vector<fs::path> dataset_files(const fs::path& file) {
  require_file_or_folder(file);
  std::vector<fs::path> files;
  if (fs::is_directory(file)) {
    for (const auto& entry : fs::recursive_directory_iterator(file)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  } else {
    files.push_back(file);
    add_listed(file, files);
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

}  // namespace headland
