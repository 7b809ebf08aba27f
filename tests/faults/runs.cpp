#include "tests/faults/runs.hpp"

#include "tests/coupling/inputs/forest_project.hpp"

namespace faults {
namespace {

using coupling::ForestProject;
using coupling::SampleProject;

/// Only so many of the four sources: each is a piece of work of its own where many rocks start from it.
std::unique_ptr<SampleProject> with_sources(int count) {
    auto project = std::make_unique<SampleProject>();
    project->write("source.asc", SampleProject::header() + SampleProject::rows([&](int column, int row) {
                                     return column == 2 && row >= 3 && row < 3 + count ? "1" : "0";
                                 }));
    return project;
}

std::unique_ptr<SampleProject> with_three_sources() {
    return with_sources(3);
}

std::unique_ptr<SampleProject> with_forest() {
    return std::make_unique<ForestProject>();
}

std::unique_ptr<SampleProject> with_blocks() {
    auto project = with_sources(2);
    project->write("blocks.csv", "return_period_years,zone,diameter_m\n30,1,0.5\n300,1,1.2\n");
    project->replace("scenario.ini", "diameter_m = 0.5\n", "");
    project->replace("scenario.ini", "[targets]", "[hazard]\nblocks = blocks.csv\n[targets]");
    return project;
}

std::unique_ptr<SampleProject> with_nets() {
    auto project = with_sources(2);
    project->write("nets.csv",
                   "name,height_m,capacity_kj,wkt\nshort,3,50,\"LINESTRING (1098 2030, 1098 2060)\"\n");
    return project;
}

std::vector<std::string> run_with(const std::vector<std::string>& settings) {
    std::vector<std::string> words{"run", "scenario.ini", "--quiet", "--threads", "1", "--out", "out"};
    for (const std::string& setting : settings) {
        words.insert(words.end(), {"--set", setting});
    }
    return words;
}

}  // namespace

const std::vector<Run>& all_runs() {
    // 550 rocks a source are more than fit with those of another into one piece of work.
    // Percentiles and layers for GIS where they are needed: each file is some more operations of the same
    // kind.
    static const std::vector<Run> runs{
        {"static",
         "three parts",
         {"checkpoint.part"},
         run_with({"release.rocks=1650", "run.rocks_per_part=500", "output.sample_paths=20",
                   "output.percentiles=no"}),
         with_three_sources},
        {"years",
         "four members",
         {"bare_", "member_"},
         run_with({"trees.file=", "stands.records=records.csv", "run.replicates=2", "climate.sequence=random",
                   "regimes.list=none, single_tree_selection", "release.rocks=200", "run.rockfall_every=2",
                   "output.map_years=4", "output.percentiles=no", "output.geopackage=no"}),
         with_forest},
        {"hazard",
         "two return periods of two parts",
         {"checkpoint.part"},
         run_with({"release.rocks=1100", "run.rocks_per_part=500", "output.sample_paths=20",
                   "output.percentiles=no", "hazard.rule=release", "hazard.energy=max",
                   "output.geopackage=no"}),
         with_blocks},
        {"nets",
         "two parts, paths kept",
         {"checkpoint.part"},
         run_with({"release.rocks=1100", "run.rocks_per_part=500", "output.sample_paths=20",
                   "nets.file=nets.csv", "nets.keep_paths=yes", "output.percentiles=no",
                   "output.geopackage=no", "output.geotiff=yes", "output.vtp=yes"}),
         with_nets}};
    return runs;
}

}  // namespace faults
