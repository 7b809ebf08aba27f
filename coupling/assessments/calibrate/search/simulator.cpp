#include "coupling/assessments/calibrate/search/simulator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/math/elementary.hpp"
#include "config/text/joined.hpp"
#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/assessments/calibrate/model/seen_of.hpp"
#include "coupling/assessments/calibrate/search/self_distance.hpp"
#include "coupling/inputs/observed/distribution.hpp"
#include "coupling/run/interrupt.hpp"

namespace coupling::calibrate {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Mean and standard deviation of what is added.
class Moments {
public:
    void add(double value) {
        count_ += 1.0;
        const double off = value - mean_;
        mean_ += off / count_;
        squares_ += off * (value - mean_);
    }
    [[nodiscard]] double mean() const { return count_ > 0.0 ? mean_ : unknown; }
    [[nodiscard]] double deviation() const {
        return count_ > 1.0 ? std::sqrt(squares_ / (count_ - 1.0)) : unknown;
    }

private:
    double count_ = 0.0;
    double mean_ = 0.0;
    double squares_ = 0.0;
};

/// What a set shows, without samples, as numbers for other ranks: the lengths of the lists before each.
void append(std::vector<double>& numbers, const Shown& shown) {
    for (const std::vector<double>* list : {&shown.distances, &shown.summary, &shown.figures}) {
        numbers.push_back(static_cast<double>(list->size()));
        numbers.insert(numbers.end(), list->begin(), list->end());
    }
}

/// The first one of those numbers, which are left out of `rest` then.
Shown next_in(std::span<const double>& rest) {
    Shown shown;
    for (std::vector<double>* list : {&shown.distances, &shown.summary, &shown.figures}) {
        const auto length = static_cast<std::size_t>(rest.front());
        list->assign(rest.begin() + 1, rest.begin() + 1 + static_cast<std::ptrdiff_t>(length));
        rest = rest.subspan(1 + length);
    }
    return shown;
}

}  // namespace

void add_summary(const Sample& sample, const SightLine& line, std::vector<double>& summary) {
    const observed::Distribution values{values_along(sample, line)};
    constexpr double least_deviation = 1e-3;
    const double deviation = values.count() > 1 ? values.deviation() : 0.0;
    summary.insert(summary.end(), {values.mean(), values.quantile(0.5),
                                   config::log2_of(std::max(least_deviation, deviation))});
    if (sample.is_plane) {
        const Eigen::Vector2d across{-line.along.y(), line.along.x()};
        summary.push_back(observed::Distribution{values_along(sample, {line.from_m, across})}.mean());
    }
}

Simulator::Simulator(std::vector<const SiteCase*> sites, const SharedComponents& shared, std::uint64_t seed,
                     int threads, RankGroup& ranks)
    : sites_{std::move(sites)},
      space_{shared.components},
      places_{shared.places},
      seed_{seed},
      threads_{threads},
      ranks_{ranks} {
    std::uint32_t witnesses = 0;
    for (std::uint32_t site = 0; site < sites_.size(); ++site) {
        const SiteCase& of_site = *sites_[site];
        for (Observation observation : of_site.observations) {
            observation.site = site;
            observation.witness += witnesses;
            observations_.push_back(std::move(observation));
        }
        witnesses = observations_.back().witness + 1;
        lines_.insert(lines_.end(), of_site.lines.begin(), of_site.lines.end());
    }
    if (witnesses > most_witnesses) {
        config::fail(config::ExitCode::data, {"[observed]"},
                     config::joined(std::to_string(witnesses), " groups and targets"),
                     config::joined("at most ", std::to_string(most_witnesses)), "take groups together");
    }
}

std::vector<SurveyFigure> Simulator::figures() const {
    std::vector<SurveyFigure> figures;
    for (std::size_t site = 0; site < sites_.size(); ++site) {
        const auto add = [&](std::string name) { figures.push_back({std::move(name), site}); };
        add("run_out_mean_m");
        add("run_out_deviation_m");
        if (!sites_[site]->falls.assessment.only_bare()) {
            add("scar_height_mean_m");
            add("tree_hits_per_rock");
        }
        for (const rockfall::Target& target : sites_[site]->site.targets) {
            add(config::joined("passing:", target.id));
            add(config::joined("speed_mps:", target.id));
            add(config::joined("height_m:", target.id));
        }
    }
    return figures;
}

namespace {

/// Adds what a survey of a site could measure.
void add_figures(const SetRocks& rocks, const SiteCase& of_site, std::vector<double>& figures) {
    Moments run_out;
    for (const SetRocks::End& end : rocks.ends) {
        run_out.add((end.end_m - end.start_m).norm());
    }
    figures.insert(figures.end(), {run_out.mean(), run_out.deviation()});
    const auto all = static_cast<double>(rocks.ends.size());
    if (!of_site.falls.assessment.only_bare()) {
        Moments heights;
        for (const SetRocks::Hit& hit : rocks.hits) {
            heights.add(static_cast<double>(hit.height_m));
        }
        figures.push_back(heights.mean());
        figures.push_back(static_cast<double>(rocks.hits.size()) / all);
    }
    for (std::uint32_t target = 0; target < of_site.site.targets.size(); ++target) {
        Moments speed;
        Moments height;
        double passed = 0.0;
        for (const SetRocks::Passage& passage : rocks.passages) {
            if (passage.target == target) {
                passed += 1.0;
                speed.add(static_cast<double>(passage.arrival.speed_mps));
                height.add(static_cast<double>(passage.arrival.height_m));
            }
        }
        figures.insert(figures.end(), {passed / all, speed.mean(), height.mean()});
    }
}

/// Stops that an outline could be drawn around.
Sample stops_of(const SetRocks& rocks, const SiteCase& site) {
    static const Observation any_stop{.seen = Seen::stops, .name = "stops"};
    return site.site.observed_events.outline.empty() ? Sample{.is_plane = true}
                                                     : seen_of(rocks, any_stop, site.search);
}

bool sees_jumps(const SiteCase& site) {
    return std::any_of(site.observations.begin(), site.observations.end(),
                       [](const Observation& observation) { return observation.seen == Seen::jumps; });
}

}  // namespace

