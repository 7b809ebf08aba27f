#include "coupling/assessments/calibrate/model/observations.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/inputs/files/file_bytes.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// Fewer of a kind are not worth a search.
constexpr std::size_t least_observed = 8;
/// From so many groups on whole groups are held out: blocks of one event are no independent witnesses.
constexpr std::size_t least_groups = 5;

/// A number of 40 bits by which a group is drawn, whatever other groups there are.
std::uint64_t number_of_name(const std::string& name) {
    const std::uint64_t hash = fnv1a(name);
    return (hash ^ (hash >> 40U)) & 0xFF'FFFF'FFFFULL;
}

/// Marks of those that are held out; of whole groups the same ones for all kinds.
class HoldOut {
public:
    HoldOut(const CalibrateSettings& settings, std::uint64_t seed) : settings_{settings}, seed_{seed} {}

    /// `kind`: for the random numbers. `groups`: of each observation.
    [[nodiscard]] std::vector<bool> of(Seen kind, const std::vector<std::string>& groups) {
        std::vector<bool> marks(groups.size());
        if (!settings_.hold_out_group.empty()) {
            std::transform(groups.begin(), groups.end(), marks.begin(),
                           [&](const std::string& group) { return group == settings_.hold_out_group; });
            found_group_ = found_group_ || std::find(marks.begin(), marks.end(), true) != marks.end();
            return marks;
        }
        const std::set<std::string> names(groups.begin(), groups.end());
        const bool by_group = names.size() >= least_groups;
        std::vector<std::pair<double, std::size_t>> order;  // by chance
        for (std::size_t i = 0; i < groups.size(); ++i) {
            const std::uint64_t unit = by_group ? number_of_name(groups[i]) : i;
            const auto wave = by_group ? std::uint16_t{0} : static_cast<std::uint16_t>(kind);
            order.emplace_back(choices(seed_, wave, Choice::hold_out, unit).uniform(), i);
        }
        std::sort(order.begin(), order.end());
        const double wanted = settings_.hold_out_percent / 100.0 * static_cast<double>(groups.size());
        std::size_t taken = 0;
        for (std::size_t k = 0; k < order.size(); ++k) {
            const bool same_group = by_group && k > 0 && order[k].first == order[k - 1].first;
            if (static_cast<double>(taken) >= wanted && !same_group) {
                break;
            }
            marks[order[k].second] = true;
            ++taken;
        }
        return marks;
    }
    [[nodiscard]] bool found_group() const { return found_group_; }

private:
    const CalibrateSettings& settings_;
    std::uint64_t seed_;
    bool found_group_ = false;
};

void add(Observation& observation, const Eigen::Vector2d& point, bool is_held_out) {
    (is_held_out ? observation.held_out : observation.fit).points.push_back(point);
}

Observation named(Seen seen, std::string name, std::uint32_t target = 0) {
    Observation observation{.seen = seen, .name = std::move(name), .target = target};
    observation.fit.is_plane = observation.held_out.is_plane = observation.is_plane();
    return observation;
}

bool is_looked_at(const Eigen::Vector2d& place_m, const Search& search) {
    return search.window.empty() ||
           std::any_of(search.window.begin(), search.window.end(), [&](const config::Shape& polygon) {
               return config::point_in_polygon(polygon, {place_m.x(), place_m.y()});
           });
}

