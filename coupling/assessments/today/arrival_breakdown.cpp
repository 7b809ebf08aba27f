#include "coupling/assessments/today/arrival_breakdown.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/units/constants.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/figures/line_places.hpp"
#include "coupling/results/text/markup.hpp"

namespace coupling {
namespace {

using rockfall::ReleaseSource;

/// A row of arrivals.csv.
struct ArrivalRow {
    std::uint64_t rock = 0;
    std::size_t target = 0;
    Cover cover = Cover::forest;
    rockfall::Arrival arrival;
};

constexpr std::array<std::string_view, 10> arrival_columns_read{
    "rock",      "target_id", "cover",           "x_m",         "y_m", "energy_kj",
    "speed_mps", "height_m",  "centre_height_m", "top_height_m"};

template <class Number>
bool number_in(std::string_view text, Number& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size();
}

/// Takes the rows of arrivals.csv as numbers.
class ArrivalReader {
public:
    ArrivalReader(OwnRows& rows, const Site& site) : rows_{rows}, origin_m_{site.origin_m()} {
        for (std::size_t i = 0; i < site.targets.size(); ++i) {
            numbers_.emplace(site.targets[i].id, i);
        }
        for (std::size_t i = 0; i < places_.size(); ++i) {
            places_[i] = rows.column(arrival_columns_read[i]);
        }
    }

    std::optional<ArrivalRow> next() {
        if (!rows_.next()) {
            return std::nullopt;
        }
        ArrivalRow row;
        double x_m = 0.0;
        double y_m = 0.0;
        float energy_kj = 0.0F;
        const bool is_whole =
            number_in(field(0), row.rock) && number_in(field(3), x_m) && number_in(field(4), y_m) &&
            number_in(field(5), energy_kj) && number_in(field(6), row.arrival.speed_mps) &&
            number_in(field(7), row.arrival.height_m) && number_in(field(8), row.arrival.centre_height_m) &&
            number_in(field(9), row.arrival.top_height_m);
        if (!is_whole) {
            rows_.refuse("a field that is no number");
        }
        const auto target = numbers_.find(field(1));
        if (target == numbers_.end()) {
            rows_.refuse(config::joined("target ", config::in_quotes(std::string{field(1)})));
        }
        row.target = target->second;
        row.cover = field(2) == name_of(Cover::forest) ? Cover::forest : Cover::bare;
        row.arrival.reached = true;
        row.arrival.x_m = static_cast<float>(x_m - origin_m_.x());
        row.arrival.y_m = static_cast<float>(y_m - origin_m_.y());
        row.arrival.energy_j = energy_kj * static_cast<float>(config::j_per_kj);
        return row;
    }

private:
    [[nodiscard]] std::string_view field(std::size_t wanted) const { return rows_.fields()[places_[wanted]]; }

    OwnRows& rows_;
    Eigen::Vector2d origin_m_;
    std::map<std::string, std::size_t, std::less<>> numbers_;
    std::array<std::size_t, arrival_columns_read.size()> places_{};
};

/// Zone and diameter of rocks, as they start.
class Starts {
public:
    Starts(const Scenario& scenario, const Site& site)
        : scenario_{scenario}, site_{site}, common_{start_law(scenario.release)} {}

    [[nodiscard]] const ReleaseSource& source_of(std::uint64_t rock) const {
        return site_.sources[number_of(rock)];
    }
    /// Nothing for a rock whose place lies off the terrain.
    [[nodiscard]] std::optional<double> diameter_of(std::uint64_t rock) const {
        const std::size_t number = number_of(rock);
        const auto start =
            rockfall::start_of(site_.slope, site_.sources[number], static_cast<std::uint32_t>(number),
                               common_, {scenario_.run.seed, 0, 0, rock});
        return start ? std::optional{start->rock.diameter_m} : std::nullopt;
    }
    /// Calls `with` for each rock that starts, with its zone and diameter.
    template <class With>
    void for_each(With&& with) const {
        for (const ReleaseSource& source : site_.sources) {
            for (std::uint64_t rock = source.first_rock; rock < source.first_rock + source.rocks; ++rock) {
                if (const auto diameter_m = diameter_of(rock)) {
                    with(source.zone, *diameter_m);
                }
            }
        }
    }
    [[nodiscard]] rockfall::DiameterRange range() const {
        return rockfall::diameter_range(common_, site_.sources);
    }

private:
    [[nodiscard]] std::size_t number_of(std::uint64_t rock) const {
        const auto after =
            std::upper_bound(site_.sources.begin(), site_.sources.end(), rock,
                             [](std::uint64_t r, const ReleaseSource& s) { return r < s.first_rock; });
        return static_cast<std::size_t>(after - site_.sources.begin()) - 1;
    }