void Simulator::show(std::span<const Point> points, std::uint16_t wave, std::uint32_t first,
                     std::uint64_t rocks, const std::function<void(std::size_t, Shown&)>& take) const {
    if (ranks_.count() == 1) {
        fall(points, wave, first, rocks, [&](std::size_t i, Shown& shown) {
            shown.samples.clear();
            shown.stops.clear();
            take(i, shown);
        });
        return;
    }
    const auto [begin, end] = ranks_.share_of(points.size());
    std::vector<double> own;
    fall(points.subspan(begin, end - begin), wave, first + static_cast<std::uint32_t>(begin), rocks,
         [&](std::size_t, Shown& shown) { append(own, shown); });
    std::size_t number = 0;
    for (const std::vector<double>& list : ranks_.of_all(own)) {
        for (std::span<const double> rest = list; !rest.empty(); ++number) {
            Shown shown = next_in(rest);
            take(number, shown);
        }
    }
}

void Simulator::fall(std::span<const Point> points, std::uint16_t wave, std::uint32_t first,
                     std::uint64_t rocks, const std::function<void(std::size_t, Shown&)>& take) const {
    struct Worker {
        std::vector<SetFalls> falls;  ///< by site
        SetRocks rocks;
        Shown shown;
    };
    std::vector<Worker> workers(static_cast<std::size_t>(threads_));
    for (Worker& worker : workers) {
        for (const SiteCase* site : sites_) {
            worker.falls.emplace_back(site->falls.assessment, rocks, sees_jumps(*site));
        }
    }
    const std::size_t done = in_order(
        points.size(), workers,
        [&](Worker& worker, std::size_t i) {
            const std::uint32_t number = first + static_cast<std::uint32_t>(i);
            const std::vector<double> factors = space_.factors_of(points[i]);
            worker.shown.samples.clear();
            worker.shown.stops.clear();
            worker.shown.figures.clear();
            for (std::size_t site = 0; site < sites_.size(); ++site) {
                const SiteCase& of_site = *sites_[site];
                std::vector<double> own_factors;
                for (const std::size_t place : places_[site]) {
                    own_factors.push_back(factors[place]);
                }
                worker.falls[site].fall(of_site.draw_of(std::move(own_factors)), {of_site.seed, wave, number},
                                        worker.rocks);
                for (const Observation& observation : of_site.observations) {
                    worker.shown.samples.push_back(seen_of(worker.rocks, observation, of_site.search));
                }
                worker.shown.stops.push_back(stops_of(worker.rocks, of_site));
                add_figures(worker.rocks, of_site, worker.shown.figures);
            }
            worker.shown.summary.clear();
            worker.shown.distances.assign(observations_.size(), 0.0);
            for (std::size_t k = 0; k < observations_.size(); ++k) {
                const Sample& observed = observations_[k].fit;
                if (!observed.empty()) {
                    // Views of the same rocks show the same ones.
                    config::RandomStream stream = choices(seed_, wave, Choice::summary,
                                                          number * most_witnesses + observations_[k].witness);
                    // As many as were observed: all rocks of a set lack the noise that the observed ones
                    // have. Held against them, sets would be left out that show such rocks now and then.
                    const Sample seen = drawn_from({&worker.shown.samples[k]}, 1, observed.size(),
                                                   [&] { return stream.uniform(); });
                    worker.shown.distances[k] = energy_distance(observed, seen);
                    add_summary(seen, lines_[k], worker.shown.summary);
                }
            }
        },
        [&](Worker& worker, std::size_t i) {
            (void)ranks_.report(1);
            if (ranks_.stopped()) {
                throw FailedElsewhere{};
            }
            take(i, worker.shown);
        });
    if (done < points.size()) {
        throw Interrupted{};
    }
}

std::vector<double> Simulator::observed_summary() const {
    std::vector<double> summary;
    for (std::size_t k = 0; k < observations_.size(); ++k) {
        if (!observations_[k].fit.empty()) {
            add_summary(observations_[k].fit, lines_[k], summary);
        }
    }
    return summary;
}

std::vector<std::size_t> Simulator::observations_of_summary() const {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < observations_.size(); ++k) {
        if (!observations_[k].fit.empty()) {
            std::vector<double> own;
            add_summary(observations_[k].fit, lines_[k], own);
            places.insert(places.end(), own.size(), k);
        }
    }
    return places;
}

std::vector<Shown> Simulator::shown(std::span<const Point> points, std::uint16_t wave,
                                    std::uint64_t rocks) const {
    std::vector<Shown> all(points.size());
    fall(points, wave, 0, rocks, [&](std::size_t i, Shown& shown) { all[i] = std::move(shown); });
    return all;
}

}  // namespace coupling::calibrate
