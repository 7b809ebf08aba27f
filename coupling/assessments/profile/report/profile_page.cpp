#include "coupling/assessments/profile/report/profile_page.hpp"

#include <algorithm>
#include <cmath>

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
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/report/page_frame.hpp"
#include "coupling/results/report/page_head.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "coupling/results/text/writing_language.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::profile {
namespace {

using config::j_per_kj;
using config::joined;

using report::escaped;
using report::fact;
using report::fixed;
using report::grouped;
using report::HtmlTable;
using report::three_digits;

std::string opening(const ProfileResults& results) {
    const Scenario& scenario = results.scenario;
    const ProfileSite& site = results.site;
    const double length_m = site.last_m() - site.first_m();
    const double drop_m = site.corners.front().height_m - site.corners.back().height_m;
    constexpr double deg_per_rad = 57.295779513082321;
    std::string html = joined(
        report::page_head(scenario.report, report::page_text("Rockfall along a profile")),
        "<p class=\"lead\">",
        report::page_text(
            "Scenario <b>{file}</b>: {tally_rocks} rocks fell along one profile, in two dimensions: nothing "
            "turns them sideways and there are no trees. Mean run-out <b>{run_out_m_mean} m</b> in plan, "
            "standard deviation {run_out_m_deviation} m, {of_whom}.",
            {{"file", escaped(scenario.file.filename().string())},
             {"tally_rocks", grouped(results.tally.rocks)},
             {"run_out_m_mean", fixed(results.tally.run_out_m.mean(), 1)},
             {"run_out_m_deviation", fixed(results.tally.run_out_m.deviation(), 1)},
             {"of_whom",
              report::of_those_that_stop(share_of(results.tally.run_out_m.count(), results.tally.rocks).value,
                                         fixed(results.tally.run_out_at_least_m.mean(), 1))}}),
        "</p>\n", report::first_warnings(results.warnings), departures_line(results.tally),
        "<dl class=\"facts\">");
    html += fact(report::page_text("Profile"), escaped(scenario.terrain.profile));
    html += fact(report::page_text("Length in plan"), joined(fixed(length_m, 1), " m"));
    html +=
        fact(report::page_text("Drop"),
             report::page_text("{drop_m} m, {drop_m_length_m}° on average",
                               {{"drop_m", fixed(drop_m, 1)},
                                {"drop_m_length_m", fixed(deg_per_rad * std::atan2(drop_m, length_m), 1)}}));
    html += fact(report::page_text("Corners"), grouped(site.corners.size()));
    html +=
        fact(report::page_text("Release"),
             report::marked(scenario,
                            report::page_text("at {start_m} m", {{"start_m", report::exact(site.start_m)}}),
                            {"profile.start_m"}));
    html += report::deciding_facts(scenario, {}, grouped(results.tally.rocks));
    return joined(html,
                  fact(report::page_text("Program"),
                       report::page_text("Bannwald {version}", {{"version", escaped(results.version)}})),
                  "</dl>\n");
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
    return report::energy_rates_table(report::page_text("Station"), rows);
}

std::string stations(const ProfileResults& results) {
    if (results.site.stations.empty()) {
        return joined("<h2>", report::page_text("Stations"), "</h2>\n<p>",
                      report::page_text("None given (profile.stations_m, profile.stations)."), "</p>\n");
    }
    using namespace rockfall;
    HtmlTable table{
        report::page_text("Energy counts {energies}; height is that of the underside above ground, vertical.",
                          {{"energies", report::in_page_language(rockfall::what_energies_count())}}),
        {report::page_text("Station"), report::page_text("at, m"),
         report::page_text("rocks that pass (95 % interval)"), report::page_text("energy, kJ: mean"),
         report::page_text("sd"), "90 %", "95 %", "99 %", report::page_text("translation alone, kJ: mean"),
         report::page_text("speed, m/s: mean"), report::page_text("speed 95 %"),
         report::page_text("height, m: mean"), report::page_text("height 95 %")}};
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const StationTally& tally = results.tally.stations[i];
        const auto energy_kj = [&](double share) {
            return three_digits(tally.energy_j.quantile(fine_energy_bins, share) / j_per_kj);
        };
        table.row({escaped(results.site.stations[i].name), report::exact(results.site.stations[i].distance_m),
                   share_in_words(share_of(tally.energy_j.moments.count(), results.tally.rocks)),
                   three_digits(tally.energy_j.moments.mean() / j_per_kj),
                   three_digits(tally.energy_j.moments.deviation() / j_per_kj), energy_kj(0.90),
                   energy_kj(0.95), energy_kj(0.99), three_digits(tally.translational_j.mean() / j_per_kj),
                   three_digits(tally.speed_mps.moments.mean()),
                   three_digits(tally.speed_mps.quantile(fine_speed_bins, 0.95)),
                   three_digits(tally.height_m.moments.mean()),
                   three_digits(tally.height_m.quantile(fine_height_bins, 0.95))});
    }
    return joined("<h2>", report::page_text("Stations"), "</h2>\n<section class=\"card\">", table.html(),
                  rates_table(results), "</section>\n", charts_at_stations(results));
}