/// Stops, those of zones of their own apart.
void add_stops(const Site& site, HoldOut& hold_out, std::vector<Observation>& all) {
    std::map<std::string, std::set<std::uint32_t>> zones_of_group;
    std::vector<std::string> groups;
    bool all_have_zones = true;
    std::vector<ObservedStop> stops = site.observed_stops;
    std::erase_if(stops, [&](const ObservedStop& stop) {
        return !is_looked_at(stop.end_m, {.window = site.observed_events.window});
    });
    for (const ObservedStop& stop : stops) {
        groups.push_back(stop.group);
        all_have_zones = all_have_zones && stop.zone.has_value();
        if (stop.zone) {
            zones_of_group[stop.group].insert(*stop.zone);
        }
    }
    const std::vector<bool> marks = hold_out.of(Seen::stops, groups);
    std::map<std::set<std::uint32_t>, std::pair<std::string, std::vector<std::size_t>>> parts;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        const std::set<std::uint32_t> zones =
            all_have_zones ? zones_of_group[groups[i]] : std::set<std::uint32_t>{};
        auto& [name, rows] = parts[zones];
        name = name.empty() || name == groups[i] ? groups[i] : name;
        rows.push_back(i);
    }
    for (const auto& [zones, part] : parts) {
        const std::string of_part = parts.size() > 1 ? joined(":", part.first) : std::string{};
        Observation places = named(Seen::stops, joined("stops", of_part));
        Observation run_outs = named(Seen::run_out, joined("run_out", of_part));
        places.zones.assign(zones.begin(), zones.end());
        run_outs.zones = places.zones;
        const bool all_have_starts = std::all_of(part.second.begin(), part.second.end(),
                                                 [&](std::size_t i) { return stops[i].start_m.has_value(); });
        if (!all_have_starts) {
            run_outs.sources = std::make_shared<const SourceDistance>(site, places.zones);
        }
        for (const std::size_t i : part.second) {
            const ObservedStop& stop = stops[i];
            const Eigen::Vector2d place_m = stop.end_m - site.origin_m();
            add(places, place_m, marks[i]);
            add(run_outs,
                {all_have_starts ? (stop.end_m - *stop.start_m).norm() : run_outs.sources->at(place_m), 0.0},
                marks[i]);
        }
        all.push_back(std::move(places));
        all.push_back(std::move(run_outs));
    }
}

void add_scars(const Site& site, const CalibrateSettings& settings, HoldOut& hold_out,
               std::vector<Observation>& all) {
    std::vector<ObservedScar> scars = site.observed_events.scars;
    std::erase_if(scars, [&](const ObservedScar& scar) {
        return scar.dbh_cm && *scar.dbh_cm < settings.least_scar_dbh_cm;  // as simulated ones are left out
    });
    std::vector<std::string> groups;
    for (const ObservedScar& scar : scars) {
        groups.push_back(scar.group);
    }
    const std::vector<bool> marks = hold_out.of(Seen::scar_heights, groups);
    Observation heights = named(Seen::scar_heights, "scar_heights");
    Observation places = named(Seen::scar_places, "scar_places");
    bool all_have_places = true;
    for (std::size_t i = 0; i < scars.size(); ++i) {
        add(heights, {scars[i].height_m, 0.0}, marks[i]);
        all_have_places = all_have_places && scars[i].at_m.has_value();
        if (scars[i].at_m) {
            add(places, *scars[i].at_m - site.origin_m(), marks[i]);
        }
    }
    all.push_back(std::move(heights));
    if (all_have_places) {
        all.push_back(std::move(places));
    }
}

/// Passages at one target, quantity by quantity.
void add_passages(const Site& site, std::uint32_t target, HoldOut& hold_out, std::vector<Observation>& all) {
    struct Quantity {
        Seen seen;
        const char* name;
        std::optional<double> ObservedPassage::*value;
    };
    const std::string& id = site.targets[target].id;
    std::vector<const ObservedPassage*> passages;
    for (const ObservedPassage& passage : site.observed_events.passages) {
        if (passage.target == target) {
            passages.push_back(&passage);
        }
    }
    // A rock is held out with all that was measured of it.
    std::vector<std::string> groups;
    for (const ObservedPassage* passage : passages) {
        groups.push_back(passage->group);
    }
    const std::vector<bool> marks = hold_out.of(Seen::speed, groups);
    for (const Quantity& quantity :
         {Quantity{Seen::speed, "speed:", &ObservedPassage::speed_mps},
          Quantity{Seen::height, "height:", &ObservedPassage::height_m},
          Quantity{Seen::energy, "energy:", &ObservedPassage::energy_kj},
          Quantity{Seen::translation, "translation:", &ObservedPassage::translational_kj}}) {
        Observation observation = named(quantity.seen, joined(quantity.name, id), target);
        for (std::size_t i = 0; i < passages.size(); ++i) {
            if (const std::optional<double>& value = passages[i]->*quantity.value) {
                add(observation, {*value, 0.0}, marks[i]);
            }
        }
        if (!observation.fit.empty() || !observation.held_out.empty()) {
            all.push_back(std::move(observation));
        }
    }
    if (const std::uint64_t rocks = site.observed_events.rocks; rocks > 0 && !passages.empty()) {
        const std::size_t passed = std::min<std::size_t>(passages.size(), rocks);
        Observation share = named(Seen::passing, joined("passing:", id), target);
        for (std::uint64_t i = 0; i < rocks; ++i) {
            add(share, {i < passed ? 1.0 : 0.0, 0.0}, false);  // one figure: nothing to hold out
        }
        all.push_back(std::move(share));
    }
}

