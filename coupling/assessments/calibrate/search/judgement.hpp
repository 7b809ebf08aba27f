#pragma once

#include <array>
#include <string>
#include <vector>

#include "coupling/assessments/calibrate/search/learned.hpp"
#include "coupling/assessments/calibrate/search/ruled_search.hpp"
#include "coupling/assessments/calibrate/search/search.hpp"

namespace coupling::calibrate {

/// A band of a figure: 5, 25, 50, 75 and 95 % of predictions lie below. NaN where nothing is predicted.
inline constexpr std::array band_shares{0.05, 0.25, 0.50, 0.75, 0.95};
using Band = std::array<double, band_shares.size()>;

/// Observed beside predicted, of the observations that were fitted to or of those that were held out.
struct Side {
    std::size_t observed = 0;  ///< number
    double figure = 0.0;       ///< of what was observed; NaN of none
    Band predicted{};          ///< of as many simulated ones, over the sets
    Band before{};             ///< of as many by the widths, before the search
    double distance = 0.0;     ///< mean energy distance to what the sets show
    /// Share of samples of the model itself, as large, that are as far away or further [-]; NaN of none.
    double as_far = 0.0;

    [[nodiscard]] bool is_inside() const { return figure >= predicted.front() && figure <= predicted.back(); }
};

/// A place on an axis and the share of values below it.
struct CurvePoint {
    double value = 0.0;
    double observed = 0.0;
    Band predicted{};  ///< of as many simulated ones
    Band before{};     ///< of as many by the widths, before the search
};

/// All about one observation.
struct Judged {
    Side fit;
    Side held_out;
    Band before{};                  ///< of the figure of both together, by the widths: beside Transfer::sides
    std::vector<CurvePoint> curve;  ///< of all that was observed, of places along the line
    std::vector<Sample> sets;       ///< of places: what the sets show
};

/// How much of the scatter of a figure over the first wave goes with a parameter.
struct Sensitivity {
    SurveyFigure figure;
    std::vector<double> shares;  ///< by component [-]
};

/// A site by what was seen there.
struct SiteJudged {
    double fit_as_far = 0.0;       ///< Side::as_far of all that was fitted to
    double held_out_as_far = 0.0;  ///< NaN where nothing was held out
    std::vector<Sample> stops{};   ///< of the sets, where an outline was drawn
};

/// What is observed does not fit where fewer samples of the model itself are as far away [choice]: 95 %
/// limits.
inline constexpr double least_as_far = 0.05;

/// What is to be said of sets at a site that they were not fitted to.
enum class TransferVerdict {
    holds,      ///< what was observed is no further away than chance allows among so many sites
    too_far,    ///< it is
    too_few,    ///< the sets show too little of it (Judgement::shows_too_few)
    not_close,  ///< the search at the other sites did not come close
};

/// What was observed at a site beside what all other sites predict for it.
struct Transfer {
    std::size_t site = 0;
    std::vector<Side> sides;           ///< by its observation, of all that was observed
    double as_far = 0.0;               ///< Side::as_far of all of them together
    SearchEnd end = SearchEnd::close;  ///< of the search at the other sites
    std::uint64_t tried = 0;           ///< sets of that search
    bool shows_too_few = false;        ///< as that of Judgement
    std::size_t sites = 1;             ///< so many are held against the others

    /// Share of samples of the model below which what was observed is further away than chance allows: 5 %
    /// for all sites together (Bonferroni).
    [[nodiscard]] double least_as_far() const;
    [[nodiscard]] TransferVerdict verdict() const;
};

/// What became of a search.
struct Judgement {
    std::vector<Judged> observations;  ///< in their order
    std::vector<Learned> parameters;
    std::vector<Sensitivity> sensitivities;
    double fit_as_far = 0.0;            ///< Side::as_far of all observations together; of several sites the
                                        ///< least of them times their number, at most 1: no share then
    double held_out_as_far = 0.0;       ///< NaN where nothing was held out, at a site or at all
    std::vector<SiteJudged> sites;      ///< in their order
    std::vector<Transfer> transfers{};  ///< by site; none with one site or without calibrate.transfer
    std::vector<RuledOut> ruled_out{};  ///< by observation that is fitted to; none without emulators
    std::size_t held_out = 0;           ///< observations that were
    double effective_sets = 0.0;        ///< 1 / sum of squared weights
    double followed = 0.0;              ///< Adjustment::followed, at most 1

    /// What the regression leaves of the effective sets.
    [[nodiscard]] double degrees() const { return effective_sets * (1.0 - followed); }

    /// Whether more than a tenth of the sets show fewer rocks of an observation than were observed, or than
    /// 30: then distances say little.
    bool shows_too_few = false;

    /// Whether the sets may be called calibrated: the search came close, they show enough, and neither what
    /// was fitted to nor what was held out is further away than 95 % of samples of the model itself.
    bool is_calibrated = false;
};

/// Lets sets of the search fall again and holds them against all that was observed. Throws Interrupted.
/// `adjustment`: how its sets were moved to what was observed.
Judgement judge(const Simulator& simulator, const SearchState& state, const Adjustment& adjustment,
                std::uint64_t rocks);

/// Holds what was observed at one site against sets that were fitted to others. `fitted`: those others.
/// `target`: the site alone; what it does not share with them falls by the widths. Throws Interrupted.
Transfer judge_transfer(const Simulator& fitted, const SearchState& state, const Simulator& target,
                        std::size_t site, std::uint64_t rocks);

}  // namespace coupling::calibrate
