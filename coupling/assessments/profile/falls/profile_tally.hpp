#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "coupling/assessments/profile/falls/profile_site.hpp"
#include "coupling/results/figures/indicators.hpp"
#include "coupling/run/watched_falls.hpp"
#include "rockfall/tally/ensemble_tally.hpp"
#include "rockfall/tally/log_bins.hpp"

namespace coupling::profile {

/// Count, mean, standard deviation and extremes of numbers that come one by one (Welford 1962). The order of
/// the numbers decides the last bits: rocks come in rock order.
class Moments {
public:
    void add(double value);
    [[nodiscard]] std::uint64_t count() const { return count_; }
    [[nodiscard]] double mean() const;                         ///< NaN without numbers
    [[nodiscard]] double deviation() const;                    ///< of the sample; NaN below two numbers
    [[nodiscard]] double squares() const { return squares_; }  ///< around the mean
    [[nodiscard]] double least() const { return count_ > 0 ? least_ : no_number; }
    [[nodiscard]] double most() const { return count_ > 0 ? most_ : no_number; }

private:
    static constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
    std::uint64_t count_ = 0;
    double mean_ = 0.0;
    double squares_ = 0.0;
    double least_ = std::numeric_limits<double>::infinity();
    double most_ = -std::numeric_limits<double>::infinity();
};

/// Moments and counts in logarithmic bins.
struct Spread {
    Moments moments;
    std::vector<std::uint64_t> counts;

    void add(const rockfall::LogBins& bins, double value);
    /// Value below which a share lies, between the extremes; NaN where fewer than one number lies above it
    /// (percentile_is_known()).
    [[nodiscard]] double quantile(const rockfall::LogBins& bins, double share) const;
};

/// What passes a station.
struct StationTally {
    Spread energy_j;  ///< translation and rotation, fine_energy_bins
    std::array<std::uint64_t, rockfall::counted_energies_j.size()> above{};  ///< from those on
    Moments translational_j;
    Spread speed_mps;  ///< fine_speed_bins
    Spread height_m;   ///< of the underside above ground, vertical, fine_height_bins
};

/// Shares of all rocks that pass a station with each or more of rockfall::counted_energies_j.
std::array<Share, rockfall::counted_energies_j.size()> rates_of(const StationTally& station,
                                                                std::uint64_t rocks);

/// Jumps that end with a ground impact inside a segment of the slope. Flights from the release count not:
/// their length is none from impact to impact. Nor do those that end where they begin.
struct SegmentTally {
    Moments length_m;  ///< straight from impact to impact
    Moments impact_mps;
    Moments height_m;  ///< largest height of each above the ground, vertical
};

/// The largest values of each rock in a stretch of the profile.
struct StretchTally {
    Spread energy_j;   ///< energy_bins
    Spread height_m;   ///< normal to the slope, height_bins
    Spread speed_mps;  ///< fine_speed_bins
};

/// What is counted of the rocks of a stratum, which share one draw of what is not known.
struct StratumOnProfile {
    struct Passing {
        Moments energy_j;
        Moments speed_mps;
        Moments height_m;
    };
    std::uint64_t rocks = 0;
    Moments run_out_m;  ///< of those that came to rest
    std::vector<Passing> stations;
};

struct SampledPath {
    std::uint64_t rock;
    std::vector<rockfall::PathPoint> points;
};

/// Everything counted over the rocks of a run along a profile.
struct ProfileTally {
    double segment_m;  ///< slope length of a segment
    double stretch_m;  ///< plan length of a stretch, and the step of the run-out curve
    std::uint64_t rocks = 0;
    std::array<std::uint64_t, rockfall::stop_reasons> by_reason{};
    std::uint64_t left_upper = 0;  ///< of those that left: over the upper end of the profile
    std::uint64_t left_lower = 0;
    Moments run_out_m;           ///< of those that came to rest, in plan from the release to the end
    Moments run_out_at_least_m;  ///< of all: one that did not come to rest counts to where it was seen last
    Spread max_speed_mps;
    Spread max_energy_j;
    Spread max_height_m;
    Moments mean_speed_mps;
    Moments ground_impacts;
    Moments jump_length_m;  ///< of all segments together
    std::vector<std::uint64_t>
        ends;  ///< rocks whose fall ended in each stretch; one more: over the lower end
    std::vector<StationTally> stations;
    std::vector<SegmentTally> segments;
    std::vector<StretchTally> stretches;
    std::vector<SampledPath> paths;
    std::vector<StratumOnProfile> strata;  ///< none: all rocks fall by the same laws

    ProfileTally(const ProfileSite& site, double segment_m_in, std::size_t strata_in = 0);
    /// Requires a fall that started. `stratum`: of its rock, where there are some.
    void add(const ProfileSite& site, const WatchedFall& fall, bool released_in_flight,
             std::size_t stratum = 0);
    /// Rocks whose fall ended beyond the end of so many stretches.
    [[nodiscard]] std::uint64_t ended_beyond(std::size_t stretches_passed) const;
    /// The map frame that goes with the stretches: one row of them.
    [[nodiscard]] config::GridFrame frame(const ProfileSite& site) const;
};

}  // namespace coupling::profile
