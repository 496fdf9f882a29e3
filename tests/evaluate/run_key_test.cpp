#include "evaluate/run_key.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "evaluate/digest.h"
#include "evaluate/program_version.h"
#include "tests/terrains/scratch_folder.h"

namespace headland {
namespace {

namespace fs = std::filesystem;

class RunKey : public ScratchFolder {
 protected:
  std::string key(const std::string& name) const {
    ContentDigests digests;
    return run_key(read_scenario(path(name)), digests);
  }

  std::string key_of(const std::string& more, const std::string& seed = "3") const {
    written("one.yaml",
            "field: {boundary: [[0, 0], [30, 0], [30, 20], [0, 20]]}\nseed: " + seed + "\n" + more);
    return key("one.yaml");
  }
};

const std::string kSquare =
    R"({"type": "Polygon", "coordinates": [[[0, 0], [30, 0], [30, 20], [0, 20], [0, 0]]]})";

TEST_F(RunKey, IsTheSameWhereverTheFilesLie) {
  for (const char* folder : {"here", "there"}) fs::create_directory(path(folder));
  const std::string rest = "vehicle: transplanter\nfield: {crs: EPSG:32615, file: ";
  written("here/a.geojson", kSquare);
  written("there/b.geojson", kSquare);
  written("here/s.yaml", "name: this\n" + rest + "a.geojson}\n");
  written("there/t.yaml", "name: that\n" + rest + "b.geojson}\n");
  EXPECT_EQ(key("here/s.yaml"), key("there/t.yaml"));
  EXPECT_EQ(key("here/s.yaml").size(), kDigestDigits);
  written("there/b.geojson", kSquare + " ");
  EXPECT_NE(key("here/s.yaml"), key("there/t.yaml"));
}

TEST_F(RunKey, ChangesWithWhateverDecidesTheRun) {
  const std::string vehicle = "vehicle: transplanter\n";
  const std::set<std::string> keys = {
      key_of(vehicle),
      key_of(vehicle, "4"),
      key_of("vehicle: utility_tractor\n"),
      key_of(vehicle + "soil: tilled\n"),
      key_of(vehicle + "soil: {cone_index_kpa: 1201}\n"),
      key_of(vehicle + "terrain: {generator: rolling}\n"),
      key_of(vehicle + "terrain: {generator: rolling, amplitude_m: 1.7}\n"),
      key_of(vehicle + "planner: {headland_passes: 3}\n"),
      key_of(vehicle + "planner: {name: grid_tplp}\n"),
      key_of(vehicle + "simulation: {rate_hz: 120}\n"),
      key_of(vehicle + "positioning: {noise_m: 0.02}\n"),
      key_of(vehicle + "path: {clearance_m: 0.2}\n"),
      key_of(vehicle + "coverage: {cell_m: 0.5}\n"),
      key_of(vehicle + "implement: {working_width_m: 1.9}\n"),
  };
  EXPECT_EQ(keys.size(), 14U);
  EXPECT_TRUE(keys.contains(key_of(vehicle)));
  EXPECT_TRUE(keys.contains(key_of(vehicle + "coverage: {cell_m: 0.25}\n")));  // the default
}

// By what describes it, not by its name or its pictures.
TEST_F(RunKey, ChangesWithTheVehiclesFiles) {
  const fs::path plain = fs::path(HEADLAND_TEST_DATA) / "vehicles/plain";
  for (const char* folder : {"one", "two"}) {
    fs::copy(plain, path(folder), fs::copy_options::recursive);
  }
  const std::string one = key_of("vehicle: ./one\n");
  EXPECT_EQ(key_of("vehicle: ./two\n"), one);
  written("two/meshes/body.obj", "v 0 0 0\n");
  EXPECT_EQ(key_of("vehicle: ./two\n"), one);
  std::ofstream(path("two/drive.yaml"), std::ios::app) << "# changed\n";
  EXPECT_NE(key_of("vehicle: ./two\n"), one);
}

// A shapefile is several files, and each counts.
TEST_F(RunKey, ReadsWhatGdalReadsAlongWithAFile) {
  const std::string grid =
      "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 1 1\n1 1 1\n1 1 1\n";
  ContentDigests before;
  ContentDigests after;
  written("dem.asc", grid);
  written("dem.prj", "Projection UTM\nZone 15\nDatum WGS84\nUnits METERS\nParameters\n");
  const std::string digest = before.of_file(path("dem.asc"));
  EXPECT_EQ(before.of_file(path("dem.asc")), digest);
  written("dem.prj", "Projection UTM\nZone 16\nDatum WGS84\nUnits METERS\nParameters\n");
  EXPECT_NE(after.of_file(path("dem.asc")), digest);
}

TEST(ProgramVersion, TellsReleaseAndSources) {
  const std::string version(program_version());
  EXPECT_EQ(version.find('+'), version.rfind('.') + 2);
  EXPECT_EQ(version.size() - version.find('+'), 13U);  // 12 hexadecimal digits
}

}  // namespace
}  // namespace headland
