#include "coupling/assessments/profile/report/profile_page.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/profile/falls/profile_departures.hpp"
#include "coupling/inputs/scenario/profile_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/results/report/deciding.hpp"
#include "coupling/results/report/departures_line.hpp"
#include "coupling/results/report/energy_rates.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/interval_rows.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/templates/page_files.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::profile {
namespace {

using config::j_per_kj;
using config::joined;

using report::escaped;
using report::fixed;
using report::grouped;
using report::page_text;
using report::PageFields;
using report::three_digits;

std::optional<PageFields> departures(const ProfileTally& tally) {
    const std::string ends = ends_on_page(tally);
    if (ends.empty()) {
        return std::nullopt;
    }
    const double share = share_of(tally.left_lower + tally.left_upper, tally.rocks).value;
    return PageFields{{"ends", ends}, {"share", report::percent(share)}};
}

PageFields opening(const ProfileResults& results) {
    const Scenario& scenario = results.scenario;
    const ProfileSite& site = results.site;
    const double length_m = site.last_m() - site.first_m();
    const double drop_m = site.corners.front().height_m - site.corners.back().height_m;
    constexpr double deg_per_rad = 57.295779513082321;
    const std::string rocks = grouped(results.tally.rocks);
    const double stopped = share_of(results.tally.run_out_m.count(), results.tally.rocks).value;
    return {
        {"head", report::page_head(scenario.report, page_text("Rockfall along a profile"))},
        {"file", scenario.file.filename().string()},
        {"tally_rocks", rocks},
        {"run_out_m_mean", fixed(results.tally.run_out_m.mean(), 1)},
        {"run_out_m_deviation", fixed(results.tally.run_out_m.deviation(), 1)},
        {"of_whom", report::of_those_that_stop(stopped, fixed(results.tally.run_out_at_least_m.mean(), 1))},
        {"departures", departures(results.tally)},
        {"profile", scenario.terrain.profile},
        {"length", fixed(length_m, 1)},
        {"drop_m", fixed(drop_m, 1)},
        {"drop_m_length_m", fixed(deg_per_rad * std::atan2(drop_m, length_m), 1)},
        {"corners", grouped(site.corners.size())},
        {"release",
         report::marked(scenario, page_text("at {start_m} m", {{"start_m", report::exact(site.start_m)}}),
                        {"profile.start_m"})},
        {"deciding", report::deciding_facts(scenario, {}, rocks)},
        {"version", results.version},
        {"energies", report::in_page_language(rockfall::what_energies_count())}};
}

std::optional<PageFields> run_out_with_all(const ProfileResults& results) {
    if (!results.intervals || !results.intervals->run_out_mean_m) {
        return std::nullopt;
    }
    const DrawnFigure& mean_m = *results.intervals->run_out_mean_m;
    const std::vector<NamedShare> causes = main_causes(mean_m, results.draws);
    return PageFields{{"run_out", report::interval_in_words(mean_m.of_all, three_digits)},
                      {"has_causes", !causes.empty()},
                      {"causes", main_causes_in_words(mean_m, results.draws)},
                      {"bar", causes.empty() ? "" : report::cause_bar(causes)}};
}

std::string share_in_words(const Share& share) {
    return joined(report::percent(share.value), " (", fixed(100.0 * share.interval.low, 1), " – ",
                  fixed(100.0 * share.interval.high, 1), ")");
}

std::string rates_table(const ProfileResults& results) {
    std::vector<report::EnergyRates> rows;
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        rows.push_back({escaped(results.site.stations[i].name),
                        rates_of(results.tally.stations[i], results.tally.rocks)});
    }
    return report::energy_rates_table(page_text("Station"), rows);
}

std::optional<PageFields> stations(const ProfileResults& results) {
    using namespace rockfall;
    std::vector<PageFields> rows;
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const StationTally& tally = results.tally.stations[i];
        const Spread& energy = tally.energy_j;
        const auto energy_kj = [&](double share) {
            return three_digits(energy.quantile(fine_energy_bins, share) / j_per_kj);
        };
        rows.push_back({{"name", results.site.stations[i].name},
                        {"at", report::exact(results.site.stations[i].distance_m)},
                        {"passing", share_in_words(share_of(energy.moments.count(), results.tally.rocks))},
                        {"energy", three_digits(energy.moments.mean() / j_per_kj)},
                        {"energy_deviation", three_digits(energy.moments.deviation() / j_per_kj)},
                        {"energy_90", energy_kj(0.90)},
                        {"energy_95", energy_kj(0.95)},
                        {"energy_99", energy_kj(0.99)},
                        {"translation", three_digits(tally.translational_j.mean() / j_per_kj)},
                        {"speed", three_digits(tally.speed_mps.moments.mean())},
                        {"speed_95", three_digits(tally.speed_mps.quantile(fine_speed_bins, 0.95))},
                        {"height", three_digits(tally.height_m.moments.mean())},
                        {"height_95", three_digits(tally.height_m.quantile(fine_height_bins, 0.95))}});
    }
    if (rows.empty()) {
        return std::nullopt;
    }
    return PageFields{
        {"rows", rows}, {"rates", rates_table(results)}, {"histograms", charts_at_stations(results)}};
}

