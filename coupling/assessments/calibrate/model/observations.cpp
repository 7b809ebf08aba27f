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
#include "coupling/assessments/calibrate/model/hold_out.hpp"
#include "coupling/assessments/calibrate/model/jumps.hpp"
#include "coupling/assessments/calibrate/model/random.hpp"

namespace coupling::calibrate {
namespace {

using config::joined;

/// Fewer of a kind are not worth a search.
constexpr std::size_t least_observed = 8;
void add(Observation& observation, const Eigen::Vector2d& point, bool is_held_out) {
    (is_held_out ? observation.held_out : observation.fit).points.push_back(point);
}

std::uint16_t kind_of(Seen seen) {
    return static_cast<std::uint16_t>(seen);
}

Observation named(Seen seen, std::string name, std::uint32_t target = 0) {
    Observation observation{.seen = seen, .name = std::move(name), .target = target};
    observation.fit.is_plane = observation.held_out.is_plane = observation.is_plane();
    return observation;
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
    const std::vector<bool> marks = hold_out.of(kind_of(Seen::stops), groups);
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
    const std::vector<bool> marks = hold_out.of(kind_of(Seen::scar_heights), groups);
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
    // Where stems were searched, they say it better.
    if (all_have_places && site.observed_events.trees.empty()) {
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
    const std::vector<bool> marks = hold_out.of(kind_of(Seen::speed), groups);
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

/// Where the wounds are among some searched stems, and how many there are.
void add_wounds(SurveyedTrees of_side, bool is_held_out, bool counts, std::uint64_t rocks,
                std::vector<Observation>& all) {
    const auto trees = std::make_shared<const SurveyedTrees>(std::move(of_side));
    Observation diameters = named(Seen::tree_dbh, "tree_dbh");
    Observation places = named(Seen::tree_places, "tree_places");
    Observation scars = named(Seen::tree_scars, "tree_scars");
    diameters.trees = places.trees = scars.trees = trees;
    scars.rocks = rocks;
    for (const SurveyedTrees::Tree& tree : trees->trees()) {
        add(scars, {static_cast<double>(tree.scars), 0.0}, is_held_out);
        for (std::uint64_t k = 0; k < tree.scars; ++k) {
            add(diameters, {tree.dbh_cm, 0.0}, is_held_out);
            add(places, tree.stem_m, is_held_out);
        }
    }
    if (trees->scars() > 0) {
        all.push_back(std::move(diameters));
        all.push_back(std::move(places));
    }
    // So many wounds come of so many rocks: of unknown ones nothing follows.
    if (counts && !trees->trees().empty()) {
        all.push_back(std::move(scars));
    }
}

/// A stem is held out with all its wounds: simulated hits on it are held against them, and those on all
/// others against theirs.
void add_trees(const Site& site, const CalibrateSettings& settings, HoldOut& hold_out,
               std::vector<Observation>& all) {
    const SurveyedTrees trees{site, settings.least_scar_dbh_cm};
    const std::vector<bool> marks =
        hold_out.of(kind_of(Seen::tree_scars), std::vector<std::string>(trees.trees().size()));
    for (const bool is_held_out : {false, true}) {
        add_wounds(trees.with_mark(marks, is_held_out), is_held_out, can_count_scars(site, settings),
                   site.observed_events.rocks, all);
    }
}

/// The share of blocks within an outline, and how far it reaches. Neither can be held out.
void add_outline(const Site& site, const CalibrateSettings& settings, std::vector<Observation>& all) {
    const auto outline = std::make_shared<const Outline>(site, settings);
    Observation share = named(Seen::outline_share, "outline_share");
    Observation reach = named(Seen::outline_reach, "outline_reach");
    share.outline = reach.outline = outline;
    const auto within =
        static_cast<std::size_t>(std::llround(outline->share_within * static_cast<double>(outline->blocks)));
    for (std::size_t i = 0; i < outline->blocks; ++i) {
        add(share, {i < within ? 1.0 : 0.0, 0.0}, false);
    }
    add(reach, {outline->reach_m, 0.0}, false);
    all.push_back(std::move(share));
    all.push_back(std::move(reach));
}

/// Lengths of jumps between impacts of one track.
void add_jumps(const Site& site, const CalibrateSettings& settings, HoldOut& hold_out,
               std::vector<Observation>& all) {
    std::vector<TrackJump> jumps = jumps_along(site.observed_events.impacts);
    Observation lengths = named(Seen::jumps, "jumps");
    lengths.least_jump_m = least_jump_m(jumps, settings);
    std::erase_if(jumps, [&](const TrackJump& jump) { return jump.length_m < lengths.least_jump_m; });
    if (jumps.empty()) {
        return;
    }
    lengths.grounds = grounds_of(jumps);
    std::vector<std::string> groups;
    for (const TrackJump& jump : jumps) {
        groups.push_back(jump.group);
    }
    const std::vector<bool> marks = hold_out.of(kind_of(Seen::jumps), groups);
    for (std::size_t i = 0; i < jumps.size(); ++i) {
        add(lengths, {jumps[i].length_m, 0.0}, marks[i]);
    }
    all.push_back(std::move(lengths));
}

/// Views of one thing stand one behind the other.
void number_witnesses(std::vector<Observation>& all, const std::string& scenario) {
    const auto is_view_of = [](const Observation& observation, const Observation& before) {
        switch (observation.seen) {
            case Seen::stops:
            case Seen::scar_heights:
            case Seen::passing:  // the share of all rocks, whatever was measured at those that pass
            case Seen::tree_dbh:
            case Seen::tree_scars:
            case Seen::outline_share:
            case Seen::outline_reach:
            case Seen::jumps:
                return false;
            case Seen::run_out:
                return before.seen == Seen::stops;
            case Seen::scar_places:
                return before.seen == Seen::scar_heights;
            case Seen::tree_places:
                return before.seen == Seen::tree_dbh;
            default:
                return before.seen >= Seen::speed && before.seen <= Seen::passing &&
                       before.target == observation.target;
        }
    };
    for (std::size_t i = 1; i < all.size(); ++i) {
        all[i].witness = all[i - 1].witness + (is_view_of(all[i], all[i - 1]) ? 0U : 1U);
    }
    if (!all.empty() && all.back().witness >= most_witnesses) {
        config::fail(config::ExitCode::data, {scenario},
                     joined(std::to_string(all.back().witness + 1), " groups and targets"),
                     joined("at most ", std::to_string(most_witnesses)), "take groups together");
    }
}

}  // namespace

std::vector<Observation> observations_on(const Site& site, const CalibrateSettings& settings,
                                         std::uint64_t seed, const std::string& scenario) {
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
    if (!site.observed_events.trees.empty()) {
        add_trees(site, settings, hold_out, all);
    }
    if (!site.observed_events.outline.empty()) {
        add_outline(site, settings, all);
    }
    add_jumps(site, settings, hold_out, all);
    number_witnesses(all, scenario);
    const auto count = [&](const Sample Observation::*side) {
        std::size_t most = 0;
        for (const Observation& each : all) {
            most = std::max(most, (each.*side).size());
        }
        return most;
    };
    if (all.empty()) {
        config::fail(config::ExitCode::settings, {scenario}, "nothing to fit to",
                     "a file of section [observed], such as observed.stops or observed.scars",
                     "name a table or layer of what was seen in the field");
    }
    if (!settings.hold_out_group.empty() && !hold_out.found_group()) {
        config::fail(config::ExitCode::settings, {scenario},
                     joined("calibrate.hold_out_group = ", config::in_quotes(settings.hold_out_group),
                            ", a group that no observation has"),
                     "a value of the column group");
    }
    if (count(&Observation::fit) < least_observed) {
        config::fail(config::ExitCode::data, {scenario},
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
            case Seen::tree_dbh:
            case Seen::jumps:
            case Seen::outline_reach:  // one figure of one outline
                number += count;
                break;
            case Seen::run_out:
            case Seen::scar_places:
            case Seen::passing:
            case Seen::tree_places:
            case Seen::tree_scars:
            case Seen::outline_share:
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
    move_to_terrain(search.window, site);
    return search;
}

double Observation::least_scale() const {
    if (seen == Seen::outline_reach) {
        return 2.0 * outline->sources.cell_m();
    }
    if (seen != Seen::tree_scars && seen != Seen::outline_share) {
        return 0.0;
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, fit.size()));
    return 2.0 / (count * count);
}

bool can_count_scars(const Site& site, const CalibrateSettings& settings) {
    return site.observed_events.rocks > 0 && site.observed_events.rocks <= settings.rocks;
}

bool is_looked_at(const Eigen::Vector2d& place_m, const Search& search) {
    return search.window.empty() || lies_within(search.window, place_m);
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
