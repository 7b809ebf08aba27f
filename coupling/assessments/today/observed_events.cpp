#include "coupling/assessments/today/observed_events.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/today/figures/static_layouts.hpp"
#include "coupling/inputs/tables/csv_row.hpp"
#include "coupling/results/figures/figures.hpp"

namespace coupling {
namespace {

using observed::EventComparison;
using observed::SampleFigures;
using observed::SimulatedPassage;

const char* kind_in_words(const EventComparison& one) {
    return one.kind == EventComparison::Kind::passage ? "passage" : "impact";
}

void write_event_side(TableRows& row, const EventComparison& one, const char* side,
                      const SampleFigures& figures) {
    row.text(kind_in_words(one)).text(one.place).text(one.group.empty() ? "all" : one.group);
    row.text(one.quantity).text(one.unit).text(side).whole(figures.count);
    row.number<4>(figures.mean).number<4>(figures.deviation);
    for (const double quantile : figures.quantiles) {
        row.number<4>(quantile);
    }
    row.number<4>(figures.largest);
}

Json json_event_side(const SampleFigures& figures) {
    Json quantiles;
    for (std::size_t i = 0; i < figures.quantiles.size(); ++i) {
        const auto percent = static_cast<int>(100.0 * observed::quantile_shares[i] + 0.5);
        quantiles["p" + std::to_string(percent)] = json_number(figures.quantiles[i]);
    }
    return {{"count", figures.count},
            {"mean", json_number(figures.mean)},
            {"deviation", json_number(figures.deviation)},
            {"quantiles", quantiles},
            {"largest", json_number(figures.largest)}};
}

}  // namespace

std::vector<SimulatedPassage> simulated_passages(OwnRows& arrivals, const Site& site, rockfall::Cover cover) {
    std::map<std::string, std::uint32_t, std::less<>> place_of;
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        place_of.emplace(site.targets[i].id, static_cast<std::uint32_t>(i));
    }
    const std::size_t target = arrivals.column("target_id"), slope = arrivals.column("cover");
    const std::array<std::size_t, 4> numbers{arrivals.column("speed_mps"), arrivals.column("height_m"),
                                             arrivals.column("energy_kj"),
                                             arrivals.column("translational_kj")};
    std::vector<SimulatedPassage> passages;
    while (arrivals.next()) {
        const auto& fields = arrivals.fields();
        const auto place = place_of.find(fields[target]);
        if (place == place_of.end()) {
            arrivals.refuse(config::joined("target ", config::in_quotes(std::string{fields[target]})));
        }
        if (fields[slope] == name_of(cover)) {
            std::array<double, 4> values{};
            for (std::size_t i = 0; i < values.size(); ++i) {
                const std::string_view field = fields[numbers[i]];
                const auto [end, error] =
                    std::from_chars(field.data(), field.data() + field.size(), values[i]);
                if (error != std::errc{} || end != field.data() + field.size()) {
                    arrivals.refuse("a field that is no number");
                }
            }
            passages.push_back({place->second, values[0], values[1], values[2], values[3]});
        }
    }
    return passages;
}

void write_observed_events(std::ostream& out, const std::vector<EventComparison>& comparisons) {
    TableRows row{out, static_layouts(), "observed_events.csv"};
    for (const EventComparison& one : comparisons) {
        write_event_side(row, one, "observed", one.observed);
        row.empty().empty().empty();
        row.end();
        write_event_side(row, one, "simulated", one.simulated);
        row.number<4>(one.largest_distance).number<4>(one.distance_by_chance).number<4>(one.energy_distance);
        row.end();
    }
}

Json json_observed_events(const std::vector<EventComparison>& comparisons) {
    Json list = Json::array();
    for (const EventComparison& one : comparisons) {
        list.push_back({{"name", one.name()},
                        {"unit", one.unit},
                        {"observed", json_event_side(one.observed)},
                        {"simulated", json_event_side(one.simulated)},
                        {"kolmogorov_smirnov", json_number(one.largest_distance)},
                        {"kolmogorov_smirnov_by_chance", json_number(one.distance_by_chance)},
                        {"energy_distance", json_number(one.energy_distance)}});
    }
    return list;
}

}  // namespace coupling
