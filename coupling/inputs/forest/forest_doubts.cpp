#include "coupling/inputs/forest/forest_doubts.hpp"

#include <cmath>
#include <string>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/plausible/climate_at.hpp"
#include "coupling/inputs/scenario/forest_settings.hpp"
#include "coupling/inputs/scenario/tree_settings.hpp"
#include "forest/stand/allometry.hpp"

namespace coupling {
namespace {

using config::joined;

std::string one_decimal(double value) {
    return config::to_text(std::round(10.0 * value) / 10.0);
}

}  // namespace

void doubt_climates(const ForestSite& site, double elevation_m, Reading& reading) {
    const double latitude_deg = reading.forest().latitude_deg;
    const config::Place latitude = reading.settings().options->place_of("forest.latitude_deg");
    const std::string given = joined("forest.latitude_deg ", config::to_text(latitude_deg));
    if (plausible::is_far_from_species(latitude_deg)) {
        reading.warn(latitude, given, "30 to 70 degrees: the species are trees of Europe",
                     "write degrees with decimals, such as 46.8");
    }
    for (const SiteClimate& named : site.climates) {
        const plausible::ClimateAt climate =
            plausible::climate_at(named.source.series, latitude_deg, elevation_m, named.source.lapse_rates);
        if (plausible::seasons_contradict(plausible::hemisphere_of(climate))) {
            reading.refuse({reading.shown(reading.forest().climate)},
                           "January as the summer month, July as the winter month",
                           "seasons of a place north of the equator, where forest.latitude_deg lies",
                           "correct the months");
        }
        if (plausible::is_of_another_place(climate)) {
            reading.warn({reading.shown(reading.forest().climate)},
                         joined(one_decimal(climate.mean_degc), " degC as the mean of a year at ",
                                config::to_text(std::round(elevation_m)), " m"),
                         joined("about ", one_decimal(plausible::usual_mean_degc(latitude_deg, elevation_m)),
                                " degC at that latitude and elevation"),
                         "check the unit (degC), elev_m or climate.elevation_m (metres) and the place",
                         config::Effect::answer);
        }
        const double factor = plausible::mean_factor_on_rain(named.source.change);
        if (plausible::is_odd_factor_on_rain(factor)) {
            reading.warn(reading.settings().options->place_of("climate.precipitation_change"),
                         joined("rain times ", config::to_text(std::round(100.0 * factor) / 100.0)),
                         "a factor from 0.5 to 1.5, such as 0.8 for a fifth less; 1 is no change");
        }
    }
}

void doubt_first_disturbance(const ForestSite& site, Reading& reading) {
    const auto wanted = static_cast<int>(site.parameters.disturbance.first_year);
    const int first = site.first_year();
    const int last = first + site.run_years - 1;
    if (wanted != 0 && (wanted < first || wanted > last)) {
        reading.warn(
            reading.settings().options->place_of("disturbance.first_year"),
            joined("disturbance.first_year ", std::to_string(wanted)),
            joined("a calendar year of the run, ", std::to_string(first), " to ", std::to_string(last)),
            wanted < first ? "" : "as it is, no storm, wet snow or bark beetle comes");
    }
}

void doubt_events(const ForestSite& site, Reading& reading) {
    const int first = site.first_year();
    const int last = first + site.run_years - 1;
    const auto warn_of_years_outside = [&](const char* key, const std::vector<double>& years) {
        for (const double year : years) {
            if (year < first || year > last) {
                reading.warn(reading.settings().options->place_of(key),
                             joined(key, " ", config::to_text(year)),
                             joined("a calendar year of the run, ", std::to_string(first), " to ",
                                    std::to_string(last)),
                             "as it is, the event does not come");
            }
        }
    };
    const forest::DisturbanceLaw& law = site.parameters.disturbance;
    warn_of_years_outside("disturbance.storm_years", law.storm_years);
    warn_of_years_outside("disturbance.beetle_years", law.beetle_years);
    if (!law.beetle && !law.beetle_years.empty()) {
        reading.warn(reading.settings().options->place_of("disturbance.beetle_years"),
                     "disturbance.beetle_years without disturbance.beetle = yes",
                     "bark beetles that are simulated, since an outbreak goes on in the years after",
                     "as it is, the event does not come");
    }
    for (const double year : law.beetle_years) {
        if (year >= first && year <= last && year < static_cast<double>(law.first_year)) {
            reading.warn(reading.settings().options->place_of("disturbance.beetle_years"),
                         joined("disturbance.beetle_years ", config::to_text(year)),
                         joined("a year from disturbance.first_year (", std::to_string(law.first_year),
                                ") on, when beetles begin"),
                         "as it is, the event does not come");
        }
    }
    warn_of_years_outside("climate.dry_years", reading.forest().dry_years);
}

void doubt_dense_list(const ForestSite& site, Reading& reading) {
    constexpr double most_m2pha = 100.0;  // [choice] stands of the thickest firs have 80
    double sum_m2 = 0.0;
    for (const forest::Tree& tree : site.listed) {
        sum_m2 += tree.stems * forest::basal_area_m2(tree.dbh_cm);
    }
    const double basal_area_m2pha = sum_m2 / site.grid.area_ha();
    if (basal_area_m2pha > most_m2pha) {
        reading.warn({reading.shown(reading.trees().source())},
                     joined("trees that make ", config::to_text(std::round(basal_area_m2pha)),
                            " m2/ha of basal area in the forest"),
                     "at most 100 m2/ha",
                     "check dbh_cm: diameters and no girths, in cm; and the forest of stands.map",
                     config::Effect::answer);
    }
}

}  // namespace coupling
