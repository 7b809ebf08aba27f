#include "coupling/assessments/decades/decade_results.hpp"

#include <array>
#include <cmath>
#include <numeric>

#include "config/text/language.hpp"
#include "coupling/assessments/decades/decade_layouts.hpp"
#include "coupling/assessments/decades/decision/decision_page.hpp"
#include "coupling/assessments/decades/decision/decision_tables.hpp"
#include "coupling/assessments/decades/decision/verdict.hpp"
#include "coupling/assessments/decades/report/areas/area_maps.hpp"
#include "coupling/assessments/decades/report/decade_page.hpp"
#include "coupling/assessments/decades/report/indicator_table.hpp"
#include "coupling/assessments/decades/report/nais_table.hpp"
#include "coupling/assessments/decades/report/protection.hpp"
#include "coupling/assessments/decades/report/shown_ground.hpp"
#include "coupling/assessments/decades/report/target_profile.hpp"
#include "coupling/assessments/decades/report/where_it_protects.hpp"
#include "coupling/assessments/decades/risk/risk_years_page.hpp"
#include "coupling/assessments/decades/risk/risk_years_table.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/assessments/decades/tables/cuts_made.hpp"
#include "coupling/assessments/decades/tables/fall_tables.hpp"
#include "coupling/assessments/decades/tables/intervention_areas.hpp"
#include "coupling/assessments/decades/tables/nais_years.hpp"
#include "coupling/assessments/decades/tables/patch_maps.hpp"
#include "coupling/assessments/decades/tables/pooled_reduction.hpp"
#include "coupling/assessments/decades/tables/profile_tables.hpp"
#include "coupling/assessments/decades/tables/protection_places.hpp"
#include "coupling/assessments/decades/tables/replicate_draws.hpp"
#include "coupling/assessments/decades/tables/storm_table.hpp"
#include "coupling/assessments/decades/tables/variance_split.hpp"
#include "coupling/assessments/decades/tables/work_tables.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/finish.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"

