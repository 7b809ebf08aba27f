#include "coupling/assessments/calibrate/search/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "config/random/distributions.hpp"
#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/assessments/calibrate/sites/open_sites.hpp"
#include "coupling/inputs/observed/distribution.hpp"
#include "coupling/inputs/parameters/correlated_draws.hpp"

namespace coupling::calibrate {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
/// Sets that are simulated once more, samples of them that stand for what could have been observed.
constexpr std::size_t sets_judged = 60;
constexpr std::size_t trials = 300;
constexpr std::size_t most_points = 400;
constexpr std::uint16_t wave_after = most_waves - 1;
constexpr std::uint16_t wave_before = most_waves - 2;

Band band_of(std::vector<double> values) {
    Band band;
    band.fill(nothing);
    std::erase_if(values, [](double value) { return !std::isfinite(value); });
    if (values.empty()) {
        return band;
    }
    const observed::Distribution distribution{std::move(values)};
    for (std::size_t i = 0; i < band.size(); ++i) {
        band[i] = distribution.quantile(band_shares[i]);
    }
    return band;
}

/// Members by their weights, each as often as its weight says: every 1/n-th of the sum.
std::vector<Point> by_weight(const std::vector<Member>& members, std::size_t count) {
    std::vector<Point> points;
    double below = 0.0;
    std::size_t i = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double wanted = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
        while (i + 1 < members.size() && below + members[i].weight < wanted) {
            below += members[i].weight;
            ++i;
        }
        points.push_back(members[i].point);
    }
    return points;
}

/// What sets show of one observation, and what of it could have been observed.
class Predictions {
public:
    Predictions(const std::vector<Shown>& sets, std::size_t observation) {
        for (const Shown& set : sets) {
            if (!set.samples[observation].empty()) {
                samples_.push_back(thinned(set.samples[observation], most_points));
                within_.push_back(mean_distance(samples_.back(), samples_.back()));
            }
        }
    }

    /// One set alone has no other to be held against.
    [[nodiscard]] bool empty() const { return samples_.size() < 2; }
    /// How many of `sets` show at least so many points.
    [[nodiscard]] std::size_t with_at_least(std::size_t points) const {
        return static_cast<std::size_t>(std::count_if(
            samples_.begin(), samples_.end(), [&](const Sample& sample) { return sample.size() >= points; }));
    }
    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

    /// A sample as large as what was observed, of the set that the trial takes.
    [[nodiscard]] Sample trial(std::size_t number, std::size_t points, std::uint64_t seed,
                               std::uint64_t item) const {
        config::RandomStream stream = choices(seed, wave_after, Choice::trial, item * trials + number);
        return drawn_from({&samples_[number % samples_.size()]}, 1, points, [&] { return stream.uniform(); });
    }
    /// Mean energy distance of a sample to all sets but `without`.
    [[nodiscard]] double distance(const Sample& sample, std::size_t without) const {
        const double own = mean_distance(sample, sample);
        double sum = 0.0;
        double count = 0.0;
        for (std::size_t set = 0; set < samples_.size(); ++set) {
            if (set != without) {
                sum += 2.0 * mean_distance(sample, samples_[set]) - own - within_[set];
                count += 1.0;
            }
        }
        return count > 0.0 ? sum / count : nothing;
    }

private:
    std::vector<Sample> samples_;
    std::vector<double> within_;
};

/// Distances of all observations together, observed and of the model itself.
class Together {
public:
    /// `of_trials`: distances of samples of the model.
    void add(double observed, const std::vector<double>& of_trials) {
        const double scale = observed::Distribution{of_trials}.quantile(0.5);
        if (!(scale > 0.0)) {
            return;
        }
        observed_ += observed / scale;
        trials_.resize(of_trials.size(), 0.0);
        for (std::size_t i = 0; i < of_trials.size(); ++i) {
            trials_[i] += of_trials[i] / scale;
        }
    }
    [[nodiscard]] double as_far() const { return trials_.empty() ? nothing : share(observed_, trials_); }
    static double share(double observed, const std::vector<double>& of_trials) {
        const auto further = std::count_if(of_trials.begin(), of_trials.end(),
                                           [&](double distance) { return distance >= observed; });
        return static_cast<double>(1 + further) / static_cast<double>(1 + of_trials.size());
    }

private:
    double observed_ = 0.0;
    std::vector<double> trials_;
};