/// Views of one thing stand one behind the other.
void number_witnesses(std::vector<Observation>& all) {
    const auto is_view_of = [](const Observation& observation, const Observation& before) {
        switch (observation.seen) {
            case Seen::stops:
            case Seen::scar_heights:
            case Seen::passing:  // the share of all rocks, whatever was measured at those that pass
                return false;
            case Seen::run_out:
                return before.seen == Seen::stops;
            case Seen::scar_places:
                return before.seen == Seen::scar_heights;
            default:
                return before.seen >= Seen::speed && before.target == observation.target;
        }
    };
    for (std::size_t i = 1; i < all.size(); ++i) {
        all[i].witness = all[i - 1].witness + (is_view_of(all[i], all[i - 1]) ? 0U : 1U);
    }
    if (!all.empty() && all.back().witness >= most_witnesses) {
        config::fail(config::ExitCode::data, {"[observed]"},
                     joined(std::to_string(all.back().witness + 1), " groups and targets"),
                     joined("at most ", std::to_string(most_witnesses)), "take groups together");
    }
}

double value_of(const rockfall::Arrival& arrival, Seen seen) {
    switch (seen) {
        case Seen::speed:
            return static_cast<double>(arrival.speed_mps);
        case Seen::height:
            return static_cast<double>(arrival.height_m);
        case Seen::energy:
            return 1e-3 * static_cast<double>(arrival.energy_j);
        default:
            return 1e-3 * static_cast<double>(arrival.translational_j);
    }
}

Sample ends_of(const SetRocks& rocks, const Observation& observation, const Search& search) {
    Sample sample{.is_plane = observation.is_plane()};
    for (const SetRocks::End& end : rocks.ends) {
        const bool from_zone =
            observation.zones.empty() ||
            std::binary_search(observation.zones.begin(), observation.zones.end(), end.zone);
        if (from_zone && !end.left_terrain &&
            static_cast<double>(end.diameter_m) >= search.least_diameter_m &&
            is_looked_at(end.end_m, search)) {
            if (sample.is_plane) {
                sample.points.push_back(end.end_m);
            } else {
                sample.points.emplace_back(observation.sources ? observation.sources->at(end.end_m)
                                                               : (end.end_m - end.start_m).norm(),
                                           0.0);
            }
        }
    }
    return sample;
}

Sample passages_of(const SetRocks& rocks, const Observation& observation) {
    Sample sample;
    for (const SetRocks::Passage& passage : rocks.passages) {
        if (passage.target == observation.target) {
            sample.points.emplace_back(value_of(passage.arrival, observation.seen), 0.0);
        }
    }
    return sample;
}

Sample passing_of(const SetRocks& rocks, const Observation& observation) {
    const auto passed = static_cast<std::size_t>(std::count_if(
        rocks.passages.begin(), rocks.passages.end(),
        [&](const SetRocks::Passage& passage) { return passage.target == observation.target; }));
    Sample sample;
    for (std::size_t i = 0; i < rocks.ends.size(); ++i) {
        sample.points.emplace_back(i < passed ? 1.0 : 0.0, 0.0);
    }
    return sample;
}

}  // namespace

