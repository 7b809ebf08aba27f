#include "coupling/assessments/models/models.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>

#include "config/errors/warnings.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/compare/compare.hpp"
#include "coupling/assessments/hazard/hazard_plan.hpp"
#include "coupling/assessments/models/figures/comparison.hpp"
#include "coupling/assessments/models/page/page.hpp"
#include "coupling/assessments/models/screen.hpp"
#include "coupling/assessments/models/tables.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/figures/read_summary.hpp"
#include "coupling/results/geopackage/results_package.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/short_run.hpp"

namespace coupling::models {
namespace {

using config::joined;

namespace fs = std::filesystem;

constexpr const char* models_kind = "models";
constexpr const char* package_name = "results.gpkg";
constexpr const char* details_folder = "comparison";

bool is_hazard(const ModelsRequest& request) {
    return !request.return_periods_years.empty();
}

/// The folders of a return period, one a model; of a run of today those of the models.
std::vector<fs::path> folders_of(const ModelsRequest& request, double return_period_years) {
    std::vector<fs::path> folders;
    for (const std::string& model : request.models) {
        const fs::path folder = request.folder / model;
        folders.push_back(return_period_years > 0.0 ? folder / hazard::period_folder(return_period_years)
                                                    : folder);
    }
    return folders;
}

/// Below the folder of a model: its page and the summary that stands for all of its run.
fs::path place_of_summary(const ModelsRequest& request, const std::string& model) {
    return is_hazard(request) ? fs::path{model} / hazard::map_folder : fs::path{model};
}

std::vector<double> periods_of(const ModelsRequest& request) {
    return is_hazard(request) ? request.return_periods_years : std::vector{0.0};
}

Comparison comparison_of(const ModelsRequest& request) {
    Comparison comparison{request.models, {}, {}, FieldVerdicts{request.models}};
    for (const double years : periods_of(request)) {
        const std::vector<ModelFigure> figures = read_figures(folders_of(request, years), years);
        comparison.figures.insert(comparison.figures.end(), figures.begin(), figures.end());
    }
    if (is_hazard(request)) {
        std::vector<fs::path> maps;
        for (const std::string& model : request.models) {
            maps.push_back(request.folder / place_of_summary(request, model));
        }
        comparison.levels = read_levels(maps);
    }
    return comparison;
}

/// The summary of each run as an input; its name is relative to the folder.
std::vector<InputFile> summaries_of(const ModelsRequest& request) {
    std::vector<InputFile> inputs;
    for (const std::string& model : request.models) {
        const fs::path name = place_of_summary(request, model) / "summary.json";
        const FileBytes bytes = open_file(request.folder / name, {name.string()}, "a summary");
        inputs.push_back({joined("run ", model), name.generic_string(), bytes.hash(), bytes.stored_bytes()});
    }
    return inputs;
}

/// The warnings of all runs, each behind the names of the models that have it.
std::vector<std::string> warnings_of_runs(const ModelsRequest& request) {
    std::vector<std::pair<std::string, std::string>> entries;  // sentence, models
    for (const std::string& model : request.models) {
        const fs::path file = request.folder / place_of_summary(request, model) / "summary.json";
        const SummaryOfRun summary =
            read_summary(open_file(file, {file.string()}, "a summary").text(), file.string());
        for (const std::string& sentence : summary.warnings) {
            const auto known = std::find_if(entries.begin(), entries.end(),
                                            [&](const auto& entry) { return entry.first == sentence; });
            if (known == entries.end()) {
                entries.emplace_back(sentence, model);
            } else {
                known->second += joined(", ", model);
            }
        }
    }
    std::vector<std::string> warnings;
    for (const auto& [sentence, models] : entries) {
        warnings.push_back(joined(models, ": ", sentence));
    }
    return warnings;
}

/// Distributions and maps side by side, of each return period of a hazard map.
std::vector<LinkedPage> write_details(const ModelsRequest& request, std::ostream& screen) {
    std::vector<LinkedPage> pages;
    for (const double years : periods_of(request)) {
        const fs::path name =
            years > 0.0 ? fs::path{details_folder} / hazard::period_folder(years) : fs::path{details_folder};
        compare::compare_runs({.folders = folders_of(request, years),
                               .out = request.folder / name,
                               .page = {},
                               .overwrite = true,  // it follows from the runs: an earlier one is out of date
                               .quiet = true},
                              screen);
        pages.push_back({(name / "report.html").generic_string(), years});
    }
    return pages;
}

/// Targets, nets and sources of the scenario as layers, the tables beside them.
void write_layers(const ModelsRequest& request, ShortRun& results,
                  std::vector<std::pair<WrittenFile, fs::path>> tables) {
    config::Warnings repeated;  // the runs printed them
    std::unique_ptr<Scenario> of_period;
    if (is_hazard(request)) {
        of_period = hazard::scenario_of(request.run.scenario, request.run.overrides,
                                        request.return_periods_years.back(), request.run.inputs_within);
    }
    const Site site = open_site(of_period ? *of_period : request.scenario, repeated);
    geopackage::write_package(
        results.path(),
        {.site = site, .layouts = models_layouts(), .tables = std::move(tables), .paths = {}});
    results.add_written({package_name, geopackage::package_sentence});
}

/// What a script asks first: how many models, how many figures they share, on how many they disagree.
Json figures_in_short(const Comparison& comparison) {
    std::size_t ranges = 0;
    std::size_t disagree = 0;
    for (const ModelFigure& figure : comparison.figures) {
        const auto range = range_over(figure);
        ranges += range ? 1 : 0;
        disagree += range && range->agreement == Agreement::disagree ? 1 : 0;
    }
    return {{"figures", comparison.figures.size()}, {"ranges", ranges}, {"models_disagree", disagree}};
}

ShortSummary summary_of_models(const ModelsRequest& request, const Comparison& comparison,
                               std::vector<std::string> warnings) {
    const Scenario& scenario = request.scenario;
    return {.kind = models_kind,
            .run = {{"scenario", scenario.file.filename().string()},
                    {"models", request.models},
                    {"overrides", scenario.shown_overrides()},
                    {"seed", scenario.run.seed},
                    {"return_periods_years", request.return_periods_years}},
            .figures = figures_in_short(comparison),
            .inputs = summaries_of(request),
            .warnings = std::move(warnings),
            .excel_decimal = scenario.output.gis.csv == CsvForm::excel
                                 ? std::optional{config::decimal_sign(scenario.report.language)}
                                 : std::nullopt};
}

}  // namespace

void look_at_models_folder(const fs::path& folder) {
    ShortRun::look_at(folder, models_kind,
                      {"models.csv", "model_ranges.csv", "model_levels.csv", "report.html", package_name},
                      true);
}

void put_side_by_side(const ModelsRequest& request, std::ostream& screen) {
    const InterruptGuard until_written;
    const Comparison comparison = comparison_of(request);
    const std::vector<std::string> warnings = warnings_of_runs(request);
    PageContext context{request.scenario, warnings, {}, write_details(request, screen)};
    for (const std::string& model : request.models) {
        context.runs.push_back({(place_of_summary(request, model) / "report.html").generic_string()});
    }
    std::ostringstream page;  // made before any file is
    write_page(page, comparison, context);

    ShortRun results{request.folder};
    std::vector<std::pair<WrittenFile, fs::path>> tables;
    const auto add_table = [&](const char* name, const char* sentence, auto write) {
        results.add(name, sentence, [&](std::ostream& rows) { write(rows, comparison); });
        tables.emplace_back(WrittenFile{name, sentence}, results.path() / name);
    };
    add_table("models.csv", "Each figure under each motion model, with intervals and what judges it.",
              write_models);
    add_table("model_ranges.csv", "Each figure's range over the motion models, and whether they disagree.",
              write_ranges);
    if (is_hazard(request)) {
        add_table("model_levels.csv", "The level at each target under each motion model.", write_levels);
    }
    if (request.scenario.output.gis.geopackage) {
        write_layers(request, results, tables);
    }
    results.add("report.html", "The motion models side by side as a page.",
                [&](std::ostream& out) { out << page.view(); });
    std::vector<TableLayout> layouts = models_layouts();
    if (!is_hazard(request)) {
        layouts.pop_back();
    }
    results.publish(summary_of_models(request, comparison, warnings), layouts);
    if (!request.run.quiet) {
        print_ranges(screen, comparison);
        screen << "Results in " << request.folder.string() << ": report.html, models.csv, model_ranges.csv\n";
    }
}

}  // namespace coupling::models
