#include "coupling/assessments/collapse/collapse_site.hpp"
#include "tests/fuzz/subject.hpp"

namespace fuzz {
namespace {

using coupling::SampleProject;

/// Reads all that a collapse of the scenario would read, and cuts the blocks.
void read_rock_mass(const SampleProject& project) {
    config::Warnings warnings;
    const auto scenario = coupling::collapse::read_collapse(project.file("scenario.ini"), {});
    coupling::collapse::open_collapse(*scenario, warnings);
}

constexpr const char* of_any_mass =
    "[run]\nseed = 1\n[terrain]\ndem = dem.asc\nground = coarse_debris\n[targets]\nfile = targets.csv\n"
    "[collapse]\nleast_block_m = 2\nstrength_factor = 0.1\n";

/// Between joints, below a polygon.
std::unique_ptr<SampleProject> jointed() {
    auto project = std::make_unique<SampleProject>();
    project->write("scenario.ini", std::string{of_any_mass} +
                                       "source = source.csv\ndepth_m = 8\nblocks = joints\n"
                                       "joint_sets = joints.csv\n");
    project->write("source.csv",
                   "wkt\n\"POLYGON ((1030 2040, 1050 2040, 1050 2060, 1030 2060, 1030 2040))\"\n");
    project->write("joints.csv",
                   "name,dip_deg,dip_direction_deg,spacing_m,spacing_law,spacing_deviation_m,persistence,"
                   "tensile_mpa,shear_mpa\n"
                   "bedding,42,93,6,uniform,0.8,0.9,1,2\nsteep,80,95,6,lognormal,0.8,0.7,,\n"
                   "across,85,5,6.5,,,,,\n");
    return project;
}

/// Voronoi cells in a closed surface, of which single ones go on alone.
std::unique_ptr<SampleProject> celled() {
    auto project = std::make_unique<SampleProject>();
    project->write("scenario.ini", std::string{of_any_mass} +
                                       "mesh = body.ply\nblocks = voronoi\nblock_size_m = 5\n"
                                       "persistence = 0.5\nhand_over = rigid\n");
    project->write("body.ply",
                   "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                   "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
                   "1030 2040 360\n1046 2040 360\n1030 2056 360\n1030 2040 400\n"
                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
    return project;
}

}  // namespace

std::vector<Subject> subjects_of_collapse() {
    return {{"jointed", {"scenario.ini", "source.csv", "joints.csv"}, jointed, read_rock_mass},
            {"celled", {"scenario.ini", "body.ply"}, celled, read_rock_mass}};
}

}  // namespace fuzz