std::vector<Observation> observations_on(const Site& site, const CalibrateSettings& settings,
                                         std::uint64_t seed) {
    HoldOut hold_out{settings, seed};
    std::vector<Observation> all;
    if (!site.observed_stops.empty()) {
        add_stops(site, hold_out, all);
    }
    if (!site.observed_events.scars.empty()) {
        add_scars(site, settings, hold_out, all);
    }
    for (std::uint32_t target = 0; target < site.targets.size(); ++target) {
        add_passages(site, target, hold_out, all);
    }
    number_witnesses(all);
    const auto count = [&](const Sample Observation::*side) {
        std::size_t most = 0;
        for (const Observation& each : all) {
            most = std::max(most, (each.*side).size());
        }
        return most;
    };
    if (all.empty()) {
        config::fail(config::ExitCode::settings, {"[observed]"}, "nothing to fit to",
                     "observed.stops, observed.scars or observed.passages",
                     "name a table or layer of what was seen in the field");
    }
    if (!settings.hold_out_group.empty() && !hold_out.found_group()) {
        config::fail(
            config::ExitCode::settings, {"calibrate.hold_out_group"},
            joined("group ", config::in_quotes(settings.hold_out_group), ", which no observation has"),
            "a value of the column group");
    }
    if (count(&Observation::fit) < least_observed) {
        config::fail(config::ExitCode::data, {"[observed]"},
                     joined(std::to_string(count(&Observation::fit)), " observations to fit to"),
                     joined("at least ", std::to_string(least_observed), " of one kind"),
                     "fewer tell nothing that the widths do not say");
    }
    return all;
}

std::size_t number_of(const std::vector<Observation>& observations, Sample Observation::*side) {
    std::size_t number = 0;
    std::map<std::uint32_t, std::size_t> passages;  // by target: the quantity that was measured most often
    for (const Observation& observation : observations) {
        const std::size_t count = (observation.*side).size();
        switch (observation.seen) {
            case Seen::stops:
            case Seen::scar_heights:
                number += count;
                break;
            case Seen::run_out:
            case Seen::scar_places:
            case Seen::passing:
                break;
            default:
                passages[observation.target] = std::max(passages[observation.target], count);
        }
    }
    for (const auto& [target, count] : passages) {
        number += count;
    }
    return number;
}

Search search_on(const Site& site, const CalibrateSettings& settings) {
    Search search{.window = site.observed_events.window,
                  .least_diameter_m = settings.least_diameter_m,
                  .least_scar_dbh_cm = settings.least_scar_dbh_cm};
    for (config::Shape& polygon : search.window) {
        for (std::vector<config::Point2>& ring : polygon.parts) {
            for (config::Point2& corner : ring) {
                corner.x_m -= site.origin_m().x();
                corner.y_m -= site.origin_m().y();
            }
        }
    }
    return search;
}

Sample seen_of(const SetRocks& rocks, const Observation& observation, const Search& search) {
    switch (observation.seen) {
        case Seen::stops:
        case Seen::run_out:
            return ends_of(rocks, observation, search);
        case Seen::scar_heights:
        case Seen::scar_places: {
            Sample sample{.is_plane = observation.is_plane()};
            for (const SetRocks::Hit& hit : rocks.hits) {
                if (static_cast<double>(hit.dbh_cm) >= search.least_scar_dbh_cm) {
                    sample.points.push_back(sample.is_plane
                                                ? hit.stem_m
                                                : Eigen::Vector2d{static_cast<double>(hit.height_m), 0.0});
                }
            }
            return sample;
        }
        case Seen::passing:
            return passing_of(rocks, observation);
        default:
            return passages_of(rocks, observation);
    }
}

std::vector<double> values_along(const Sample& sample, const SightLine& line) {
    std::vector<double> values;
    values.reserve(sample.size());
    for (const Eigen::Vector2d& point : sample.points) {
        values.push_back(sample.is_plane ? (point - line.from_m).dot(line.along) : point.x());
    }
    std::sort(values.begin(), values.end());
    return values;
}

double figure_of(const Sample& sample, const SightLine& line) {
    if (sample.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    double sum = 0.0;
    for (const double value : values_along(sample, line)) {
        sum += value;
    }
    return sum / static_cast<double>(sample.size());
}

}  // namespace coupling::calibrate
