#include "coupling/assessments/calibrate/calibration_results.hpp"

#include <cmath>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/calibrate/outcome/calibrated_scenario.hpp"
#include "coupling/assessments/calibrate/report/calibration_page.hpp"
#include "coupling/results/finish.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// Comment lines of calibrated.ini of a site: what the word is worth.
std::string opening_of(const Calibration& calibration, std::size_t site) {
    const Judgement& judgement = calibration.judgement;
    const std::string reason = reason_against(judgement, calibration.state);
    std::string text = joined(
        "# Written by bannwald calibrate from ", calibration.sites[site]->scenario.file.filename().string(),
        ".\n# ",
        judgement.is_calibrated
            ? joined("Calibrated on ", std::to_string(number_of(calibration.observations, &Observation::fit)),
                     " observations; ", std::to_string(judgement.held_out), " that were held out agree.")
            : joined("Not calibrated: ", reason),
        "\n# Median factors, with 5 and 95 %:\n");
    if (calibration.has_several_sites()) {
        text += joined("# At this site (", calibration.sites[site]->name, "), of ",
                       std::to_string(calibration.sites.size()), " sites that were fitted together:\n");
    }
    for (const std::size_t place : calibration.shared.places[site]) {
        const Learned& learned = judgement.parameters[place];
        const auto digits = [](double value) { return config::to_text(std::round(1e3 * value) / 1e3); };
        text += joined("#   ", learned.component.parameter, " ", digits(learned.median), " (",
                       digits(learned.low), " to ", digits(learned.high), ")\n");
    }
    return text;
}

}  // namespace

std::vector<WrittenFile> write_results(const Calibration& calibration, const std::filesystem::path& folder,
                                       const std::filesystem::path& final_folder, const WriteWatch& watch) {
    std::vector<WrittenFile> files{
        {"report.html", "The calibration as a page: verdict, observed beside predicted, what was learned."},
        {"summary.json", "All figures, settings, input hashes and warnings for scripts."}};
    for (std::size_t site = 0; site < calibration.sites.size(); ++site) {
        const std::string file = calibrated_file(calibration, site);
        files.push_back({file, "The scenario with the sets that were kept: `bannwald run` takes it."});
        OutFile scenario{folder / file};
        scenario.stream() << calibrated_scenario(calibration.sites[site]->scenario, final_folder,
                                                 joined("tables/", sample_file(calibration, site)),
                                                 opening_of(calibration, site));
        scenario.close();
    }
    const std::vector<WrittenFile> tables = write_tables(calibration, folder);
    files.insert(files.end(), tables.begin(), tables.end());
    finish_results(
        folder,
        {.scenario = calibration.scenario,
         .dictionary = {calibration_layouts(calibration), {}},
         .summary = [&](std::ostream& out, const auto& written) { write_summary(out, calibration, written); },
         .page = [&](std::ostream& out, const auto& written) { write_page(out, calibration, written); }},
        files, watch);
    return files;
}

}  // namespace coupling::calibrate
