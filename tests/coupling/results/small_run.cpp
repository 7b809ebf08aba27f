#include "tests/coupling/results/small_run.hpp"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::small_runs {
namespace {

using rockfall::Cover;

constexpr config::GridFrame frame_on_terrain{8, 8, 0.0, 0.0, 10.0, 10.0};
constexpr double west_m = 177000.0;
constexpr double south_m = 377000.0;

rockfall::Slope slope() {
    std::vector<rockfall::Vertex> vertices{
        {0.0, 0.0, 1000.0}, {80.0, 0.0, 1000.0}, {80.0, 80.0, 1060.0}, {0.0, 80.0, 1060.0}};
    constexpr std::uint32_t none = rockfall::no_triangle;
    std::vector<rockfall::Triangle> triangles{{{0, 1, 2}, {none, none, 1}}, {{0, 2, 3}, {0, none, none}}};
    rockfall::SurfaceType ground;
    ground.label = "talus";
    return {rockfall::Terrain{{west_m, south_m}, std::move(vertices), std::move(triangles)},
            rockfall::SurfaceMap::uniform(rockfall::SurfaceId{0}),
            {ground}};
}

config::Raster<double> heights(const config::GridFrame& frame) {
    config::Raster<double> raster{frame};
    for (std::size_t i = 0; i < raster.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        raster.values[i] = 1000.0 + 0.75 * (frame.y_centre_m(cell.row) - south_m);
    }
    return raster;
}

Site site() {
    config::GridFrame frame = frame_on_terrain;
    frame.x_west_m = west_m;
    frame.y_south_m = south_m;
    Site made{slope(),
              heights(frame),
              config::Raster<std::uint8_t>{frame, 0},
              austria_lambert,
              frame,
              {},
              {},
              {},
              {},
              {},
              {},
              nullptr};
    made.trees = {{"17", "PIAB", {west_m + 25.0, south_m + 45.0, 32.5, 24.0, 1.0}},
                  {"18", "ABAL", {west_m + 35.0, south_m + 45.0, 61.0, 31.5, 1.0}},
                  {"a,b", "FASY", {west_m + 45.0, south_m + 45.0, 12.0, 9.0, 1.0}}};
    rockfall::ReleaseSource source;
    source.first_m = {30.0, 70.0};
    source.last_m = {40.0, 80.0};
    source.zone = 3;
    source.rocks = 100;
    made.sources = {source};
    rockfall::Target road{
        "road", "Road & <bridge>", false, true, {{{0.0, 15.0}, {40.0, 12.0}, {80.0, 15.0}}}};
    rockfall::Target house{
        "house", "House", true, true, {{{50.0, 2.0}, {60.0, 2.0}, {60.0, 8.0}, {50.0, 8.0}, {50.0, 2.0}}}};
    made.targets = {rockfall::with_bounds(road), rockfall::with_bounds(house)};
    made.inputs = {{"dem", "dem.asc", "0123456789abcdef", 1234}};
    return made;
}

}  // namespace

const char* const austria_lambert =
    "PROJCS[\"MGI_Austria_Lambert\",GEOGCS[\"GCS_MGI\",DATUM[\"D_MGI\",SPHEROID[\"Bessel_1841\",6377397.155,"
    "299.1528128]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]],PROJECTION[\"Lambert_"
    "Conformal_"
    "Conic\"],PARAMETER[\"False_Easting\",400000.0],PARAMETER[\"False_Northing\",400000.0],PARAMETER["
    "\"Central_"
    "Meridian\",13.3333333333333],PARAMETER[\"Standard_Parallel_1\",49.0],PARAMETER[\"Standard_Parallel_2\","
    "46.0],"
    "PARAMETER[\"Latitude_Of_Origin\",47.5],UNIT[\"Meter\",1.0]]";

SmallRun::SmallRun()
    : site{small_runs::site()},
      tally{frame_on_terrain, site.targets.size(), site.trees.size()},
      histograms{std::make_unique<rockfall::CellHistograms>(frame_on_terrain),
                 std::make_unique<rockfall::CellHistograms>(frame_on_terrain)} {
    scenario->file = "small.ini";
    scenario->options = std::make_shared<config::Options>();
    scenario->options->count("run.seed", scenario->run.seed,
                             {.unit = "-", .meaning = "seed of all random numbers", .source = ""});
    scenario->options->number("release.density_kgpm3", scenario->release.density_kgpm3,
                              {.unit = "kg/m3", .meaning = "density of the rocks <dry>", .source = "choice"});
    std::istringstream settings{"[release]\ndensity_kgpm3 = 2500\n"};
    scenario->options->read(settings, "small.ini", {});
    warnings.add("2 trees lie outside the terrain & were left out");
}

