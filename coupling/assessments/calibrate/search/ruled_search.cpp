#include "coupling/assessments/calibrate/search/ruled_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coupling/assessments/calibrate/model/random.hpp"
#include "coupling/assessments/calibrate/search/rounds.hpp"

namespace coupling::calibrate {
namespace {

/// Of the sets of a round [choice].
constexpr double share_of_checks = 0.05;
/// Where less than this is ruled out, nothing is drawn from it.
constexpr double worth_checking = 0.01;

class RuledSearch : public Rounds {
public:
    using Rounds::Rounds;

    void run() {
        if (state_.waves.empty()) {
            simulate_first();
            finish_round({.tried = plan_.first_sets}, nearest_of_first());
        }
        while (!state_.is_done) {
            next_round();
        }
    }

private:
    [[nodiscard]] Ruled& ruled() { return state_.ruled; }

    /// Each set that fell, in their order.
    template <class Take>
    void for_each_fallen(const Take& take) const {
        std::for_each(state_.first.begin(), state_.first.end(), take);
        std::for_each(state_.ruled.fallen.begin(), state_.ruled.fallen.end(), take);
    }

    /// All sets within a tolerance, with weights.
    [[nodiscard]] std::vector<Member> within(double tolerance) const {
        std::vector<Member> members;
        double sum = 0.0;
        for_each_fallen([&](const Member& fallen) {
            if (is_within(fallen.distances, tolerance)) {
                const double weight =
                    mixture_weight(fallen.point, plan_.first_sets, state_.ruled.rounds, state_.ruled.rulings);
                members.push_back({fallen.point, weight, fallen.distances, fallen.summary, {}});
                sum += weight;
            }
        });
        for (Member& member : members) {
            member.weight /= sum;
        }
        return members;
    }

    /// The tolerance within which so many sets are, or all that show what was seen.
    [[nodiscard]] double tolerance_of(std::size_t sets) const {
        std::vector<double> distances;
        for_each_fallen([&](const Member& fallen) {
            if (const double distance = state_.scale.together(fallen.distances); std::isfinite(distance)) {
                distances.push_back(distance);
            }
        });
        if (distances.empty()) {
            return 0.0;
        }
        std::sort(distances.begin(), distances.end());
        return distances[std::min(sets, distances.size()) - 1];
    }

    /// The scale at the mean of what is near by the scale before, and what is kept by it.
    void finish_round(Wave round, const Point& centre) {
        state_.waves.push_back(round);
        const std::vector<std::vector<double>> summaries = rescale(centre);
        const double goal = state_.scale.at_90;
        state_.waves.back().goal = state_.waves.back().tolerance = goal;
        state_.begun = {};
        const double at_least = tolerance_of(least_parents());
        state_.population = within(std::isfinite(goal) ? std::max(goal, at_least) : at_least);
        std::vector<Fallen> kept;
        for (const Member& member : state_.population) {
            kept.push_back({&member.point, &member.summary});
        }
        ruled().scatter = tolerated(deviations_of(summaries), kept, simulator_.observed_summary());
        if (state_.population.empty()) {  // nothing that was seen shows: the widths are all there is
            state_.population = state_.first;
            for (Member& member : state_.population) {
                member.figures.clear();
            }
        }
        const std::vector<Member>& last = state_.waves.size() == 1 ? state_.first : ruled().fallen;
        const auto begin = last.end() - static_cast<std::ptrdiff_t>(round.tried);
        state_.waves.back().kept = static_cast<std::uint64_t>(std::count_if(
            begin, last.end(), [&](const Member& member) { return is_within(member.distances, goal); }));
        decide();
        keep_(state_);
    }

    /// How many of all sets are within the goal, by the scale of now.
    [[nodiscard]] std::uint64_t near() const {
        std::uint64_t count = 0;
        for_each_fallen([&](const Member& fallen) {
            count += is_within(fallen.distances, state_.scale.at_90) ? 1U : 0U;
        });
        return count;
    }

