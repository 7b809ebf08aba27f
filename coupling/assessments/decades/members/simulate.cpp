#include "coupling/assessments/decades/members/simulate.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "config/units/constants.hpp"
#include "coupling/assessments/decades/members/judged_cuts.hpp"
#include "coupling/assessments/decades/members/record_falls.hpp"
#include "coupling/assessments/decades/members/record_forest.hpp"
#include "coupling/assessments/decades/members/record_work.hpp"
#include "coupling/exchange/run_year.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling::decades {
namespace {

bool contains(const std::vector<int>& years, std::int32_t year) {
    return std::find(years.begin(), years.end(), year) != years.end();
}

/// A member on its way through the years: simulates each and keeps its figures.
class MemberRun {
public:
    MemberRun(const Decades& decades, Member member, std::optional<KeptMember> begun, int threads)
        : decades_{decades},
          settings_{decades.scenario.forest},
          member_{member},
          threads_{threads},
          tree_list_years_{chosen_years(settings_.tree_list_years, decades.scenario.run.years)},
          map_years_{chosen_years(settings_.map_years, decades.scenario.run.years)},
          bare_{bare_falls()},
          start_{begun ? nullptr : start()},
          state_{begun ? state_of(decades.forest, std::move(begun->end))
                       : exchange::MemberState{start_->stand, {}}},
          factors_{decades.rocks == nullptr ? forest::ForestFactors{}
                                            : decades.rocks->forest_of(member.replicate)},
          species_{forest::with_factors(decades.forest.species.table, factors_)},
          parameters_{forest::with_factors(decades.forest.parameters, factors_)},
          site_{decades.forest,
                species_,
                parameters_,
                decades.management.regimes[member.regime],
                member.climate,
                {decades.scenario.run.seed, member.replicate},
                [this](const forest::Stand& stand, std::int32_t year) { return simulate_rocks(stand, year); },
                real_rock_share(decades)} {
        if (begun) {
            taken_over_ = begun->kept.last;
            kept_ = std::move(begun->years);
        }
        kept_.member = member;
    }
    MemberRun(const MemberRun&) = delete;  // site_ refers to this object
    MemberRun& operator=(const MemberRun&) = delete;

    void simulate_start() {
        record_year(state_.stand, species(), 0, std::nullopt, 0.0, kept_);
        record_standing_value();
        const std::size_t first_tree = kept_.trees.size();
        record_lists(0);  // as the forest stood before its first rocks
        const exchange::YearOutcome outcome = exchange::run_start(state_, site_);
        start_.reset();
        record_rocks(outcome.falls, 0, first_tree);
        record_work(outcome.work, site_.regime, decades_.management.prices, settings_.machine_m3ph, 0, kept_);
        record_losses(state_.stand, species(), 0, settings_.list_all_removed, kept_);
    }

    void simulate_year(std::int32_t year) {
        const exchange::YearOutcome outcome = exchange::run_year(state_, site_, year);
        record_work(outcome.work, site_.regime, decades_.management.prices, settings_.machine_m3ph, year,
                    kept_);
        record_year(state_.stand, species(), year, outcome.growth, outcome.mean_temperature_degc, kept_);
        record_standing_value();
        record_losses(state_.stand, species(), year, settings_.list_all_removed, kept_);
        const std::size_t first_tree = kept_.trees.size();
        record_lists(year);
        record_rocks(outcome.falls, year, first_tree);
    }

    /// Years that an earlier run has simulated; 0: the start is to be simulated, too.
    [[nodiscard]] std::int32_t taken_over() const { return taken_over_; }

    KeptMember take() {
        return {kept_years_of(decades_.scenario),
                taken_over_,
                std::move(kept_),
                {state_.stand.image(), std::move(state_.regime)}};
    }

private:
    /// 0 without feedback.
    static double real_rock_share(const Decades& decades) {
        const ForestSettings& settings = decades.scenario.forest;
        return settings.feedback && decades.rocks != nullptr
                   ? settings.rocks_per_year / static_cast<double>(decades.rocks->rocks())
                   : 0.0;
    }

    static exchange::MemberState state_of(const ForestSite& forest, MemberEnd end) {
        return {forest::Stand{forest.grid, forest.species.table.size(), std::move(end.stand)},
                std::move(end.regime)};
    }

    [[nodiscard]] const forest::SpeciesTable& species() const { return species_; }

    [[nodiscard]] bool has_rocks(std::int32_t year) const {
        return decades_.rocks != nullptr && is_rock_year(year, decades_.scenario);
    }

    /// Whether the page shows the slope of this member in this year.
    [[nodiscard]] bool is_shown(std::int32_t year) const {
        return member_.replicate == 0 && contains(tree_list_years_, year);
    }

