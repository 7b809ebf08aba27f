#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "coupling/assessments/compare/compare.hpp"
#include "coupling/assessments/decades/members/bare_part.hpp"
#include "coupling/assessments/decades/members/member_part.hpp"
#include "coupling/assessments/nets/net_trial.hpp"
#include "coupling/program/actions/run_assessment.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/run/checkpoint.hpp"
#include "coupling/run/ranks.hpp"
#include "tests/coupling/inputs/forest_project.hpp"
#include "tests/coupling/results/small_run.hpp"
#include "tests/fuzz/subject.hpp"

namespace fuzz {
namespace {

namespace decades = coupling::decades;
using coupling::ForestProject;
using coupling::SampleProject;
using coupling::small_runs::SmallRun;

constexpr const char* part_hash = "0123456789abcdef";

std::unique_ptr<SampleProject> with_member_part() {
    auto project = std::make_unique<SampleProject>();
    decades::KeptMember kept;
    kept.kept = {2, {0, 2}, {2}};
    kept.end.stand.trees.resize(3);
    kept.end.stand.dead_wood.logs.resize(2);
    kept.end.regime.cuts.resize(2);
    kept.end.regime.cuts[1].area.place.polygons.resize(1);
    kept.end.regime.cuts[1].area.place.polygons[0].parts = {{{0.0, 1.0}, {2.0, 3.0}}};
    decades::MemberYears& years = kept.years;
    years.years.resize(3);
    years.stands.resize(4);
    years.losses.resize(2);
    years.trees.resize(5);
    years.paths.resize(3);
    years.slopes.resize(2);
    years.targets.resize(2);
    years.maps.push_back({2, coupling::Cover::bare, std::vector<rockfall::CellSums>(6)});
    decades::write_part(project->file("member.part"), {part_hash}, kept);
    return project;
}

std::unique_ptr<SampleProject> with_bare_part() {
    auto project = std::make_unique<SampleProject>();
    const SmallRun run;
    coupling::exchange::BareYear year{
        .year = 1, .run = run.tally.runs[0], .targets = {}, .at_targets = {}, .cells = {}, .arrived = {3, 5}};
    year.targets.resize(2);
    year.at_targets.resize(2);
    year.cells.grow_to(6);
    decades::write_bare_part(project->file("bare.part"), {part_hash}, decades::BarePlace{1, 2},
                             std::vector{year, year});
    return project;
}

std::array<rockfall::CellHistograms*, rockfall::covers> histograms_of(const SmallRun& run) {
    return {run.histograms[0].get(), run.histograms[1].get()};
}

std::unique_ptr<SampleProject> with_checkpoint() {
    auto project = std::make_unique<SampleProject>();
    SmallRun run;
    run.fall(40);
    run.pass(rockfall::Cover::bare, {2, 3}, 40000.0F, 12.0F, 1.5F);
    coupling::Checkpoint checkpoint;
    checkpoint.settings_hash = part_hash;
    checkpoint.chunks_done = 3;
    checkpoint.tables = {{100, 7}, {200, 8}};
    checkpoint.gone = {0, 1, 0};
    checkpoint.paths = run.paths;
    checkpoint.net_rows.resize(2);
    coupling::write_checkpoint(project->file("run.part"), checkpoint, run.tally, histograms_of(run));
    return project;
}

void read_checkpoint_back(const SampleProject& project) {
    SmallRun run;
    coupling::checkpoint_hash(project.file("run.part"));
    coupling::read_checkpoint(project.file("run.part"), run.tally, histograms_of(run));
}

/// Runs the scenario of a project into its folder out.
void simulate(const SampleProject& project, const std::vector<std::string>& overrides) {
    coupling::RankGroup alone{coupling::RankGroup::Alone{}};
    coupling::RunRequest request;
    request.scenario = project.file("scenario.ini");
    request.overrides = overrides;
    request.out = project.file("out");
    request.threads = 1;
    request.overwrite = true;
    request.quiet = true;
    if (coupling::run_assessment(request, alone) != 0) {
        throw std::runtime_error{"the run that gives the inputs failed"};
    }
}

std::unique_ptr<SampleProject> run_with_nets() {
    auto project = std::make_unique<SampleProject>();
    project->write("nets.csv",
                   "name,height_m,capacity_kj,wkt\nlower,3,250,\"LINESTRING (1098 2005, 1098 2095)\"\n");
    simulate(*project, {"release.rocks=30", "nets.keep_paths=yes", "output.geopackage=no"});
    return project;
}

void try_the_nets(const SampleProject& project) {
    std::ostringstream out;
    coupling::try_nets({.run = project.file("out"),
                        .nets = project.file("nets.csv"),
                        .out = project.file("tried"),
                        .overwrite = true,
                        .quiet = false},
                       out);
}

/// A second folder to compare with, which stays as it is.
void keep_a_copy(const SampleProject& project) {
    std::filesystem::copy(project.file("out"), project.file("other"),
                          std::filesystem::copy_options::recursive);
}

std::unique_ptr<SampleProject> run_of_today() {
    auto project = std::make_unique<SampleProject>();
    project->write("nets.csv",
                   "name,height_m,capacity_kj,wkt\nlower,3,250,\"LINESTRING (1098 2005, 1098 2095)\"\n");
    simulate(*project, {"release.rocks=200", "nets.file=nets.csv", "output.geopackage=no"});
    keep_a_copy(*project);
    return project;
}

std::unique_ptr<SampleProject> run_over_years() {
    auto project = std::make_unique<ForestProject>();
    simulate(*project, {"trees.file=", "stands.records=records.csv", "run.replicates=2", "run.years=2",
                        "regimes.list=none, pfm1", "release.rocks=50", "output.geopackage=no"});
    keep_a_copy(*project);
    return project;
}

void compare_both(const SampleProject& project) {
    std::ostringstream out;
    coupling::compare::compare_runs({.folders = {project.file("other"), project.file("out")},
                                     .out = project.file("compared.csv"),
                                     .page = project.file("compared.html"),
                                     .overwrite = true,
                                     .quiet = false},
                                    out);
}

}  // namespace

std::vector<Subject> subjects_of_results() {
    return {
        {"parts",
         {"member.part"},
         with_member_part,
         [](const SampleProject& project) {
             decades::read_part(project.file("member.part"), {part_hash}, decades::Member{});
         }},
        {"parts",
         {"bare.part"},
         with_bare_part,
         [](const SampleProject& project) {
             decades::read_bare_part(project.file("bare.part"), {part_hash}, decades::BarePlace{1, 2});
         }},
        {"parts", {"run.part"}, with_checkpoint, read_checkpoint_back},
        {"net_try", {"out/net_paths.bin", "out/summary.json", "nets.csv"}, run_with_nets, try_the_nets},
        {"compare_today",
         {"out/summary.json", "out/tables/targets.csv", "out/tables/runs.csv", "out/tables/run_out.csv",
          "out/tables/target_distributions.csv", "out/tables/nets.csv"},
         run_of_today,
         compare_both},
        {"compare_years",
         {"out/summary.json", "out/tables/protection.csv", "out/tables/targets.csv", "out/tables/stands.csv",
          "out/tables/mortality.csv", "out/tables/forest_years.csv", "out/tables/work_by_year.csv",
          "out/tables/regimes_worst_year.csv", "out/tables/regimes_by_year.csv"},
         run_over_years,
         compare_both},
    };
}

}  // namespace fuzz