    void decide() {
        const bool has_followed = state_.waves.size() > 1;
        const std::uint64_t kept = near();
        const std::uint64_t tried = state_.tried();
        const bool spent = tried >= plan_.most_sets;
        const Wave& last = state_.waves.back();
        constexpr std::uint64_t enough_to_judge = 500;
        if (!std::isfinite(state_.scale.at_90)) {  // sets in the middle show nothing of something seen
            done(SearchEnd::few_kept);
        } else if (has_followed && (kept >= plan_.sets || (spent && kept >= least_sample))) {
            done(SearchEnd::close);
        } else if (spent) {
            done(SearchEnd::budget);
        } else if (has_followed && tried >= tried_before_giving_up && last.tried >= enough_to_judge &&
                   static_cast<double>(last.kept) < least_kept * static_cast<double>(last.tried)) {
            done(SearchEnd::few_kept);
        } else if (is_last()) {
            done(kept >= least_sample ? SearchEnd::close : SearchEnd::few_kept);
        }
    }

    void done(SearchEnd end) {
        state_.is_done = true;
        state_.end = end;
        ruled().beyond = ruled().beyond_kept = 0;
        ruled().beyond_weight = 0.0;
        for_each_fallen(
            [&](const Member& fallen) { ruled().beyond += keep(ruled().rulings, fallen.point) ? 0U : 1U; });
        for (const Member& member : state_.population) {
            if (!keep(ruled().rulings, member.point)) {
                ++ruled().beyond_kept;
                ruled().beyond_weight += member.weight;
            }
        }
    }

    void next_round() {
        if (ruled().rounds.size() < state_.waves.size() && !begin_round()) {
            done(SearchEnd::few_kept);
            keep_(state_);
            return;
        }
        const RuledRound& round = ruled().rounds.back();
        while (state_.begun.tried < round.sets) {
            try_sets();
            if (state_.begun.tried < round.sets) {
                keep_(state_);
            }
        }
        Point mean = Point::Zero(static_cast<Eigen::Index>(simulator_.space().size()));
        for (const Member& member : within(std::max(state_.scale.at_90, tolerance_of(least_parents())))) {
            mean += member.weight * member.point;
        }
        finish_round(state_.begun, mean);
    }

    /// Rules out what the sets so far allow. Whether anything is left.
    bool begin_round() {
        std::vector<Fallen> sets;
        for_each_fallen([&](const Member& member) { sets.push_back({&member.point, &member.summary}); });
        std::vector<Ruling>& rulings = ruled().rulings;
        rulings.push_back(ruling_of(rulings, sets, simulator_.observed_summary(), ruled().scatter));
        config::RandomStream stream =
            choices(simulator_.seed(), static_cast<std::uint16_t>(state_.waves.size()), Choice::spread, 0);
        const double left = share_left(rulings, simulator_.space().size(), [&] { return stream.uniform(); });
        rulings.back().left = left;
        if (left == 0.0) {
            return false;
        }
        ruled().rounds.push_back({.sets = size_of_round(),
                                  .not_run = 0,
                                  .checks = 1.0 - left >= worth_checking ? share_of_checks : 0.0});
        return true;
    }

    /// As many as are still needed, if sets of what is left now are near as often as those of the round
    /// before were there; few at first, as each round rules out more.
    [[nodiscard]] std::uint64_t size_of_round() const {
        constexpr std::uint64_t least = 64;
        constexpr std::size_t most_doublings = 20;
        constexpr double highest_rate = 0.9;
        const std::vector<Ruling>& rulings = state_.ruled.rulings;
        const double left_before = rulings.size() > 1 ? rulings[rulings.size() - 2].left : 1.0;
        const Wave& last = state_.waves.back();
        const double rate =
            std::min(highest_rate, static_cast<double>(last.kept + 1) * left_before /
                                       (static_cast<double>(last.tried) * rulings.back().left));
        const std::uint64_t kept = near();
        const double needed = plan_.sets > kept ? static_cast<double>(plan_.sets - kept) / rate : 0.0;
        const std::uint64_t most =
            std::min(least << std::min(rulings.size() - 1, most_doublings), plan_.most_sets - state_.tried());
        const double wanted = std::ceil(std::min(needed, static_cast<double>(most)));
        return std::min(most, std::max(least, static_cast<std::uint64_t>(wanted)));
    }

