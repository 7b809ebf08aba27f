#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/calibrate/search/judgement.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::calibrate {

/// A finished calibration, ready to be written.
struct Calibration {
    const Scenario& scenario;  ///< of the first site, which has the settings of the search and of the page
    const std::vector<InputFile>& inputs;  ///< of all sites
    const config::Warnings& warnings;
    const std::vector<const SiteCase*>& sites;
    const SharedComponents& shared;
    const Space& space;
    const std::vector<Observation>& observations;  ///< of all sites, one site behind the other
    const std::vector<SightLine>& lines;
    const SearchPlan& plan;
    const SearchState& state;
    const Judgement& judgement;
    std::string version;

    [[nodiscard]] bool has_several_sites() const { return sites.size() > 1; }
    [[nodiscard]] const SiteCase& site_of(const Observation& observation) const {
        return *sites[observation.site];
    }
    /// Names of the sites that a component belongs to; "" where it belongs to all.
    [[nodiscard]] std::string users_of(std::size_t component) const;
};

/// The table that `run.parameters` reads at a site: the sets that were kept, with their weights.
std::string sample_file(const Calibration& calibration, std::size_t site);
/// The scenario of a site with that table.
std::string calibrated_file(const Calibration& calibration, std::size_t site);

/// All tables. Those of the samples are the parameters of the sites.
std::vector<TableLayout> calibration_layouts(const Calibration& calibration);
/// The same without the columns of parameters.
const std::vector<TableLayout>& common_calibration_layouts();
std::vector<WrittenFile> write_tables(const Calibration& calibration, const std::filesystem::path& folder);

/// All figures, settings, warnings and inputs for scripts, as other kinds of runs write them.
void write_summary(std::ostream& out, const Calibration& calibration, const std::vector<WrittenFile>& files);

/// Something observed that alone is further away than 95 % of samples of the model, whatever all together
/// are.
struct FarAlone {
    const Observation& observation;
    std::string use;  ///< "fitted", "held out"; "" of a transfer, which takes both
    double as_far = 0.0;
};
std::vector<FarAlone> far_alone(const Calibration& calibration);
/// The same of what other sites predict for one.
std::vector<FarAlone> far_alone(const Calibration& calibration, const Transfer& transfer);

/// Why the sets may not be called calibrated; "" if they may. An English sentence of messages.csv.
std::string reason_against(const Judgement& judgement, const SearchState& state);

}  // namespace coupling::calibrate