/// What sets would show of so many rocks, again and again.
std::vector<Sample> trials_of(const Predictions& predictions, std::size_t points, std::uint64_t seed,
                              std::uint64_t item) {
    std::vector<Sample> samples;
    for (std::size_t number = 0; !predictions.empty() && number < trials; ++number) {
        samples.push_back(predictions.trial(number, points, seed, item));
    }
    return samples;
}

Band figures_of(const std::vector<Sample>& samples, const SightLine& line) {
    std::vector<double> figures;
    for (const Sample& sample : samples) {
        figures.push_back(figure_of(sample, line));
    }
    return band_of(std::move(figures));
}

Side side_of(const Predictions& predictions, const Sample& observed, const SightLine& line,
             std::uint64_t seed, std::uint64_t item, Together& together) {
    Side side{.observed = observed.size(), .figure = figure_of(observed, line)};
    side.predicted.fill(nothing);
    side.before.fill(nothing);
    side.distance = side.as_far = nothing;
    if (observed.empty() || predictions.empty()) {
        return side;
    }
    const Sample few = thinned(observed, most_points);
    const std::vector<Sample> samples = trials_of(predictions, few.size(), seed, item);
    std::vector<double> distances;
    for (std::size_t number = 0; number < trials; ++number) {
        distances.push_back(predictions.distance(samples[number], number % predictions.samples().size()));
    }
    side.predicted = figures_of(samples, line);
    side.distance = predictions.distance(few, predictions.samples().size());
    side.as_far = Together::share(side.distance, distances);
    together.add(side.distance, distances);
    return side;
}

double share_below(const std::vector<double>& sorted, double value) {
    return static_cast<double>(std::upper_bound(sorted.begin(), sorted.end(), value) - sorted.begin()) /
           static_cast<double>(sorted.size());
}

std::vector<std::vector<double>> curves_of(const std::vector<Sample>& samples, const SightLine& line) {
    std::vector<std::vector<double>> curves;
    for (const Sample& sample : samples) {
        curves.push_back(values_along(sample, line));
    }
    return curves;
}

/// Shares below places from the least to the largest value of all. Bands are of as many rocks as were
/// observed: a curve of few lies beside that of many by chance.
std::vector<CurvePoint> curve_of(const Sample& observed, const Predictions& after, const Predictions& before,
                                 const SightLine& line, std::uint64_t seed, std::uint64_t item) {
    const std::vector<double> seen = values_along(observed, line);
    if (seen.empty() || after.empty()) {
        return {};
    }
    const std::size_t count = std::min(seen.size(), most_points);
    const auto curves_after = curves_of(trials_of(after, count, seed, item), line);
    const auto curves_before = curves_of(trials_of(before, count, seed, item), line);
    double low = seen.front();
    double high = seen.back();
    for (const std::vector<double>& curve : curves_of(after.samples(), line)) {
        low = std::min(low, curve.front());
        high = std::max(high, curve[curve.size() - 1 - curve.size() / 200]);
    }
    constexpr std::size_t places = 60;
    std::vector<CurvePoint> points;
    for (std::size_t i = 0; i <= places; ++i) {
        const double value = low + (high - low) * static_cast<double>(i) / static_cast<double>(places);
        const auto band_at = [&](const std::vector<std::vector<double>>& curves) {
            std::vector<double> shares;
            for (const std::vector<double>& curve : curves) {
                shares.push_back(share_below(curve, value));
            }
            return band_of(std::move(shares));
        };
        points.push_back({value, share_below(seen, value), band_at(curves_after), band_at(curves_before)});
    }
    return points;
}

