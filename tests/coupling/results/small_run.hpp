#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/run_results.hpp"

namespace coupling::small_runs {

/// The results of a small run, put together by hand: a square of 80 m in cells of 10 m that falls to the
/// south, one source cell in the north, a road across the south, a house, three trees, and rocks as a test
/// adds them.
struct SmallRun {
    std::unique_ptr<Scenario> scenario =
        std::make_unique<Scenario>();  ///< stays in place: its options refer to it
    Site site;
    rockfall::EnsembleTally tally;
    std::array<std::unique_ptr<rockfall::CellHistograms>, rockfall::covers> histograms;
    std::vector<rockfall::PathRecord> paths;
    std::vector<NetRow> net_rows;
    config::Warnings warnings;
    std::uint64_t rocks = 0;
    bool with_forest = true;

    SmallRun();
    /// Counts one passage of a rock through a cell.
    void pass(rockfall::Cover cover, config::Cell cell, float energy_j, float speed_mps, float height_m);
    /// Counts `rocks` falls with arrivals at the road: each tenth on the bare slope, each fortieth with
    /// forest.
    void fall(std::uint64_t count);
    [[nodiscard]] RunResults results() const;
};

/// An empty folder for a test, gone with this object.
class TestFolder {
public:
    TestFolder();
    ~TestFolder();
    TestFolder(const TestFolder&) = delete;
    TestFolder& operator=(const TestFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file);
/// Writes a file, and the folders above it.
void put(const std::filesystem::path& file, const std::string& text);
/// The names in the first line of a CSV text.
std::vector<std::string> columns_of(const std::string& csv);
/// What gdalinfo says about a file; empty where it is not installed.
std::string gdalinfo(const std::filesystem::path& file);

/// ESRI text of EPSG:31287.
extern const char* const austria_lambert;

}  // namespace coupling::small_runs
