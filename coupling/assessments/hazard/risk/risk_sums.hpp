#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/assessments/consequences/consequence.hpp"
#include "coupling/assessments/hazard/hits/block_rows.hpp"
#include "coupling/assessments/hazard/risk/rate_estimate.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "rockfall/draws/strata.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::hazard::risk {

using consequences::CurveClass;
using consequences::Curves;
using consequences::index_of;
using consequences::Quantities;
using consequences::quantities;
using consequences::Quantity;

/// A block of a return period that hits an exposed target on a slope.
struct Hit {
    std::uint64_t rock = 0;
    std::uint32_t target = 0;        ///< in the list of exposed targets
    std::uint16_t block_row = 0;     ///< of hazard.blocks
    std::uint16_t energy_class = 0;  ///< of the curves
    rockfall::Cover cover = rockfall::Cover::bare;
};

/// One place or all of them on a slope.
struct SlopeRisk {
    std::array<Estimate, quantities> of{};  ///< a year
    std::vector<Quantities> by_class;       ///< the parts of its values by class of energy
    /// 95 % of the money a year by all that is not known of ground and trees, too; nothing where no
    /// parameters were drawn, or so few rocks hit that chance hides it.
    std::optional<Interval> all_money{};
    [[nodiscard]] const Estimate& at(Quantity quantity) const { return of[index_of(quantity)]; }
};

/// One place or all of them, and what the forest spares there.
struct PlaceRisk {
    std::array<SlopeRisk, rockfall::covers> slopes{};  ///< by cover
    Estimate spared_money;                             ///< bare slope less with forest, a year
    Estimate spared_deaths;
};

/// Sums over the rocks of all return periods; each row of hazard.blocks releases one rock in its return
/// period, so that a simulated rock stands for 1 / (return period x rocks of its row) a year.
///
/// Intervals hold for rocks that fall independently of each other. A rock that hits several targets adds one
/// weight to the risk of all of them together, and what it does with forest is set against what the same rock
/// does without. The individual risk of all places together is none: it is 0.
///
/// The largest weight of a rock that was not seen [choice]: it is of a row of which some block hit the place
/// on either slope, and as strong as the strongest block of that row at any target. Where no block hit the
/// place, of any row that hits another one; where none hits anything, of any row and class.
class RiskSums {
public:
    RiskSums(std::vector<TargetExposure> targets, Curves curves, RiskSettings settings);

    /// The hits of a return period, in any order; `strata`: those of its rocks. Requires rows, classes and
    /// targets that exist.
    void add_period(double return_period_years, const std::vector<hits::BlockRow>& rows,
                    std::vector<Hit> found, const rockfall::Strata& strata = {});

    [[nodiscard]] PlaceRisk at(std::size_t target) const;
    [[nodiscard]] PlaceRisk of_all() const;

private:
    using RateSums = std::array<RateSum, quantities>;
    /// Largest weights by what was seen.
    struct LargestWeights {
        Quantities of_rows_that_hit{};
        Quantities of_rows_that_hit_others{};
        Quantities possible{};
    };
    struct Place {
        std::array<RateSums, rockfall::covers> sums{};
        std::array<std::vector<Quantities>, rockfall::covers> by_class;
        std::array<RateSum, 2> spared{};  ///< money, deaths
        std::array<RateSum, 2> added{};   ///< by the forest
        LargestWeights largest;
        std::array<std::vector<RateSum>, rockfall::covers> money_of_strata;
        std::array<double, rockfall::covers> rocks{};
        bool is_hit = false;
    };
    using OfCovers = std::array<Quantities, rockfall::covers>;

    [[nodiscard]] Place empty_place() const;
    void bound_weights(double return_period_years, const std::vector<hits::BlockRow>& rows,
                       const std::vector<Hit>& found);
    static void add(Place& place, const OfCovers& rock, std::uint32_t stratum);
    void begin_strata(std::uint32_t count);
    [[nodiscard]] PlaceRisk risk_of(Place place) const;

    std::vector<TargetExposure> targets_;
    Curves curves_;
    RiskSettings settings_;
    std::vector<Place> places_;
    Place all_;
    std::optional<std::uint32_t> strata_;  ///< of all periods so far; 0: they differ
};

}  // namespace coupling::hazard::risk