namespace coupling::decades {
namespace {

/// "years 1981 to 2020, in their order, temperature changed by 2 K, within 50 years".
std::string climate_in_words(const ClimateSource& climate, const std::string& order) {
    std::vector<std::string> texts{
        report::page_text("years {first} to {last}", {{"first", std::to_string(climate.series.first_year())},
                                                      {"last", std::to_string(climate.series.last_year())}}),
        order};
    if (!climate.changes()) {
        return report::join_with_commas(texts);
    }
    const auto mean = [](const std::array<double, 12>& months) {
        return std::accumulate(months.begin(), months.end(), 0.0) / 12.0;
    };
    const double factor = mean(climate.change.precipitation);
    texts.push_back(report::page_text("temperature changed by {kelvin} K",
                                      {{"kelvin", report::fixed(mean(climate.change.temperature_k), 1)}}));
    if (std::abs(factor - 1.0) >= 0.005) {
        texts.push_back(
            report::page_text("precipitation × {factor}", {{"factor", report::fixed(factor, 2)}}));
    }
    if (climate.change_years > 0) {
        texts.push_back(report::page_text(
            climate.change_years == 1 ? "reached within {years} year" : "reached within {years} years",
            {{"years", std::to_string(climate.change_years)}}));
    }
    return report::join_with_commas(texts);
}

/// Which years of which series the forest lived in; of several climates each with its name.
std::string climates_in_words(const ForestSite& forest) {
    const ClimateSource& first = forest.climates.front().source;
    const std::string& order =
        report::page_text(first.order == ClimateOrder::once     ? "in their order"
                          : first.order == ClimateOrder::repeat ? "over and over"
                                                                : "drawn for each replicate");
    if (forest.climates.size() == 1) {
        return climate_in_words(first, order);
    }
    std::vector<std::string> texts;
    for (const SiteClimate& climate : forest.climates) {
        texts.push_back(report::with_label(climate.name, climate_in_words(climate.source, "")));
    }
    texts.push_back(report::page_text("all {order}", {{"order", order}}));
    return report::join_with_semicolons(texts);
}

std::vector<Section> first_sections(const DecadeResults& results, std::span<const Series> series,
                                    const std::optional<forest::TargetProfile>& profile,
                                    std::span<const NaisCell> nais, const std::string& where) {
    std::vector<Section> sections;
    if (results.rocks > 0 && !results.site.targets.empty()) {
        const LowestYears lowest = [&](std::size_t course, const std::string& target) {
            const CourseAtTarget* at =
                results.decision != nullptr ? results.decision->find(course, target) : nullptr;
            return at != nullptr ? at->forest.lowest : std::nullopt;
        };
        sections.push_back(
            {report::page_text("Protection over the years"),
             protection_over_years(results.names, results.site, series, results.members, lowest)});
    }
    if (results.risk != nullptr) {
        sections.push_back({report::page_text("Risk"),
                            risk_over_years_html(results.names, results.site, *results.risk,
                                                 results.scenario.shown(results.scenario.risk.curves))});
    }
    if (!where.empty()) {
        sections.push_back({report::page_text("Where the forest protects"), where});
    }
    if (results.rocks > 0) {
        sections.push_back(
            {report::page_text("Stands against rocks"),
             stands_against_rocks(
                 results.names, series, profile,
                 rockfall::diameter_range(start_law(results.scenario.release), results.site.sources).mean_m),
             results.management == nullptr || results.management->target_profile.empty()});
    }
    if (std::string html = nais_table(results.names, nais); !html.empty()) {
        sections.push_back({report::page_text("Target profiles over time"), std::move(html)});
    }
    sections.push_back({report::page_text(has_protection(series) ? "What the protection rests on"
                                                                 : "Structure, losses and carbon"),
                        indicator_table(results.names, results.site, series)});
    return sections;
}

}  // namespace

std::vector<std::string> verdict_of(const DecadeResults& results) {
    return results.decision != nullptr ? verdict(results.names, *results.decision)
                                       : std::vector<std::string>{};
}

std::vector<WrittenFile> write_results(const DecadeResults& results, const std::filesystem::path& folder,
                                       const WriteWatch& watch) {
    std::vector<WrittenFile> files{
        {"report.html",
         "The results as a page: stands, growth, work and losses over the years, pictures of the forest, "
         "settings."},
        {"summary.json", "Figures of start and end, settings, input hashes and warnings for scripts."}};
    const auto add = [&](const std::vector<WrittenFile>& written) {
        files.insert(files.end(), written.begin(), written.end());
    };
    watch("tables");
    if (results.rocks > 0) {
        add(write_fall_tables(folder, results.names, results.site, results.members));
        add(write_pooled_reductions(folder, results.names, results.site, results.members));
        add(write_variance_splits(folder, results.names, results.site, results.members));
        add(write_protection_by_distance(folder, results.names, results.site, results.members));
        add(write_replicate_draws(folder, results.scenario, results.site));
    }
    add(write_forest_tables(
        folder, results.names, results.members,
        chosen_years(results.scenario.forest.tree_list_years, results.scenario.run.years)));
    add(write_storms(folder, results.scenario, results.site.forest->first_year()));
    watch("tables of work");
    add(write_work_tables(folder, results.names, results.members, results.site.forest->grid.area_ha()));
    watch("rasters of patches");
    {
        const report::WritingLanguage of_legends{results.scenario.report.language};
        add(write_patch_maps(folder, results.names, results.members, results.site.forest->grid,
                             results.site.projection, watch));
        if (results.rocks > 0) {
            add(write_protection_maps(folder, results.names, results.members, results.site.forest->grid,
                                      results.site.projection, watch));
            add(write_fall_maps(folder, results.names, results.site, results.members, watch));
        }
    }
    const std::optional<forest::TargetProfile> profile =
        results.rocks > 0 ? profile_for(results.scenario, results.site) : std::nullopt;
    watch("tables of target profiles");
    add(write_profile_tables(folder, results.names, results.members, profile));
    const forest::PatchGrid& grid = results.site.forest->grid;
    std::vector<NaisCell> nais;
    std::vector<InterventionArea> areas;
    const std::vector<CutMade> cuts = cuts_made(results.names, results.members);
    add(write_cuts_made(folder, results.names, grid, cuts));
    if (results.management != nullptr) {
        nais = nais_over_years(results.names, grid, results.members, results.management->target_profile);
        add(write_nais(folder, results.names, nais));
        areas = intervention_areas(*results.management, *results.site.forest, results.scenario.run.seed);
        add(write_intervention_areas(folder, *results.management, areas,
                                     results.site.forest->first_year() - 1));
    }
    const std::vector<Series> series = series_of(results.names, results.site, results.members, profile);
    watch("comparison");
    add(write_comparison(folder, results.names, series));
    const Decision* decision = results.decision;
    const std::vector<CourseRisk> risks =
        decision != nullptr && results.risk != nullptr
            ? risks_of_courses(results.names, *decision, *results.risk, grid.area_ha())
            : std::vector<CourseRisk>{};
    if (decision != nullptr) {
        add(write_decision(folder, results.names, *decision, series, risks));
    }
    if (results.risk != nullptr) {
        add({write_risk_by_year(folder, results.names, *results.risk)});
    }
    const auto write_page = [&](std::ostream& out, const std::vector<WrittenFile>& written) {
        const report::WritingLanguage language{results.scenario.report.language};
        const report::NamesOfScenario names_of_scenario{results.scenario};
        const report::MapWindow window = shown_ground(results.site, grid, results.members);
        const ProtectingPlaces where =
            results.rocks > 0 ? where_it_protects(results.names, results.site, grid, results.members, window)
                              : ProtectingPlaces{};
        const std::string maps_of_areas = results.management == nullptr
                                              ? ""
                                              : area_maps(results.site, *results.management, areas, window,
                                                          {&results.names, &grid, cuts}, !where.has_maps);
        write_decade_page(
            out,
            {.scenario = results.scenario,
             .names = results.names,
             .grid = grid,
             .members = results.members,
             .warnings = results.warnings,
             .inputs = results.site.inputs,
             .files = written,
             .version = results.version,
             .climate = climates_in_words(*results.site.forest),
             .decision = decision != nullptr
                             ? decision_html(results.names, *decision,
                                             protection_charts(results.names, results.site, series), risks)
                             : "",
             .first = first_sections(results, series, profile, nais, where.html),
             .areas = maps_of_areas,
             .has_maps = where.has_maps || !maps_of_areas.empty(),
             .site = &results.site});
    };
    finish_results(
        folder,
        {.scenario = results.scenario,
         .dictionary = {decade_layouts(), together(raster_columns(), patch_raster_columns())},
         .summary = [&](std::ostream& out, const auto& written) { write_summary(out, results, written); },
         .page = write_page,
         .drawn = &results.site},
        files, watch);
    return files;
}

}  // namespace coupling::decades
