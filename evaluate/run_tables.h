// The tables of a run: run.csv (time series), footprint.csv (where the implement worked) and
// segments.csv (what every stretch of the path cost). One header line; names carry the unit.
// Columns: docs/results.md.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "planner/path.h"
#include "sim/run_record.h"
#include "terrains/geo_frame.h"

namespace headland {

// Columns of run.csv in their order, without the longitude and latitude that follow when the
// field is georeferenced.
std::vector<std::string> run_columns();

std::string run_csv(const std::vector<RunSample>& samples, const GeoFrame& frame);
std::string footprint_csv(const std::vector<FootprintSample>& footprints);
std::string segments_csv(const Path& path, const std::vector<SegmentRecord>& segments);

// The same back, to the decimals written. Columns that are not known are passed over. Throw
// InputError with line, column and value: a missing file or column, a row of another length, no
// finite number in the column's range. Of a run that diverged the segments may hold NaN; its rows
// that are not finite are not written to the other two.
std::vector<RunSample> read_run_csv(const std::filesystem::path& file);
std::vector<FootprintSample> read_footprint_csv(const std::filesystem::path& file);
std::vector<SegmentRecord> read_segments_csv(const std::filesystem::path& file,
                                             bool diverged = false);

// The same into a vector that keeps the rows before a faulty one when InputError is thrown: what
// there is of a table that was cut off.
void read_run_csv(const std::filesystem::path& file, std::vector<RunSample>& samples);
void read_footprint_csv(const std::filesystem::path& file,
                        std::vector<FootprintSample>& footprints);
void read_segments_csv(const std::filesystem::path& file, bool diverged,
                       std::vector<SegmentRecord>& segments);

// Key of an energy cause in files: "rolling_resistance_j".
std::string energy_key(EnergyCause cause);

}  // namespace headland