std::optional<PageFields> two_intervals(const ProfileResults& results) {
    if (!results.intervals) {
        return std::nullopt;
    }
    report::IntervalRows rows{results.draws};
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const ProfileIntervals::AtStation& at = results.intervals->stations[i];
        rows.add(page_text("Rocks that pass"), at.share, report::percent);
        rows.add(page_text("mean energy, kJ"), at.energy_mean_kj, three_digits);
        rows.add(page_text("95 % of the energies below, kJ"), at.energy_95_kj, three_digits);
        rows.add(page_text("Mean speed, m/s"), at.speed_mean_mps, three_digits);
        rows.add(page_text("95 % of the heights below, m"), at.height_95_m, three_digits);
        rows.end_group(results.site.stations[i].name);
    }
    rows.add(page_text("Mean run-out, m"), results.intervals->run_out_mean_m, three_digits);
    rows.end_group(page_text("All rocks"));
    PageFields fields = std::move(rows).fields();
    fields.push_back({"strata", grouped(results.draws.falls.size())});
    return fields;
}

PageFields key_figures(const ProfileResults& results) {
    using namespace rockfall;
    const ProfileTally& tally = results.tally;
    const auto share = [&](StopReason reason) {
        return share_in_words(share_of(tally.by_reason[static_cast<std::size_t>(reason)], tally.rocks));
    };
    const auto spread = [&](const Spread& s, const LogBins& bins, double unit) {
        return joined(three_digits(s.moments.mean() / unit), " / ",
                      three_digits(s.quantile(bins, 0.90) / unit), " / ",
                      three_digits(s.moments.most() / unit));
    };
    const auto range = [](const Moments& m) {
        return joined(fixed(m.mean(), 1), " / ", fixed(m.least(), 1), " / ", fixed(m.most(), 1));
    };
    return {{"at_rest", share(StopReason::at_rest)},
            {"caught", share(StopReason::caught)},
            {"left", share(StopReason::left_terrain)},
            {"gave_up", share(StopReason::gave_up)},
            {"left_lower", share_in_words(share_of(tally.left_lower, tally.rocks))},
            {"run_out_stopped", range(tally.run_out_m)},
            {"run_out_all", range(tally.run_out_at_least_m)},
            {"largest_speed", spread(tally.max_speed_mps, fine_speed_bins, 1.0)},
            {"largest_energy", spread(tally.max_energy_j, fine_energy_bins, j_per_kj)},
            {"largest_height", spread(tally.max_height_m, fine_height_bins, 1.0)},
            {"mean_speed", three_digits(tally.mean_speed_mps.mean())},
            {"impacts", three_digits(tally.ground_impacts.mean())},
            {"jump", joined(three_digits(tally.jump_length_m.mean()), " / ",
                            three_digits(tally.jump_length_m.most()))}};
}

}  // namespace

void write_page(std::ostream& out, const ProfileResults& results, const std::vector<WrittenFile>& files) {
    const report::WritingLanguage language{results.scenario.report.language};
    const report::NamesOfScenario names_of_scenario{results.scenario};
    const std::vector<std::string> turns = rockfall::sideways_settings();
    const std::set<std::string> set_to_none{turns.begin(), turns.end()};
    const report::PageFrame frame{
        .title = report::page_title(results.scenario.report,
                                    page_text("Rockfall along a profile: {name}",
                                              {{"name", escaped(results.scenario.file.stem().string())}})),
        .version = results.version,
        .scripts = {page_scripts::charts()},
        .style = std::string{report::page_file("profile.css")},
        .before_main = {}};
    report::begin_page(out, frame);
    PageFields fields{{"warnings_link", report::link_to_first_warnings(results.warnings)},
                      {"first_warnings", report::first_warnings(results.warnings)},
                      {"stations", stations(results)},
                      {"two_intervals", two_intervals(results)},
                      {"with_all", run_out_with_all(results)},
                      {"warnings", report::list_of_warnings(results.warnings)},
                      {"settings", report::settings_section(results.scenario,
                                                            [&](const std::string& key) {
                                                                return !plays_no_part(key) ||
                                                                       set_to_none.contains(key);
                                                            })},
                      {"inputs", report::table_of_inputs(results.site.inputs)},
                      {"files", report::table_of_files("", files)},
                      {"citation", report::citation(results.version, results.scenario)}};
    for (const PageFields& part :
         {opening(results), drawing(results), charts_along(results), key_figures(results)}) {
        fields.insert(fields.end(), part.begin(), part.end());
    }
    out << report::filled_template("profile_page.html", fields);
    report::end_page(out, frame);
}

}  // namespace coupling::profile
