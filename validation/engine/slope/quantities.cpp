#include "validation/engine/slope/quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>

#include "config/text/joined.hpp"
#include "config/units/constants.hpp"

namespace coupling::validation {
namespace {

using config::j_per_kj;
using config::joined;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Mean and standard deviation (n - 1) of numbers; NaN of too few.
class Moments {
public:
    void add(double value) {
        ++count_;
        const double step = value - mean_;
        mean_ += step / static_cast<double>(count_);
        squares_ += step * (value - mean_);
    }
    [[nodiscard]] double mean() const { return count_ > 0 ? mean_ : none; }
    [[nodiscard]] double deviation() const {
        return count_ > 1 ? std::sqrt(squares_ / static_cast<double>(count_ - 1)) : none;
    }

private:
    std::size_t count_ = 0;
    double mean_ = 0.0;
    double squares_ = 0.0;
};

template <class Of>
Moments over_rocks(const Falls& falls, Of of) {
    Moments moments;
    for (const RockFacts& rock : falls.rocks) {
        moments.add(of(rock));
    }
    return moments;
}

template <class Of>
std::vector<double> each_rock(const Falls& falls, Of of) {
    std::vector<double> values;
    values.reserve(falls.rocks.size());
    for (const RockFacts& rock : falls.rocks) {
        values.push_back(of(rock));
    }
    return values;
}

template <class Of>
double largest(const Falls& falls, Of of) {
    double most = falls.rocks.empty() ? none : -std::numeric_limits<double>::infinity();
    for (const RockFacts& rock : falls.rocks) {
        most = std::max(most, of(rock));
    }
    return most;
}

/// Values of the rocks that arrive at a line.
template <class Of>
std::vector<double> each_arrival(const Falls& falls, std::size_t line, Of of) {
    std::vector<double> values;
    for (std::size_t rock = 0; rock < falls.rocks.size(); ++rock) {
        const rockfall::Arrival& arrival = falls.arrival(rock, line);
        if (arrival.reached) {
            values.push_back(of(arrival));
        }
    }
    return values;
}

Moments moments_of(const std::vector<double>& values) {
    Moments moments;
    for (const double value : values) {
        moments.add(value);
    }
    return moments;
}

/// A sum over all rocks divided by a count over all rocks.
template <class Sum, class Count>
double ratio(const Falls& falls, Sum sum_of, Count count_of) {
    double sum = 0.0;
    double count = 0.0;
    for (const RockFacts& rock : falls.rocks) {
        sum += sum_of(rock);
        count += static_cast<double>(count_of(rock));
    }
    return count > 0.0 ? sum / count : none;
}

double max_speed(const RockFacts& rock) {
    return rock.max_speed_mps;
}
double max_height(const RockFacts& rock) {
    return rock.max_height_m;
}
double kilojoules(const rockfall::Arrival& arrival) {
    return arrival.energy_j / j_per_kj;
}
double translational_kj(const rockfall::Arrival& arrival) {
    return arrival.translational_j / j_per_kj;
}
double speed(const rockfall::Arrival& arrival) {
    return arrival.speed_mps;
}

double jump_height_mean(const Falls& falls) {
    return ratio(
        falls, [](const RockFacts& rock) { return rock.jump_height_sum_m; },
        [](const RockFacts& rock) { return rock.jumps; });
}

double hit_height_mean(const Falls& falls) {
    Moments moments;
    for (const float height_m : falls.hit_heights_m) {
        moments.add(height_m);
    }
    return moments.mean();
}

double stopped_share(const Falls& falls, const Section& section) {
    return over_rocks(falls,
                      [&](const RockFacts& rock) {
                          return rock.stopped() && rock.end_m >= section.from_m && rock.end_m < section.to_m
                                     ? 1.0
                                     : 0.0;
                      })
        .mean();
}

double reaching_share(const Falls& falls, std::size_t line) {
    return falls.rocks.empty() ? none
                               : static_cast<double>(each_arrival(falls, line, speed).size()) /
                                     static_cast<double>(falls.rocks.size());
}

/// Width between the 2.5 and 97.5 percentile of the places where rocks pass the lower end, divided by the
/// length of the slope.
double lateral_dispersion(const Falls& falls, const FigureFrame& frame) {
    constexpr std::size_t fewest = 40;  // two in the tails
    const std::vector<double> across_m = each_arrival(
        falls, falls.lines - 1, [](const rockfall::Arrival& a) { return static_cast<double>(a.y_m); });
    return across_m.size() < fewest
               ? none
               : (quantile(across_m, 0.975) - quantile(across_m, 0.025)) / frame.slope_length_m;
}

using About = Quantity::About;
using F = const Falls&;
using S = const FigureFrame&;
using P = std::size_t;

std::vector<Quantity> speeds_and_heights() {
    return {
        {"max_speed_mean_mps", "mean of maximum speeds", "m/s", About::all_rocks,
         [](F f, S, P) { return over_rocks(f, max_speed).mean(); }},
        {"max_speed_p90_mps", "90 % of maximum speeds", "m/s", About::all_rocks,
         [](F f, S, P) { return quantile(each_rock(f, max_speed), 0.9); }},
        {"max_speed_max_mps", "largest speed", "m/s", About::all_rocks,
         [](F f, S, P) { return largest(f, max_speed); }},
        {"mean_speed_mps", "mean speed", "m/s", About::all_rocks,
         [](F f, S, P) { return over_rocks(f, [](const RockFacts& r) { return r.mean_speed_mps; }).mean(); }},
        {"max_height_max_m", "largest height of underside", "m", About::all_rocks,
         [](F f, S, P) { return largest(f, max_height); }},
        {"max_height_p90_m", "90 % of largest heights, underside", "m", About::all_rocks,
         [](F f, S, P) { return quantile(each_rock(f, max_height), 0.9); }},
        {"jump_height_mean_m", "mean jump height, underside", "m", About::all_rocks,
         [](F f, S, P) { return jump_height_mean(f); }},
        {"max_height_max_centre_m", "largest height of centre", "m", About::all_rocks,
         [](F f, S s, P) { return largest(f, max_height) + s.radius_m; }},
        {"max_height_p90_centre_m", "90 % of largest heights, centre", "m", About::all_rocks,
         [](F f, S s, P) { return quantile(each_rock(f, max_height), 0.9) + s.radius_m; }},
        {"jump_height_mean_centre_m", "mean jump height, centre", "m", About::all_rocks,
         [](F f, S s, P) { return jump_height_mean(f) + s.radius_m; }},
    };
}

std::vector<Quantity> hits_and_run_out() {
    return {
        {"tree_hits_mean", "tree hits per rock", "-", About::all_rocks,
         [](F f, S, P) {
             return over_rocks(f, [](const RockFacts& r) { return static_cast<double>(r.tree_hits); }).mean();
         }},
        {"hit_height_mean_m", "mean height of tree hits", "m", About::all_rocks,
         [](F f, S, P) { return hit_height_mean(f); }},
        {"broken_share", "hits that break the tree", "-", About::all_rocks,
         [](F f, S, P) {
             return ratio(
                 f, [](const RockFacts& r) { return static_cast<double>(r.trees_broken); },
                 [](const RockFacts& r) { return r.tree_hits; });
         }},
        {"run_out_mean_m", "mean run-out", "m", About::all_rocks,
         [](F f, S s, P) {
             return over_rocks(f, [](const RockFacts& r) { return r.end_m; }).mean() - s.start_m;
         }},
        {"run_out_deviation_m", "deviation of run-out between rocks", "m", About::all_rocks,
         [](F f, S, P) { return over_rocks(f, [](const RockFacts& r) { return r.end_m; }).deviation(); }},
        {"impacts_mean", "ground impacts per rock", "-", About::all_rocks,
         [](F f, S, P) {
             return over_rocks(f, [](const RockFacts& r) { return static_cast<double>(r.impacts); }).mean();
         }},
        {"jump_length_mean_m", "mean plan length of jumps", "m", About::all_rocks,
         [](F f, S, P) {
             return ratio(
                 f, [](const RockFacts& r) { return r.jump_length_sum_m; },
                 [](const RockFacts& r) { return r.landed_jumps; });
         }},
        {"lateral_dispersion", "width of 95 % / slope length", "-", About::all_rocks,
         [](F f, S s, P) { return lateral_dispersion(f, s); }},
    };
}

std::vector<Quantity> places() {
    return {
        {"stopped_share", "share stopping in", "-", About::section,
         [](F f, S s, P p) { return stopped_share(f, s.sections[p]); }},
        {"reaching_share", "share reaching", "-", About::station,
         [](F f, S, P p) { return reaching_share(f, p); }},
        {"energy_mean_kj", "mean energy at", "kJ", About::station,
         [](F f, S, P p) { return moments_of(each_arrival(f, p, kilojoules)).mean(); }},
        {"energy_deviation_kj", "deviation of energy between rocks at", "kJ", About::station,
         [](F f, S, P p) { return moments_of(each_arrival(f, p, kilojoules)).deviation(); }},
        {"energy_p90_kj", "90 % of energies at", "kJ", About::station,
         [](F f, S, P p) { return quantile(each_arrival(f, p, kilojoules), 0.9); }},
        {"translational_mean_kj", "mean translational energy at", "kJ", About::station,
         [](F f, S, P p) { return moments_of(each_arrival(f, p, translational_kj)).mean(); }},
        {"speed_mean_mps", "mean speed at", "m/s", About::station,
         [](F f, S, P p) { return moments_of(each_arrival(f, p, speed)).mean(); }},
    };
}

constexpr std::string_view open_prefix = "open.";
constexpr std::string_view reduction_prefix = "reduction.";

/// Names of the places that a quantity is about; one empty name where it is about all rocks.
std::vector<std::string> places_of(const Quantity& quantity, const FigureFrame& frame) {
    if (quantity.about == About::station) {
        return frame.stations;
    }
    if (quantity.about == About::section) {
        std::vector<std::string> names;
        for (const Section& section : frame.sections) {
            names.push_back(section.name);
        }
        return names;
    }
    return {""};
}

std::string full_name(const Quantity& quantity, const std::string& place) {
    return quantity.about == About::all_rocks ? quantity.name : joined(quantity.name, ":", place);
}

}  // namespace

std::span<const Quantity> quantities() {
    static const std::vector<Quantity> all = [] {
        std::vector<Quantity> list = speeds_and_heights();
        for (auto&& more : {hits_and_run_out(), places()}) {
            list.insert(list.end(), more.begin(), more.end());
        }
        return list;
    }();
    return all;
}

std::string FigureName::label() const {
    const std::string text = place.empty() ? quantity->label : joined(quantity->label, " ", place);
    switch (cover) {
        case Cover::open:
            return text + ", bare slope";
        case Cover::reduction:
            return "reduction of " + text;
        case Cover::as_is:
            break;
    }
    return text;
}

std::string FigureName::unit() const {
    return cover == Cover::reduction ? "-" : quantity->unit;
}

std::optional<FigureName> parse_figure(std::string_view name) {
    FigureName figure;
    if (name.starts_with(open_prefix)) {
        figure.cover = FigureName::Cover::open;
        name.remove_prefix(open_prefix.size());
    } else if (name.starts_with(reduction_prefix)) {
        figure.cover = FigureName::Cover::reduction;
        name.remove_prefix(reduction_prefix.size());
    }
    const std::size_t colon = std::min(name.find(':'), name.size());
    const std::string_view quantity = name.substr(0, colon);
    figure.place = std::string{name.substr(std::min(colon + 1, name.size()))};
    for (const Quantity& known : quantities()) {
        if (known.name == quantity && (known.about != About::all_rocks) == !figure.place.empty()) {
            figure.quantity = &known;
            return figure;
        }
    }
    return std::nullopt;
}

std::vector<std::string> figure_names(const FigureFrame& frame, bool with_open) {
    std::vector<std::string> names;
    for (const Quantity& quantity : quantities()) {
        for (const std::string& place : places_of(quantity, frame)) {
            names.push_back(full_name(quantity, place));
        }
    }
    const std::size_t count = names.size();
    for (std::size_t i = 0; with_open && i < count; ++i) {
        names.push_back(joined(open_prefix, names[i]));
        names.push_back(joined(reduction_prefix, names[i]));
    }
    return names;
}

std::map<std::string, double> figures_of(const Falls& falls, const FigureFrame& frame) {
    std::map<std::string, double> figures;
    for (const Quantity& quantity : quantities()) {
        const std::vector<std::string> names = places_of(quantity, frame);
        for (std::size_t place = 0; place < names.size(); ++place) {
            figures[full_name(quantity, names[place])] = quantity.value(falls, frame, place);
        }
    }
    return figures;
}

void add_open(std::map<std::string, double>& figures, const std::map<std::string, double>& open) {
    for (const auto& [name, value] : open) {
        const double forest = figures.at(name);
        figures[joined(open_prefix, name)] = value;
        figures[joined(reduction_prefix, name)] = value != 0.0 ? 1.0 - forest / value : none;
    }
}

void write_quantities(std::ostream& out) {
    for (const Quantity& quantity : quantities()) {
        const char* place = quantity.about == About::station   ? ":STATION"
                            : quantity.about == About::section ? ":SECTION"
                                                               : "";
        out << "  " << std::left << std::setw(30) << joined(quantity.name, place) << std::setw(5)
            << quantity.unit << ' ' << quantity.label << '\n';
    }
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) {
        return none;
    }
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace coupling::validation