    const Scenario& scenario_;
    const Site& site_;
    rockfall::StartLaw common_;
};

/// Few diameters are a group each; many go into about five classes of even width.
std::vector<ReleaseGroup> size_groups(const Starts& starts) {
    constexpr std::size_t most_diameters = 8;
    constexpr double classes = 5.0;
    const rockfall::DiameterRange range = starts.range();
    if (!(range.largest_m > range.smallest_m)) {
        return {};
    }
    std::set<double> diameters_m;
    starts.for_each([&](std::uint32_t, double diameter_m) {
        if (diameters_m.size() <= most_diameters) {
            diameters_m.insert(diameter_m);
        }
    });
    std::vector<ReleaseGroup> groups;
    if (diameters_m.size() <= most_diameters) {
        for (const double diameter_m : diameters_m) {
            groups.push_back({.smallest_m = diameter_m, .largest_m = diameter_m, .targets = {}});
        }
        return groups;
    }
    const double width_m = report::nice_step((range.largest_m - range.smallest_m) / classes);
    const double first_m = std::floor(range.smallest_m / width_m + 1e-9) * width_m;
    const auto count = static_cast<int>(std::ceil((range.largest_m - first_m) / width_m - 1e-9));
    for (int i = 0; i < count; ++i) {
        groups.push_back(
            {.smallest_m = first_m + i * width_m, .largest_m = first_m + (i + 1) * width_m, .targets = {}});
    }
    return groups;
}

/// The group of a diameter: the last whose smallest one it does not lie below.
ReleaseGroup& group_of(std::vector<ReleaseGroup>& groups, double diameter_m) {
    const auto after =
        std::upper_bound(groups.begin(), groups.end(), diameter_m,
                         [](double d, const ReleaseGroup& group) { return d < group.smallest_m; });
    return after == groups.begin() ? groups.front() : *(after - 1);
}

std::vector<ReleaseGroup> zone_groups(const Site& site) {
    std::set<std::uint32_t> zones;
    for (const ReleaseSource& source : site.sources) {
        zones.insert(source.zone);
    }
    std::vector<ReleaseGroup> groups;
    for (const std::uint32_t zone : zones) {
        groups.push_back({.zone = zone, .targets = {}});
    }
    return groups;
}

ReleaseGroup& group_of_zone(std::vector<ReleaseGroup>& groups, std::uint32_t zone) {
    return *std::lower_bound(groups.begin(), groups.end(), zone,
                             [](const ReleaseGroup& group, std::uint32_t z) { return group.zone < z; });
}

AlongLine empty_line(std::size_t number, const LinePlaces& places, const Eigen::Vector2d& origin_m) {
    AlongLine line{.target = number, .stretches = {}, .moved = {}};
    const auto count = static_cast<int>(std::ceil(places.length_m() / stretch_m - 1e-9));
    for (int i = 0; i < count; ++i) {
        const double from_m = i * stretch_m;
        const double to_m = std::min(from_m + stretch_m, places.length_m());
        line.stretches.push_back({.from_m = from_m,
                                  .to_m = to_m,
                                  .middle_m = places.at(0.5 * (from_m + to_m)) + origin_m,
                                  .tally = {}});
    }
    return line;
}

/// Puts the arrivals of all rocks where they belong.
class Sorter {
public:
    Sorter(const Scenario& scenario, const Site& site) : starts_{scenario, site} {
        of_line_.resize(site.targets.size());
        for (std::size_t i = 0; i < site.targets.size(); ++i) {
            if (!site.targets[i].is_area) {
                places_.emplace_back(site.targets[i]);
                of_line_[i] = places_.size();
                found_.lines.push_back(empty_line(i, places_.back(), site.origin_m()));
            }
        }
        found_.is_known = true;
        if (site.targets.size() <= most_targets_of_groups) {
            found_.zones = zone_groups(site);
            found_.sizes = size_groups(starts_);
            for (auto* groups : {&found_.zones, &found_.sizes}) {
                for (ReleaseGroup& group : *groups) {
                    group.targets.resize(site.targets.size());
                }
            }
            starts_.for_each([&](std::uint32_t zone, double diameter_m) {
                ++group_of_zone(found_.zones, zone).released;
                if (!found_.sizes.empty()) {
                    ++group_of(found_.sizes, diameter_m).released;
                }
            });
        }
    }

