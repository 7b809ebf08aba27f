#include "coupling/assessments/decades/members/member_keys.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <system_error>

#include "config/text/joined.hpp"
#include "config/text/sha256.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/run/settings_hash.hpp"

namespace coupling::decades {
namespace {

using config::joined;

/// What a study compares and asks, and how long it is. None of it changes a year of a member; which lists and
/// maps are kept of it stands in its part.
const std::set<std::string>& settings_of_studies() {
    static const std::set<std::string> keys{"run.replicates",
                                            "run.years",
                                            "output.tree_list_years",
                                            "output.map_years",
                                            "regimes.list",
                                            "climate.variants",
                                            "decision.protection_at_least",
                                            "decision.probability",
                                            "decision.discount_percent",
                                            "decision.years_beyond",
                                            "targets.file",  // where targets are counts
                                            "risk.assess",
                                            "risk.curves",
                                            "risk.rocks_per_year",
                                            "risk.vehicle_length_m",
                                            "risk.passages_per_day",
                                            "risk.prevented_death",
                                            "risk.closure_days",
                                            "risk.closure_cost_per_day",
                                            "risk.currency",
                                            "output.geopackage",
                                            "output.geotiff",
                                            "output.xlsx",
                                            "output.csv",
                                            "output.shapefile",
                                            "output.kml",
                                            "output.gpx"};
    return keys;
}

/// Files of climates and targets: their weather and places count instead.
bool counts_by_content(const InputFile& input) {
    return input.role.starts_with("climate") || input.role.starts_with("targets");
}

/// Numbers in a row of bytes.
class Digits {
public:
    void add(double value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
    void add(const std::optional<double>& value) {
        add(value ? 1.0 : 0.0);
        add(value.value_or(0.0));
    }
    void add(std::span<const double> values) {
        add(static_cast<double>(values.size()));
        for (const double value : values) {
            add(value);
        }
    }
    void add(const forest::ClimateMonth& month) {
        static_assert(sizeof month == 7 * sizeof(double) + 2 * sizeof(std::optional<double>),
                      "a member depends on the new value, too");
        for (const double value : {month.tmin_degc, month.tmax_degc, month.tave_degc, month.prec_mm,
                                   month.radiation_mjpm2, month.vpd_kpa, month.frost_days}) {
            add(value);
        }
        add(month.degree_days);
        add(month.abs_tmin_degc);
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Two elevations: what lies between follows by the lapse rates, which are settings.
constexpr std::array elevations_m{0.0, 1000.0};

/// What the start takes from the first climate.
std::string means_of(const SiteClimate& climate) {
    Digits digits;
    for (const double elevation_m : elevations_m) {
        digits.add(climate.source.degree_days(elevation_m));
        digits.add(climate.source.usual_summer_mm(elevation_m));
    }
    digits.add(climate.source.mean_radiation_mjpm2());
    return digits.bytes();
}

/// Where targets are: what they are called, and who and what is there, changes no fall.
std::string places_of(std::span<const rockfall::Target> targets) {
    Digits digits;
    for (const rockfall::Target& target : targets) {
        digits.add(target.is_area ? 1.0 : 0.0);
        digits.add(static_cast<double>(target.parts.size()));
        for (const std::vector<Eigen::Vector2d>& part : target.parts) {
            digits.add(static_cast<double>(part.size()));
            for (const Eigen::Vector2d& vertex : part) {
                digits.add(vertex.x());
                digits.add(vertex.y());
            }
        }
    }
    return digits.bytes();
}

/// The program itself: versions of one number may have other laws while it is developed.
std::string program_hash() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) {
        // Not known which program it is: no member of an earlier run is taken for one of this.
        return std::to_string(std::chrono::system_clock::now().time_since_epoch().count());
    }
    return open_file(program, {}, "the program itself").hash();
}

std::string key_of(const std::string& text) {
    constexpr std::size_t digits = 32;
    return config::sha256_of(text).substr(0, digits);
}

/// Keys of the first 0, 1, 2 ... years: each is made of the one before.
std::vector<std::string> weather_keys(const SiteClimate& climate, int first_year, int years,
                                      std::uint32_t replicate) {
    Digits usual;
    usual.add(climate.usual_summer_mm);
    std::vector<std::string> keys{key_of(usual.bytes())};
    for (int year = first_year; year < first_year + years; ++year) {
        const YearWeather weather = climate.source.weather(year, replicate, elevations_m);
        Digits digits;
        digits.add(weather.co2_ppm);
        digits.add(weather.co2_response ? 1.0 : 0.0);
        digits.add(static_cast<double>(weather.source_year));
        for (const forest::ClimateYear& unit : weather.units) {
            for (const forest::ClimateMonth& month : unit.months) {
                digits.add(month);
            }
        }
        keys.push_back(key_of(keys.back() + digits.bytes()));
    }
    return keys;
}

/// A longer spin-up than the run takes its weather over and over (inputs/forest/spin_up.cpp): after how many
/// years; 0: it does not.
int repeat_of_spin_up(const ForestSite& forest) {
    return forest.spin_up_years > forest.run_years ? forest.run_years : 0;
}

}  // namespace

MemberKeys::MemberKeys(const Scenario& scenario, const Site& site, const Management& management)
    : scenario_{scenario}, forest_{*site.forest}, blocks_{scenario}, regimes_{management.read_for} {
    std::vector<InputFile> inputs;
    std::copy_if(site.inputs.begin(), site.inputs.end(), std::back_inserter(inputs),
                 [](const InputFile& input) { return !counts_by_content(input); });
    inputs.insert(inputs.end(), management.shared_inputs.begin(), management.shared_inputs.end());
    shared_ = key_of(joined(program_hash(), text_of_settings(scenario, inputs, settings_of_studies()),
                            means_of(forest_.climates.front()), places_of(site.targets),
                            std::to_string(forest_.first_year())));
}

std::string MemberKeys::weather_of(std::uint32_t climate, std::uint32_t replicate, std::int32_t years) const {
    const SiteClimate& of = forest_.climates[climate];
    // Where no years are drawn, all replicates have the same ones.
    const std::uint32_t drawn = of.source.order == ClimateOrder::random ? replicate : 0;
    const std::lock_guard lock{mutex_};
    std::vector<std::string>& keys = weather_[{climate, drawn}];
    if (keys.empty()) {
        keys = weather_keys(of, forest_.first_year(), static_cast<int>(scenario_.run.years), drawn);
    }
    return keys[static_cast<std::size_t>(years)];
}

std::string MemberKeys::of(const Member& member) const {
    return of(member, static_cast<std::int32_t>(scenario_.run.years));
}

std::string MemberKeys::of(const Member& member, std::int32_t years) const {
    // The forest of the start grew up in the first climate, whatever comes after.
    return key_of(joined(shared_, ";member ", std::to_string(member.replicate), ";",
                         std::to_string(repeat_of_spin_up(forest_)), ";",
                         weather_of(0, member.replicate, years), ";",
                         weather_of(member.climate, member.replicate, years), ";", regimes_[member.regime]));
}

std::string MemberKeys::of_bare(std::uint32_t replicate, std::size_t block) const {
    std::string years;
    for (const std::int32_t year : blocks_.years(block)) {
        years += joined(" ", std::to_string(year), blocks_.with_cells(year) ? " with cells" : "");
    }
    return key_of(joined(shared_, ";bare ", std::to_string(replicate), ";", years));
}

}  // namespace coupling::decades