std::string key_figures(const ProfileResults& results) {
    using namespace rockfall;
    const ProfileTally& tally = results.tally;
    HtmlTable table{"", {report::page_text("All rocks"), report::page_text("value")}};
    table.row({report::page_text("Rocks"), grouped(tally.rocks)});
    const auto share = [&](StopReason reason) {
        return share_in_words(share_of(tally.by_reason[static_cast<std::size_t>(reason)], tally.rocks));
    };
    table.row({report::page_text("Came to rest on the ground"), share(StopReason::at_rest)});
    table.row({report::page_text("Caught by the roughness of the ground"), share(StopReason::caught)});
    table.row({report::page_text("Left the profile over an end"), share(StopReason::left_terrain)});
    table.row({report::page_text("Ended by the limit of impacts"), share(StopReason::gave_up)});
    table.row({report::page_text("Of these over the lower end"),
               share_in_words(share_of(tally.left_lower, tally.rocks))});
    table.row({report::page_text("Run-out in plan of the rocks that stop: mean / shortest / longest, m"),
               joined(fixed(tally.run_out_m.mean(), 1), " / ", fixed(tally.run_out_m.least(), 1), " / ",
                      fixed(tally.run_out_m.most(), 1))});
    table.row(
        {report::page_text("Run-out of all rocks, at least (those that leave count up to the end of the "
                           "profile): mean / shortest / longest, m"),
         joined(fixed(tally.run_out_at_least_m.mean(), 1), " / ", fixed(tally.run_out_at_least_m.least(), 1),
                " / ", fixed(tally.run_out_at_least_m.most(), 1))});
    const auto spread = [&](const std::string& name, const Spread& s, const LogBins& bins, double unit) {
        table.row({name, joined(three_digits(s.moments.mean() / unit), " / ",
                                three_digits(s.quantile(bins, 0.90) / unit), " / ",
                                three_digits(s.moments.most() / unit))});
    };
    spread(report::page_text("Largest speed of a rock: mean / 90 % / largest, m/s"), tally.max_speed_mps,
           fine_speed_bins, 1.0);
    spread(report::page_text("Largest energy of a rock: mean / 90 % / largest, kJ"), tally.max_energy_j,
           fine_energy_bins, j_per_kj);
    spread(report::page_text("Largest vertical height of a rock: mean / 90 % / largest, m"),
           tally.max_height_m, fine_height_bins, 1.0);
    table.row({report::page_text("Mean speed, m/s"), three_digits(tally.mean_speed_mps.mean())});
    table.row({report::page_text("Ground impacts per rock"), three_digits(tally.ground_impacts.mean())});
    table.row(
        {report::page_text("Jump from impact to impact: mean / longest, m"),
         joined(three_digits(tally.jump_length_m.mean()), " / ", three_digits(tally.jump_length_m.most()))});
    return joined("<h2>", report::page_text("Key figures"), "</h2>\n<section class=\"card\">", table.html(),
                  "</section>\n");
}

}  // namespace

void write_page(std::ostream& out, const ProfileResults& results, const std::vector<WrittenFile>& files) {
    const report::WritingLanguage language{results.scenario.report.language};
    const std::vector<std::string> turns = rockfall::sideways_settings();
    const std::set<std::string> set_to_none{turns.begin(), turns.end()};
    const report::PageFrame frame{
        .title =
            report::page_title(results.scenario.report,
                               report::page_text("Rockfall along a profile: {name}",
                                                 {{"name", escaped(results.scenario.file.stem().string())}})),
        .version = results.version,
        .scripts = {page_scripts::charts()},
        .style = std::string{style_of_profile()},
        .before_main = {}};
    report::begin_page(out, frame);
    out << opening(results) << drawing(results) << charts_along(results) << stations(results)
        << key_figures(results) << joined("<h2>", report::page_text("Warnings"), "</h2>\n")
        << report::list_of_warnings(results.warnings)
        << report::settings_section(
               results.scenario,
               [&](const std::string& key) { return !plays_no_part(key) || set_to_none.contains(key); })
        << joined("<h2>", report::page_text("Data"), "</h2>\n<section class=\"card\"><p>",
                  report::page_text("Input files, named as in the scenario; please credit their owners as "
                                    "their licences ask."),
                  "</p>")
        << report::table_of_inputs(results.site.inputs)
        << joined("</section>\n<h2>", report::page_text("Files of this run"),
                  "</h2>\n<section class=\"card\">")
        << report::table_of_files("", files) << "</section>\n"
        << report::citation(results.version, results.scenario);
    report::end_page(out, frame);
}

}  // namespace coupling::profile