    void try_sets() {
        const auto number = static_cast<std::uint16_t>(state_.waves.size());
        const auto first = static_cast<std::uint32_t>(state_.begun.tried);
        RuledRound& round = ruled().rounds.back();
        const std::uint64_t count = std::min(sets_at_once, round.sets - state_.begun.tried);
        std::vector<Point> points;
        for (std::uint64_t i = 0; i < count; ++i) {
            config::RandomStream stream = choices(simulator_.seed(), number, Choice::proposal, first + i);
            const bool is_check = stream.uniform() < round.checks;
            Point point = point_by_widths(simulator_.space().size(), [&] { return stream.uniform(); });
            while (keep(ruled().rulings, point) == is_check) {
                round.not_run += is_check ? 0U : 1U;
                point = point_by_widths(simulator_.space().size(), [&] { return stream.uniform(); });
            }
            points.push_back(std::move(point));
        }
        simulator_.show(points, number, first, plan_.rocks, [&](std::size_t i, Shown& shown) {
            moved_(1);
            ++state_.begun.tried;
            ruled().fallen.push_back({points[i], 0.0, shown.distances, shown.summary, {}});
        });
    }
};

}  // namespace

bool emulates(Emulates chosen, rockfall::MotionModel model) {
    return chosen == Emulates::yes ||
           (chosen == Emulates::by_model && rockfall::description_of(model).has_shape);
}

std::uint64_t Ruled::not_run() const {
    std::uint64_t sum = 0;
    for (const RuledRound& round : rounds) {
        sum += round.not_run;
    }
    return sum;
}

double mixture_weight(const Point& point, std::uint64_t first_sets, std::span<const RuledRound> rounds,
                      std::span<const Ruling> rulings) {
    double density = static_cast<double>(first_sets);
    const Eigen::VectorXd terms = terms_at(point);
    bool is_left = true;
    for (std::size_t i = 0; i < rounds.size(); ++i) {
        is_left = is_left && rulings[i].keeps(terms);
        const double share = is_left ? 1.0 - rounds[i].checks : rounds[i].checks;
        if (share > 0.0) {
            density += static_cast<double>(rounds[i].sets) * share /
                       (is_left ? rulings[i].left : 1.0 - rulings[i].left);
        }
    }
    return 1.0 / density;
}

void ruled_search(const Simulator& simulator, const SearchPlan& plan, SearchState& state,
                  const std::function<void(const SearchState&)>& keep,
                  const std::function<void(std::uint64_t sets)>& moved) {
    RuledSearch{simulator, plan, state, keep, moved}.run();
}

std::vector<RuledOut> ruled_out_of(const Simulator& simulator, const Ruled& ruled) {
    const std::vector<Ruling>& rulings = ruled.rulings;
    if (rulings.empty()) {
        return {};
    }
    config::RandomStream stream = choices(simulator.seed(), most_waves - 1, Choice::spread, 0);
    const std::vector<std::size_t> observation_of = simulator.observations_of_summary();
    const std::vector<double> shares =
        shares_ruled_out(rulings, simulator.space().size(), observation_of, simulator.observations().size(),
                         [&] { return stream.uniform(); });
    std::vector<RuledOut> all;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        if (simulator.observations()[k].fit.empty()) {
            continue;
        }
        RuledOut of_observation{k, shares[k], 0.0};
        for (const Rule& rule : rulings.front().rules) {
            if (observation_of[rule.figure] == k) {
                of_observation.explained = std::max(of_observation.explained, rule.emulator.explained);
            }
        }
        all.push_back(of_observation);
    }
    return all;
}

}  // namespace coupling::calibrate
