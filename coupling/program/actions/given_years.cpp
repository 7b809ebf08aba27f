#include "coupling/program/actions/given_years.hpp"

#include <cmath>
#include <utility>

#include "config/errors/warnings.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/climate/sunshine.hpp"
#include "coupling/inputs/systems/system_way.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "coupling/program/actions/given_files.hpp"
#include "forest/climate/series.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::uint32_t usual_years = 40;    ///< a plan of management with what it leaves behind [choice]
constexpr double usual_latitude_deg = 47.0;  ///< of the Alps

void remark(GivenYears& given, std::string sentence) {
    given.remarks.push_back(std::move(sentence));
}

/// North positive, to hundredths.
std::optional<double> latitude_of(const AskedYears& asked) {
    if (asked.system.empty() || !asked.extent) {
        return std::nullopt;
    }
    systems::SystemWay way{asked.system, systems::wgs84_system};
    if (!way.is_known()) {
        return std::nullopt;
    }
    const plausible::Extent& extent = *asked.extent;
    const auto place = way.at(0.5 * (extent.west_m + extent.east_m), 0.5 * (extent.south_m + extent.north_m));
    constexpr double hundredths = 100.0;
    return place ? std::optional{std::round(place->y * hundredths) / hundredths} : std::nullopt;
}

forest::ClimateSeries read_series(const AskedYears& asked, double latitude_deg, GivenYears& given) {
    GivenFile file{asked.climate};
    formats::ReadLayer read = file.layer();
    tables::add_remarks(tables::prepare(read.layer.table, "climate", read.has_shapes_of_its_own),
                        given.remarks);
    climate::take_sunshine(read.layer.table, config::Angle::from_degrees(latitude_deg));
    config::Warnings unseen;  // what the series itself is like, the check of the project says
    return forest::read_climate_of_one_place(read.layer.table, unseen);
}

std::string latitude_line(const AskedYears& asked, GivenYears& given) {
    if (const auto latitude_deg = latitude_of(asked)) {
        return joined("latitude_deg = ", config::to_text(*latitude_deg),
                      "       ; of the middle of the terrain\n");
    }
    remark(given, joined("no coordinate system: the latitude of ", config::to_text(usual_latitude_deg),
                         " degrees is a guess"));
    return joined("latitude_deg = ", config::to_text(usual_latitude_deg),
                  "          ; GUESS: the terrain names no coordinate system\n");
}

/// The height of the place of the climate, from its table or a guess.
std::string elevation_line(const AskedYears& asked, const forest::ClimateSeries& series, GivenYears& given) {
    if (series.elevation_m) {
        return "";
    }
    const std::string height = config::to_text(std::round(asked.mean_height_m.value_or(0.0)));
    remark(given, joined("the climate names no height: that of the slope, ", height,
                         " m, is a guess; 100 m are 0.3 to 0.7 K"));
    return joined("elevation_m = ", height,
                  "          ; GUESS: height of the place of the climate; here that of the slope\n");
}

}  // namespace

GivenYears given_years(const AskedYears& asked, const std::filesystem::path& folder) {
    GivenYears given;
    const forest::ClimateSeries series =
        read_series(asked, latitude_of(asked).value_or(usual_latitude_deg), given);
    const std::uint32_t years = asked.years > 0 ? asked.years : usual_years;
    given.run =
        joined("years = ", std::to_string(years), asked.years > 0 ? "\n" : "                  ; GUESS\n",
               "first_year = ", std::to_string(series.last_year() + 1),
               "           ; calendar year of the first simulated one: that after the climate\n"
               "rockfall_every = 1          ; years between two years with rocks; 0: the forest alone\n"
               "replicates = 10             ; each with other random numbers\n");
    given.sections = joined(
        "\n[forest]\n", latitude_line(asked, given),
        ";region_species = PIAB, ABAL, FASY    ; species whose seeds come from outside; none: all of the "
        "table\n"
        "\n[soil]\n"
        "type = normal               ; GUESS: scree, shallow, normal, deep; or soil.map with types of yours\n"
        "\n[climate]\nfile = ",
        name_from(folder, asked.climate), "\n", elevation_line(asked, series, given),
        "sequence = random           ; simulated years take the weather of years drawn from the file\n"
        ";temperature_change_k = 2   ; a warmer climate after change_years; variants: several beside each "
        "other\n"
        "\n[regimes]\n"
        "list = none, single_tree_selection    ; shipped ones (bannwald info regimes), or CSV files of "
        "yours\n"
        "\n[decision]\n"
        ";protection_at_least = 65   ; percent, in all years with rocks: which regime keeps it\n");
    remark(given, joined(asked.climate, ": climate of ", std::to_string(series.first_year()), " to ",
                         std::to_string(series.last_year()), "; years are drawn from it"));
    remark(given, joined(std::to_string(years),
                         " years under two regimes, none and single_tree_selection: see [regimes] "
                         "of scenario.ini for your own"));
    return given;
}

}  // namespace coupling