    [[nodiscard]] std::optional<BareFalls> bare_falls() const {
        return decades_.parts == nullptr ? std::nullopt
                                         : std::optional<BareFalls>{std::in_place, *decades_.blocks,
                                                                    *decades_.parts, member_.replicate};
    }

    std::shared_ptr<const Start> start() {
        const auto make = [&] {
            forest::Stand stand = decades_.forest.start(decades_.scenario.run.seed, member_.replicate);
            exchange::YearFalls falls = let_rocks_fall(stand, 0);
            return Start{std::move(stand), std::move(falls)};
        };
        return decades_.starts != nullptr ? decades_.starts->of(member_.replicate, make)
                                          : std::make_shared<const Start>(make());
    }

    exchange::YearFalls simulate_rocks(const forest::Stand& stand, std::int32_t year) {
        return year == 0 ? start_->falls : let_rocks_fall(stand, year);
    }

    exchange::YearFalls let_rocks_fall(const forest::Stand& stand, std::int32_t year) {
        if (!has_rocks(year)) {
            return {};
        }
        if (bare_) {
            return simulate_rocks(stand, bare_->at(year), year);
        }
        const bool with_cells = contains(map_years_, year);
        return simulate_rocks(
            stand, decades_.rocks->simulate_bare(member_.replicate, year, with_cells, threads_), year);
    }

    exchange::YearFalls simulate_rocks(const forest::Stand& stand, const exchange::BareYear& bare,
                                       std::int32_t year) {
        exchange::YearFalls falls =
            decades_.rocks->simulate(stand, bare, member_.replicate, is_shown(year), threads_);
        if (settings_.living_trees_alone) {
            falls.living = decades_.rocks->simulate_living(stand, bare, falls, member_.replicate, threads_);
        }
        return falls;
    }

    /// Figures, cells and paths of a year's rocks, and what they did to the listed trees from `first_tree`
    /// on.
    void record_rocks(const exchange::YearFalls& falls, std::int32_t year, std::size_t first_tree) {
        if (!has_rocks(year)) {
            return;
        }
        record_falls(falls, year, kept_);
        record_paths(falls, year, kept_);
        if (contains(map_years_, year)) {
            record_cells(falls, year, kept_);
        }
        std::map<std::uint64_t, rockfall::StemTally> loads;
        for (const exchange::TreeLoad& load : falls.loads) {
            loads[forest::number_of(load.tree)] = load.tally;
        }
        for (std::size_t i = first_tree; i < kept_.trees.size(); ++i) {
            const auto load = loads.find(kept_.trees[i].tree);
            if (load != loads.end()) {
                kept_.trees[i].rock_hits = load->second.hits;
                kept_.trees[i].rock_energy_kj =
                    static_cast<float>(static_cast<double>(load->second.energy_j) / config::j_per_kj);
            }
        }
    }

    /// Of the trees of the year that was recorded last.
    void record_standing_value() {
        kept_.years.back().standing_value_eur =
            standing_value_eur(state_.stand, species(), decades_.management.prices);
    }

    /// Trees, dead wood and patches of chosen years.
    void record_lists(std::int32_t year) {
        if (contains(tree_list_years_, year)) {
            record_trees(state_.stand, year, kept_);
            if (is_shown(year)) {
                record_dead_wood(state_.stand, year, kept_);
            }
        }
        if (contains(map_years_, year)) {
            record_patches(state_.stand, species(), year, kept_);
        }
    }

    const Decades& decades_;
    const ForestSettings& settings_;
    Member member_;
    int threads_;
    std::vector<int> tree_list_years_;
    std::vector<int> map_years_;
    std::optional<BareFalls> bare_;       ///< where they are shared
    std::shared_ptr<const Start> start_;  ///< until year 0 is over; nullptr: an earlier run was past it
    exchange::MemberState state_;
    forest::ForestFactors factors_;  ///< of the replicate
    forest::SpeciesTable species_;
    forest::Parameters parameters_;
    exchange::MemberSite site_;
    std::int32_t taken_over_ = 0;
    MemberYears kept_;
};

}  // namespace

KeptMember simulate_on(const Decades& decades, Member member, std::optional<KeptMember> begun, int threads,
                       const std::function<void()>& year_done) {
    MemberRun run{decades, member, std::move(begun), threads};
    if (run.taken_over() == 0) {
        run.simulate_start();
    }
    const auto last = static_cast<std::int32_t>(decades.scenario.run.years);
    for (std::int32_t year = run.taken_over() + 1; year <= last; ++year) {
        run.simulate_year(year);
        year_done();
    }
    return run.take();
}

MemberYears simulate(const Decades& decades, Member member, int threads,
                     const std::function<void()>& year_done) {
    return simulate_on(decades, member, std::nullopt, threads, year_done).years;
}

}  // namespace coupling::decades
