#include "coupling/assessments/decades/closing_summary.hpp"

#include <algorithm>
#include <cstdio>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/arrivals.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/assessments/decades/tables/departures_over_years.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/tables/text_layout.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// Mean of the replicates with its interval, as on the page.
void say_target(const DecadeResults& results, const Series& protection, const std::string& name,
                std::uint32_t target) {
    for (std::size_t course = 0; course < results.names.courses(); ++course) {
        const std::vector<TargetRow>& rows = results.members.front().targets;
        const std::int32_t first_year = rows.empty() ? 0 : rows.front().year;
        const std::int32_t last_year = rows.empty() ? 0 : rows.back().year;
        const auto percent = [&](std::int32_t year) {
            const PairedCounts counts = arrivals_of(results.names, results.members, course, target, year);
            const auto value = over_replicates(protection, course, year);
            if (!value) {
                return counts.bare() == 0 ? std::string{"– (no rock arrives)"}
                                          : joined("– (", too_few_in_words(counts.bare()), ")");
            }
            const Band& band = value->band;
            if (band.has_interval() && says_nothing(band.low, band.high)) {
                return joined("– (", too_few_in_words(counts.bare()), ")");
            }
            const auto interval = [](double low, double high) {
                return joined(" (", report::fixed(low, 1), " to ", report::fixed(high, 1), ")");
            };
            if (band.has_interval()) {
                return joined(report::fixed(band.mean, 1), " %", interval(band.low, band.high));
            }
            // One replicate, or all are equal: what their rocks say.
            const auto effect = protection_effect(counts);
            return joined(
                report::fixed(band.mean, 1), " %",
                effect ? interval(100.0 * effect->interval.low, 100.0 * effect->interval.high) : "");
        };
        std::printf("  %s, %s: stopped by the forest: %s in year %d, %s in year %d\n", name.c_str(),
                    results.names.course_name(course).c_str(), percent(first_year).c_str(), first_year,
                    percent(last_year).c_str(), last_year);
    }
}

/// Money at risk a year under each regime.
void say_risk(const DecadeResults& results) {
    const RiskOverYears& risk = *results.risk;
    const auto say = [&](const std::string& name, Cover cover, std::size_t course) {
        if (const auto mean = mean_risk(risk.all, cover, course)) {
            const Band& money = mean->at(consequences::Quantity::money);
            std::printf("  risk of %s, %s: %s %s a year%s\n",
                        counted(risk.targets.size(), "exposed target").c_str(), name.c_str(),
                        report::three_digits(money.mean).c_str(), risk.plan.settings.currency.c_str(),
                        money.has_interval() ? joined(" (", report::three_digits(money.low), " to ",
                                                      report::three_digits(money.high), ")")
                                                   .c_str()
                                             : "");
        }
    };
    for (std::size_t course = 0; course < results.names.courses(); ++course) {
        say(results.names.course_name(course), Cover::forest, course);
    }
    say("bare slope", Cover::bare, 0);
}

}  // namespace

void print_summary(const DecadeResults& results) {
    const forest::PatchGrid& grid = results.site.forest->grid;
    std::printf("%s of %.2f ha forest (%zu patches), %s, %s%s",
                counted(results.scenario.run.years, "year").c_str(), grid.area_ha(), grid.size(),
                counted(results.names.regimes.size(), "regime").c_str(),
                results.names.climates.size() > 1
                    ? joined(counted(results.names.climates.size(), "climate"), ", ").c_str()
                    : "",
                counted(results.scenario.forest.replicates, "replicate").c_str());
    results.rocks > 0 ? std::printf(", %llu rocks a year\n", static_cast<unsigned long long>(results.rocks))
                      : std::printf(", no rockfall\n");
    const MemberYears& member = results.members.front();
    for (const StandRow& row : member.stands) {
        if (row.unit == all && row.species == all &&
            (row.year == 0 || row.year == static_cast<std::int32_t>(results.scenario.run.years))) {
            std::printf(
                "  year %d (%s, replicate 1): %.0f stems/ha, %.1f m2/ha, %.0f m3/ha, dominant height %.1f "
                "m\n",
                row.year, results.names.course_name(results.names.course_of(member.member)).c_str(),
                row.figures.stems_pha, row.figures.basal_area_m2pha, row.figures.volume_m3pha,
                row.figures.dominant_height_m);
        }
    }
    if (results.rocks > 0) {
        for (const Cover cover : {Cover::bare, Cover::forest}) {
            const Departures departures =
                departures_over_years(results.members, cover, results.site.slope.terrain);
            std::printf(
                "  %s\n",
                in_words(departures, cover == Cover::bare ? "over the bare slope" : "with forest").c_str());
        }
        const std::vector<Series> series =
            series_of(results.names, results.site, results.members, std::nullopt);
        for (std::uint32_t target = 0; target < results.site.targets.size(); ++target) {
            const rockfall::Target& of = results.site.targets[target];
            const auto protection = std::find_if(series.begin(), series.end(), [&](const Series& each) {
                return each.target == of.id && each.quantity == "protection_percent";
            });
            say_target(results, *protection, of.name, target);
        }
        if (results.risk != nullptr) {
            say_risk(results);
        }
        if (results.scenario.forest.replicates > 1) {
            std::printf(
                "  mean of %s; in brackets its 90 %% interval, where all are equal the 95 %% interval of "
                "their rocks\n",
                counted(results.scenario.forest.replicates, "replicate").c_str());
        }
    }
    for (const std::string& sentence : verdict_of(results)) {
        for (const std::string& line : wrapped(sentence, screen_columns - 2)) {
            std::printf("  %s\n", line.c_str());
        }
    }
}

}  // namespace coupling::decades