    void add(const ArrivalRow& row) {
        const std::optional<std::size_t> stretch = stretch_of(row);
        const std::optional<FirstArrival> with_forest = first_arrival(row, stretch);
        for (rockfall::TargetTally* tally : groups_of(row)) {
            tally->by_cover[index_of(row.cover)].add(row.arrival);
            tally->reached_both += with_forest ? 1U : 0U;
        }
        if (stretch) {
            AlongLine& line = found_.lines[of_line_[row.target] - 1];
            rockfall::TargetTally& tally = line.stretches[*stretch].tally;
            tally.by_cover[index_of(row.cover)].add(row.arrival);
            if (with_forest && with_forest->stretch == stretch) {
                ++tally.reached_both;
            } else if (with_forest) {
                line.moved.push_back({*with_forest->stretch, *stretch});
            }
        }
    }
    [[nodiscard]] Breakdown found() && { return std::move(found_); }

private:
    /// Where a rock that arrives over the bare slope arrived with forest.
    struct FirstArrival {
        std::optional<std::size_t> stretch;  ///< nothing for an area
    };

    /// The arrival of the same rock at the same target with forest, for a row of the bare slope. Rows come in
    /// turns: some thousand rocks with forest, then the same ones over the bare slope.
    std::optional<FirstArrival> first_arrival(const ArrivalRow& row, std::optional<std::size_t> stretch) {
        if (row.cover == Cover::forest) {
            if (bare_before_) {
                with_forest_.clear();
            }
            bare_before_ = false;
            with_forest_.insert({{row.target, row.rock}, {stretch}});
            return std::nullopt;
        }
        bare_before_ = true;
        const auto found = with_forest_.find({row.target, row.rock});
        return found == with_forest_.end() ? std::nullopt : std::optional{found->second};
    }

    /// The number of the stretch that a rock reaches; nothing for an area.
    [[nodiscard]] std::optional<std::size_t> stretch_of(const ArrivalRow& row) const {
        if (of_line_[row.target] == 0) {
            return std::nullopt;
        }
        const std::size_t line = of_line_[row.target] - 1;
        const std::size_t count = found_.lines[line].stretches.size();
        if (count == 0) {
            return std::nullopt;
        }
        const Eigen::Vector2d place_m{static_cast<double>(row.arrival.x_m),
                                      static_cast<double>(row.arrival.y_m)};
        return std::min(static_cast<std::size_t>(places_[line].distance_of(place_m) / stretch_m), count - 1);
    }

    /// The tallies of its release zone and of its size.
    std::vector<rockfall::TargetTally*> groups_of(const ArrivalRow& row) {
        std::vector<rockfall::TargetTally*> tallies;
        if (!found_.zones.empty()) {
            const std::uint32_t zone = starts_.source_of(row.rock).zone;
            tallies.push_back(&group_of_zone(found_.zones, zone).targets[row.target]);
        }
        if (!found_.sizes.empty()) {
            const double diameter_m = starts_.diameter_of(row.rock).value_or(0.0);
            tallies.push_back(&group_of(found_.sizes, diameter_m).targets[row.target]);
        }
        return tallies;
    }

    Starts starts_;
    std::vector<LinePlaces> places_;
    std::vector<std::size_t> of_line_;  ///< by target: 1 + the place of its line; 0: an area
    std::map<std::pair<std::size_t, std::uint64_t>, FirstArrival> with_forest_;
    bool bare_before_ = false;
    Breakdown found_;
};

}  // namespace

Breakdown breakdown_of(OwnRows& arrivals, const Scenario& scenario, const Site& site) {
    Sorter sorter{scenario, site};
    ArrivalReader reader{arrivals, site};
    while (const std::optional<ArrivalRow> row = reader.next()) {
        sorter.add(*row);
    }
    return std::move(sorter).found();
}

Breakdown breakdown_of(const StreamedTables& streamed, const Scenario& scenario, const Site& site) {
    if (site.targets.empty() || !scenario.output.arrival_table) {
        return {};
    }
    OwnRows arrivals{streamed.folder / "arrivals.csv", streamed.end_of("arrivals.csv")};
    return breakdown_of(arrivals, scenario, site);
}

}  // namespace coupling
