// Opening vector files: the part that fields and tracks share.
#pragma once

#include <gdal_priv.h>

#include <filesystem>
#include <string>

namespace headland {

// The file opened for reading by whichever GDAL vector driver knows it. A live GdalScope keeps
// GDAL's messages. Throws InputError naming the file: missing, unreadable, malformed JSON (with
// the line), not a vector format.
GDALDatasetUniquePtr open_vector_file(const std::filesystem::path& file);

// The CRS of a layer as WKT; empty when it has none.
std::string crs_of(const OGRLayer& layer);

}  // namespace headland
