#include "coupling/assessments/today/observed_events.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/results/tables/figure_columns.hpp"

namespace coupling {
namespace {

using observed::EventComparison;
using observed::SampleFigures;
using observed::SimulatedPassage;

const char* kind_in_words(const EventComparison& one) {
    return one.kind == EventComparison::Kind::passage ? "passage" : "impact";
}

/// One side of a comparison.
struct EventRow {
    const EventComparison& of;
    bool observed;
};

TableOf<EventRow> event_table() {
    constexpr const char* unit = "as the row says";
    const auto quantile = [](const char* name, const char* meaning, std::size_t number) {
        return ColumnsOf<SampleFigures>{
            name, unit, 4, meaning, unit, [number](const SampleFigures& f) { return f.quantiles[number]; }};
    };
    return {"observed_events.csv",
            "Rocks that were seen at targets and single impacts, beside the simulated ones.",
            "a quantity of passages or impacts, observed or simulated",
            {{"event", "passage at a target, or impact on the ground", "definition",
              [](const auto& row) { return kind_in_words(row.of); }},
             {"target_id", "target of a passage", "input observed.passages",
              [](const auto& row) { return row.of.place; }},
             {"group", "column group; all: every row", "input observed.passages, observed.impacts",
              [](const auto& row) { return row.of.group.empty() ? "all" : row.of.group; }},
             {"quantity", "what was measured; passing_share: of all rocks; speed_ratio: after by before",
              "definition", [](const auto& row) { return row.of.quantity; }},
             {"unit", "unit of the figures", "definition", [](const auto& row) { return row.of.unit; }},
             {"side", "observed or simulated", "definition",
              [](const auto& row) { return row.observed ? "observed" : "simulated"; }},
             {ColumnsOf<SampleFigures>{
                  {"count", "values", from_counting, &SampleFigures::count},
                  {"mean", unit, 4, "mean; of passing_share the share", unit, &SampleFigures::mean},
                  {"deviation", unit, 4, "standard deviation (n - 1)", unit, &SampleFigures::deviation},
                  quantile("p10", "10 % quantile", 0),
                  quantile("p25", "25 % quantile", 1),
                  quantile("p50", "median", 2),
                  quantile("p75", "75 % quantile", 3),
                  quantile("p90", "90 % quantile", 4),
                  {"largest", unit, 4, "largest value", unit, &SampleFigures::largest}},
              [](const auto& row) { return &(row.observed ? row.of.observed : row.of.simulated); }},
             {ColumnsOf<EventComparison>{
                  {"ks", 4, "largest distance between the distributions (Kolmogorov-Smirnov)",
                   "both distributions", &EventComparison::largest_distance},
                  {"ks_by_chance", 4, "what 5 % of samples of one distribution exceed", "Smirnov 1948",
                   &EventComparison::distance_by_chance},
                  {"energy_distance", unit, 4, "2 E|X - Y| - E|X - X'| - E|Y - Y'|", "Szekely & Rizzo 2013",
                   &EventComparison::energy_distance}},
              [](const auto& row) { return row.observed ? nullptr : &row.of; }}}};
}

Json json_event_side(const SampleFigures& figures) {
    Json quantiles;
    for (std::size_t i = 0; i < figures.quantiles.size(); ++i) {
        const auto below_percent = static_cast<int>(100.0 * observed::quantile_shares[i] + 0.5);
        quantiles["p" + std::to_string(below_percent)] = json_number(figures.quantiles[i]);
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

TableLayout observed_events_layout() {
    return event_table();
}

WrittenFile write_observed_events(const std::filesystem::path& folder,
                                  const std::vector<EventComparison>& comparisons) {
    return event_table().write(folder, [&](auto& rows) {
        for (const EventComparison& one : comparisons) {
            rows.add({one, true});
            rows.add({one, false});
        }
    });
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