void SmallRun::pass(Cover cover, config::Cell cell, float energy_j, float speed_mps, float height_m) {
    const auto index = static_cast<std::uint32_t>(frame_on_terrain.index(cell));
    const rockfall::CellVisit visit{index,    energy_j, speed_mps,
                                    height_m, 0.75F,    cover == Cover::forest ? 1U : 0U};
    rockfall::CellSums& sums = tally.cells[static_cast<std::size_t>(cover)].cells[index];
    sums.add(visit);
    sums.fed_rocks = 100;
    histograms[static_cast<std::size_t>(cover)]->add(visit);
}

void SmallRun::fall(std::uint64_t count) {
    for (std::uint64_t rock = 0; rock < count; ++rock) {
        for (const Cover cover : {Cover::forest, Cover::bare}) {
            const bool forest = cover == Cover::forest;
            const bool reached = rock % (forest ? 40 : 10) == 0;
            rockfall::RockRecord record;
            record.rock = rock;
            record.start_m = {35.0, 75.0, 1056.0};
            record.end_m = {35.0, reached ? 5.0 : 40.0, 1005.0};
            record.reason = forest && !reached ? rockfall::StopReason::tree : rockfall::StopReason::at_rest;
            record.path_m = 60.0;
            record.time_s = 6.0;
            record.max_speed_mps = 12.0 + static_cast<double>(rock % 7);
            record.max_energy_j = 40000.0 + 1000.0 * static_cast<double>(rock % 97);
            record.max_height_m = 1.5;
            record.tree_hits = forest ? static_cast<std::uint32_t>(rock % 4) : 0;
            tally.runs[static_cast<std::size_t>(cover)].add(record);
            if (reached) {
                const float energy_j = 20000.0F + 2000.0F * static_cast<float>(rock % 89);
                tally.targets[0].by_cover[static_cast<std::size_t>(cover)].add(
                    {true, false, 35.0F, 13.0F, energy_j, 0.8F * energy_j, 11.0F, 0.4F});
            }
            for (int row = 0; row < (reached ? 8 : 4); ++row) {
                pass(cover, {3, row}, static_cast<float>(record.max_energy_j), 12.0F, 1.0F);
            }
        }
        tally.targets[0].reached_both += rock % 40 == 0 ? 1U : 0U;
    }
    rocks += count;
    for (rockfall::StemTally& stem : tally.stems) {
        stem.add(
            {static_cast<std::uint32_t>(count / 2), static_cast<std::uint32_t>(count / 8), count * 5000});
    }
    for (const Cover cover : {Cover::forest, Cover::bare}) {
        paths.push_back({0,
                         cover,
                         {{{35.0, 75.0, 1056.0}, 1000.0F, 0.5F},
                          {{36.0, 40.0, 1030.0}, 50000.0F, 1.0F},
                          {{35.0, 5.0, 1004.0}, 400000.0F, 0.0F}}});
    }
}

RunResults SmallRun::results() const {
    return {
        *scenario,   site,     tally,    {with_forest ? histograms[0].get() : nullptr, histograms[1].get()},
        paths,       net_rows, warnings, rocks,
        with_forest, "0.1.0"};
}

TestFolder::TestFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "bannwald_results_XXXXXX").string();
    path_ = mkdtemp(name.data());
}

TestFolder::~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

void put(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream{file, std::ios::binary} << text;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in{file, std::ios::binary};
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> columns_of(const std::string& csv) {
    std::istringstream head{csv.substr(0, csv.find('\n'))};
    std::vector<std::string> columns;
    for (std::string column; std::getline(head, column, ',');) {
        columns.push_back(column);
    }
    return columns;
}

std::string gdalinfo(const std::filesystem::path& file) {
    std::string said;
    FILE* const pipe = popen(("gdalinfo -checksum '" + file.string() + "' 2>&1").c_str(), "r");
    std::array<char, 4096> piece{};
    while (pipe != nullptr && std::fgets(piece.data(), static_cast<int>(piece.size()), pipe) != nullptr) {
        said += piece.data();
    }
    const bool there = pipe != nullptr && pclose(pipe) == 0;
    return there ? said : "";
}

}  // namespace coupling::small_runs