/// The share of the variance of a figure between `bins` ranges of a parameter, without what chance gives. Of
/// independent numbers: what a parameter shares with another one counts for that one.
double share_of_parameter(const std::vector<Member>& members, std::size_t figure, Eigen::Index parameter) {
    std::vector<std::pair<double, double>> order;
    for (const Member& member : members) {
        if (std::isfinite(member.figures[figure])) {
            order.emplace_back(member.point[parameter], member.figures[figure]);
        }
    }
    constexpr std::size_t bins = 8;
    if (order.size() < 8 * bins) {
        return nothing;
    }
    std::sort(order.begin(), order.end());
    const auto n = static_cast<double>(order.size());
    double mean = 0.0;
    for (const auto& [point, value] : order) {
        mean += value / n;
    }
    double all = 0.0;
    double between = 0.0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const std::size_t from = bin * order.size() / bins;
        const std::size_t to = (bin + 1) * order.size() / bins;
        double of_bin = 0.0;
        for (std::size_t i = from; i < to; ++i) {
            all += (order[i].second - mean) * (order[i].second - mean);
            of_bin += order[i].second / static_cast<double>(to - from);
        }
        between += static_cast<double>(to - from) * (of_bin - mean) * (of_bin - mean);
    }
    if (!(all > 0.0)) {
        return 0.0;
    }
    const double share = between / all;
    const double by_chance = (static_cast<double>(bins) - 1.0) / (n - 1.0);
    return std::max(0.0, (share - by_chance) / (1.0 - by_chance));
}

std::vector<Sensitivity> sensitivities_of(const Space& space, const SearchState& state,
                                          const std::vector<SurveyFigure>& figures) {
    std::vector<Sensitivity> all;
    for (std::size_t figure = 0; figure < figures.size(); ++figure) {
        Sensitivity sensitivity{figures[figure], {}};
        for (std::size_t i = 0; i < space.size(); ++i) {
            sensitivity.shares.push_back(
                share_of_parameter(state.first, figure, static_cast<Eigen::Index>(i)));
        }
        if (std::any_of(sensitivity.shares.begin(), sensitivity.shares.end(),
                        [](double share) { return std::isfinite(share); })) {
            all.push_back(std::move(sensitivity));
        }
    }
    return all;
}

/// Of several sites one is as far away as chance allows where the least of all is, as often as there are
/// sites (Bonferroni).
double of_all_sites(const std::vector<SiteJudged>& sites, double SiteJudged::*as_far) {
    double least = 1.0;
    for (const SiteJudged& site : sites) {
        if (std::isnan(site.*as_far)) {
            return nothing;
        }
        least = std::min(least, static_cast<double>(sites.size()) * site.*as_far);
    }
    return least;
}

Sample all_of(const Observation& observation) {
    Sample all = observation.fit;
    all.points.insert(all.points.end(), observation.held_out.points.begin(),
                      observation.held_out.points.end());
    return all;
}

constexpr std::uint64_t least_rocks = 500;
static_assert(static_cast<double>(most_sites) / static_cast<double>(1 + trials) < least_as_far,
              "so many sites could never be further away than chance allows");

/// Whether more than a tenth of the sets show fewer points than were observed, or than 30.
bool show_too_few(const Predictions& predictions, std::size_t observed, std::size_t sets) {
    constexpr std::size_t enough_points = 30;
    constexpr double most_without = 0.1;
    const std::size_t with_enough = predictions.with_at_least(std::min(observed, enough_points));
    return static_cast<double>(sets - with_enough) > most_without * static_cast<double>(sets);
}

}  // namespace

