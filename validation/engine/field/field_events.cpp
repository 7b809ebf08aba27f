#include "validation/engine/field/field_events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/inputs/events_of_rocks.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using observed::EventComparison;
using observed::SampleFigures;

/// A figure of a quantity of passages or impacts.
struct EventMeasure {
    const char* name;
    const char* label;
    double (*value)(const SampleFigures& figures);  ///< null: a distance between both sides
    double (*distance)(const EventComparison& comparison);

    [[nodiscard]] double of(const EventComparison& event) const {
        return value != nullptr ? value(event.simulated) : distance(event);
    }
};

constexpr std::array event_measures{
    EventMeasure{"mean", "mean", [](const SampleFigures& f) { return f.mean; }, nullptr},
    EventMeasure{"deviation", "standard deviation", [](const SampleFigures& f) { return f.deviation; },
                 nullptr},
    EventMeasure{"p10", "10 %", [](const SampleFigures& f) { return f.quantiles[0]; }, nullptr},
    EventMeasure{"p50", "median", [](const SampleFigures& f) { return f.quantiles[2]; }, nullptr},
    EventMeasure{"p90", "90 %", [](const SampleFigures& f) { return f.quantiles[4]; }, nullptr},
    EventMeasure{"largest", "largest", [](const SampleFigures& f) { return f.largest; }, nullptr},
    EventMeasure{"ks", "KS", nullptr, [](const EventComparison& c) { return c.largest_distance; }},
    EventMeasure{"energy_distance", "energy distance", nullptr,
                 [](const EventComparison& c) { return c.energy_distance; }},
};

/// Shares have a mean only.
bool means_something(const EventMeasure& measure, const EventComparison& event) {
    return event.quantity != "passing_share" || &measure == &event_measures.front();
}

std::string event_figure(const std::string& model, const EventComparison& event,
                         const EventMeasure& measure) {
    return joined(model, model.empty() ? "" : ".", event.name(), ".", measure.name);
}

/// What stands in for simulated events before any rock fell: one of each, so that all figures have a name.
std::vector<EventComparison> events_to_come(const Site& site) {
    std::vector<observed::SimulatedPassage> passages;
    for (std::uint32_t target = 0; target < site.targets.size(); ++target) {
        passages.push_back({target, 1.0, 1.0, 1.0, 1.0});
    }
    std::vector<observed::SimulatedImpact> impacts;
    for (const rockfall::SurfaceType& type : site.slope.types) {
        impacts.push_back({type.code, 1.0, 1.0, 1.0, 1.0});
    }
    return observed::compare_events(site, passages, impacts, 1);
}

}  // namespace

void name_event_figures(const std::string& model, const Site& site, const std::string& simulated_by,
                        Comparison& comparison) {
    for (const EventComparison& event : events_to_come(site)) {
        for (const EventMeasure& measure : event_measures) {
            if (!means_something(measure, event)) {
                continue;
            }
            const std::string name = event_figure(model, event, measure);
            const bool listed = event.group.empty() && model.empty() && &measure == &event_measures.front();
            comparison.figures.push_back(
                {name, joined(event.name(), ", ", measure.label, model.empty() ? "" : ", ", model),
                 event.unit, listed, simulated_by});
            if (measure.value != nullptr && std::isfinite(measure.value(event.observed))) {
                comparison.references[name] = {
                    measure.value(event.observed),
                    event.kind == EventComparison::Kind::passage ? "observed.passages" : "observed.impacts"};
            }
        }
    }
}

void take_event_values(const std::string& model, const std::vector<EventComparison>& events,
                       Outcome& outcome) {
    for (const EventComparison& event : events) {
        for (const EventMeasure& measure : event_measures) {
            if (means_something(measure, event)) {
                outcome.values[event_figure(model, event, measure)] = measure.of(event);
            }
        }
    }
}

PlainTable events_table(const std::vector<ModelEvents>& models) {
    PlainTable table{.caption = "Observed and simulated passages and impacts",
                     .head = {"quantity", "figure", "observed"},
                     .rows = {}};
    for (const ModelEvents& model : models) {
        table.head.push_back(model.model);
    }
    for (const EventComparison& first : models.front().events) {
        for (const EventMeasure& measure : event_measures) {
            if (!means_something(measure, first)) {
                continue;
            }
            std::vector<std::string> row{
                first.name(), joined(measure.label, " [", first.unit, "]"),
                measure.value != nullptr ? report::fixed(measure.value(first.observed), 2) : ""};
            for (const ModelEvents& model : models) {
                const auto same =
                    std::find_if(model.events.begin(), model.events.end(),
                                 [&](const EventComparison& e) { return e.name() == first.name(); });
                row.push_back(same == model.events.end() ? "" : report::fixed(measure.of(*same), 2));
            }
            table.rows.push_back(std::move(row));
        }
    }
    return table;
}

}  // namespace coupling::validation
