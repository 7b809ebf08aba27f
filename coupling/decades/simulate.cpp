#include "coupling/decades/simulate.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "config/random/stream.hpp"
#include "coupling/decades/record_forest.hpp"
#include "coupling/decades/record_work.hpp"
#include "forest/year.hpp"

namespace coupling::decades {
namespace {

bool contains(const std::vector<int>& years, std::int32_t year) {
    return std::find(years.begin(), years.end(), year) != years.end();
}

/// Yearly mean temperature of the patches.
double mean_temperature_degc(const forest::Site& site, const YearWeather& weather) {
    double sum = 0.0;
    double patches = 0.0;
    for (std::size_t u = 0; u < site.units().size(); ++u) {
        const auto count = static_cast<double>(site.units()[u].patches.size());
        for (const forest::ClimateMonth& month : weather.units[u].months) {
            sum += count * month.tave_degc / 12.0;
        }
        patches += count;
    }
    return sum / patches;
}

/// A member on its way through the years.
class Life {
public:
    Life(const Decades& decades, Member member, int threads)
        : decades_{decades},
          settings_{decades.scenario.forest},
          member_{member},
          threads_{threads},
          stand_{decades.forest.start(decades.scenario.seed, member.replicate)},
          tree_list_years_{chosen_years(settings_.tree_list_years, decades.scenario.years)},
          map_years_{chosen_years(settings_.map_years, decades.scenario.years)} {
        kept_.member = member;
        if (decades.parts != nullptr) {
            bare_.emplace(*decades.blocks, *decades.parts, member.replicate);
        }
    }

    void begin() {
        record_year(stand_, species(), 0, std::nullopt, 0.0, kept_);
        const FallsOfYear falls = let_rocks_fall(0);
        record_lists(0, falls);
        hurt_trees(falls, 0);
        manage(0);
        record_losses(stand_, species(), 0, settings_.list_all_removed, kept_);
    }

    void pass(std::int32_t year) {
        const ForestSite& forest = decades_.forest;
        const YearWeather weather = forest.weather(member_.climate, stand_.year() + 1, member_.replicate);
        const forest::YearReport report =
            forest::grow_year(stand_, forest.place, species(), weather.view(), forest.parameters,
                              {decades_.scenario.seed, member_.replicate});
        manage(year);
        const FallsOfYear falls = let_rocks_fall(year);
        hurt_trees(falls, year);
        record_year(stand_, species(), year, report, mean_temperature_degc(forest.place, weather), kept_);
        record_losses(stand_, species(), year, settings_.list_all_removed, kept_);
        record_lists(year, falls);
    }

    MemberYears take() { return std::move(kept_); }

private:
    [[nodiscard]] const forest::SpeciesTable& species() const { return decades_.forest.species.table; }

    void manage(std::int32_t year) {
        const Regime& regime = decades_.management.regimes[member_.regime];
        record_work(apply(regime, year, stand_, species(), regime_state_,
                          {decades_.scenario.seed, member_.replicate}),
                    regime, decades_.management.prices, year, kept_);
    }

    /// The start is year 0, and a year with rocks.
    [[nodiscard]] bool has_rocks(std::int32_t year) const {
        return decades_.rocks != nullptr && year % static_cast<std::int32_t>(settings_.rockfall_every) == 0;
    }

    /// Whether the page shows the slope of this member in this year.
    [[nodiscard]] bool is_shown(std::int32_t year) const {
        return member_.replicate == 0 && contains(tree_list_years_, year);
    }

    /// Without rocks in a year nothing fell.
    FallsOfYear let_rocks_fall(std::int32_t year) {
        if (!has_rocks(year)) {
            return {};
        }
        const bool with_paths = is_shown(year);
        FallsOfYear falls =
            bare_ ? decades_.rocks->fall(stand_, bare_->at(year), member_.replicate, with_paths, threads_)
                  : decades_.rocks->fall(stand_, member_.replicate, year, with_paths, threads_);
        record_falls(falls, year, kept_);
        record_paths(falls, year, kept_);
        if (contains(map_years_, year)) {
            record_cells(falls, year, kept_);
        }
        return falls;
    }

    /// Of the simulated rocks some really fall: those hurt trees.
    void hurt_trees(const FallsOfYear& falls, std::int32_t year) {
        if (!settings_.feedback || falls.hits.empty()) {
            return;
        }
        const double share = settings_.rocks_per_year / static_cast<double>(decades_.rocks->rocks());
        std::vector<forest::Impact> impacts;
        for (const RockHit& hit : falls.hits) {
            const config::StreamKey key{decades_.scenario.seed, member_.replicate,
                                        static_cast<std::uint16_t>(year), hit.rock};
            if (config::RandomStream{key, config::Purpose::real_rock}.uniform() < share) {
                impacts.push_back(hit.impact);
            }
        }
        forest::wound(stand_, species(), impacts, decades_.forest.parameters.uprooting,
                      decades_.scenario.seed, member_.replicate);
    }

    void record_lists(std::int32_t year, const FallsOfYear& falls) {
        if (contains(tree_list_years_, year)) {
            std::map<std::uint64_t, rockfall::StemTally> takes;
            for (const StemTake& take : falls.takes) {
                takes[forest::number_of(take.tree)] = take.tally;
            }
            const std::size_t first = kept_.trees.size();
            record_trees(stand_, year, kept_);
            if (is_shown(year)) {
                record_dead_wood(stand_, year, kept_);
            }
            for (std::size_t i = first; i < kept_.trees.size(); ++i) {
                const auto take = takes.find(kept_.trees[i].tree);
                if (take != takes.end()) {
                    kept_.trees[i].rock_hits = take->second.hits;
                    kept_.trees[i].rock_energy_kj =
                        static_cast<float>(static_cast<double>(take->second.energy_j) / 1000.0);
                }
            }
        }
        if (contains(map_years_, year)) {
            record_patches(stand_, species(), year, kept_);
        }
    }

    const Decades& decades_;
    const ForestSettings& settings_;
    Member member_;
    int threads_;
    forest::Stand stand_;
    RegimeState regime_state_;
    std::vector<int> tree_list_years_;
    std::vector<int> map_years_;
    std::optional<BareFalls> bare_;  ///< where they are shared
    MemberYears kept_;
};

}  // namespace

MemberYears simulate(const Decades& decades, Member member, int threads,
                     const std::function<void()>& year_done) {
    Life life{decades, member, threads};
    life.begin();
    for (std::int32_t year = 1; year <= static_cast<std::int32_t>(decades.scenario.years); ++year) {
        life.pass(year);
        year_done();
    }
    return life.take();
}

}  // namespace coupling::decades