Judgement judge(const Simulator& simulator, const SearchState& state, const Adjustment& adjustment,
                std::uint64_t rocks) {
    const std::vector<SightLine>& lines = simulator.lines();
    const std::uint64_t of_set = std::max(rocks, least_rocks);
    const std::vector<Shown> after =
        simulator.shown(by_weight(state.population, sets_judged), wave_after, of_set);
    const std::vector<Shown> before =
        simulator.shown(by_weight(state.first, sets_judged), wave_before, of_set);

    Judgement judgement;
    std::vector<Together> fit(simulator.sites().size());
    std::vector<Together> held_out(simulator.sites().size());
    for (std::size_t i = 0; i < simulator.observations().size(); ++i) {
        const Observation& observation = simulator.observations()[i];
        const std::uint64_t witness = observation.witness;
        const Predictions predictions{after, i};
        const Predictions by_widths{before, i};
        const std::size_t observed = std::max(observation.fit.size(), observation.held_out.size());
        judgement.shows_too_few =
            judgement.shows_too_few || show_too_few(predictions, observed, after.size());
        Judged judged;
        const auto before_of = [&](const Sample& sample, std::uint64_t item) {
            const std::size_t points = std::min(sample.size(), most_points);
            return figures_of(trials_of(by_widths, points, simulator.seed(), 4 * witness + item), lines[i]);
        };
        const auto side = [&](const Sample& sample, std::uint64_t item, Together& together) {
            Side of_side =
                side_of(predictions, sample, lines[i], simulator.seed(), 4 * witness + item, together);
            of_side.before = before_of(sample, item);
            return of_side;
        };
        const Sample all = all_of(observation);
        judged.fit = side(observation.fit, 0, fit[observation.site]);
        judged.held_out = side(observation.held_out, 1, held_out[observation.site]);
        judged.before = before_of(all, 2);
        if (observation.is_plane()) {
            judged.sets = predictions.samples();
        }
        if (!observation.trees || !observation.fit.empty()) {  // of few held-out stems a curve says nothing
            judged.curve = curve_of(all, predictions, by_widths, lines[i], simulator.seed(), 4 * witness + 2);
        }
        judgement.observations.push_back(std::move(judged));
    }
    judgement.held_out = number_of(simulator.observations(), &Observation::held_out);
    for (std::size_t site = 0; site < fit.size(); ++site) {
        judgement.sites.push_back({fit[site].as_far(), held_out[site].as_far()});
        for (const Shown& set : after) {
            if (!set.stops[site].empty()) {
                judgement.sites.back().stops.push_back(thinned(set.stops[site], most_points));
            }
        }
    }
    judgement.fit_as_far = of_all_sites(judgement.sites, &SiteJudged::fit_as_far);
    judgement.held_out_as_far = of_all_sites(judgement.sites, &SiteJudged::held_out_as_far);
    judgement.ruled_out = ruled_out_of(simulator, state.ruled);
    judgement.parameters = learned_of(simulator.space(), state.population, adjustment);
    judgement.sensitivities = sensitivities_of(simulator.space(), state, simulator.figures());
    judgement.effective_sets = effective_sets(state.population);
    judgement.followed = std::min(1.0, adjustment.followed);
    judgement.is_calibrated = state.end == SearchEnd::close && state.waves.size() > 1 &&
                              !judgement.shows_too_few && judgement.fit_as_far >= least_as_far &&
                              judgement.held_out_as_far >= least_as_far;
    return judgement;
}

Transfer judge_transfer(const Simulator& fitted, const SearchState& state, const Simulator& target,
                        std::size_t site, std::uint64_t rocks) {
    static const config::TruncatedNormal within_cut_off{most_deviations};
    const Space& from = fitted.space();
    const Space& to = target.space();
    std::vector<Point> points;
    for (const Point& point : by_weight(state.population, sets_judged)) {
        config::RandomStream stream =
            choices(target.seed(), wave_after, Choice::proposal, (site << 16U) + points.size());
        Point& own = points.emplace_back(static_cast<Eigen::Index>(to.size()));
        for (std::size_t i = 0; i < to.size(); ++i) {
            const std::size_t place = from.find(to.components()[i].parameter);
            const double drawn = within_cut_off(stream.uniform());
            own[static_cast<Eigen::Index>(i)] =
                place < from.size() ? point[static_cast<Eigen::Index>(place)] : drawn;
        }
    }
    const std::vector<Shown> sets = target.shown(points, wave_after, std::max(rocks, least_rocks));
    Transfer transfer{.site = site,
                      .sides = {},
                      .end = state.end,
                      .tried = state.tried(),
                      .sites = fitted.sites().size() + 1};
    Together together;
    for (std::size_t i = 0; i < target.observations().size(); ++i) {
        const Observation& observation = target.observations()[i];
        const Predictions predictions{sets, i};
        const Sample all = all_of(observation);
        // What too few rocks show is not held against the sets; the rest is.
        const bool is_few = show_too_few(predictions, all.size(), sets.size());
        transfer.shows_too_few = transfer.shows_too_few || is_few;
        Together apart;
        transfer.sides.push_back(side_of(predictions, all, target.lines()[i], target.seed(),
                                         4 * std::uint64_t{observation.witness} + 3,
                                         is_few ? apart : together));
    }
    transfer.as_far = together.as_far();
    return transfer;
}

TransferVerdict Transfer::verdict() const {
    if (end != SearchEnd::close) {
        return TransferVerdict::not_close;
    }
    if (as_far < least_as_far()) {  // not of NaN
        return TransferVerdict::too_far;
    }
    return shows_too_few || std::isnan(as_far) ? TransferVerdict::too_few : TransferVerdict::holds;
}

double Transfer::least_as_far() const {
    return calibrate::least_as_far / static_cast<double>(sites);
}

}  // namespace coupling::calibrate
