#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "coupling/assessments/calibrate/model/observations.hpp"
#include "coupling/assessments/calibrate/search/space.hpp"
#include "coupling/assessments/calibrate/sites/shared_components.hpp"
#include "coupling/assessments/calibrate/sites/site_case.hpp"
#include "coupling/run/in_order.hpp"
#include "coupling/run/ranks.hpp"

namespace coupling::calibrate {

/// What a parameter set shows of each observation, and figures that any site has.
struct Shown {
    std::vector<Sample> samples;    ///< by observation
    std::vector<Sample> stops;      ///< where an outline was drawn, by site: for maps
    std::vector<double> distances;  ///< of as many of them as were observed, by observation
    std::vector<double> summary;    ///< of the same: see add_summary
    std::vector<double> figures;    ///< by Simulator::figures; NaN where nothing shows it
};

/// Adds a few figures of a sample, of places by their line: mean, median, binary logarithm of the deviation;
/// of places the mean across, too.
void add_summary(const Sample& sample, const SightLine& line, std::vector<double>& summary);

/// A figure of a simulated set for the table of what observations would tell.
struct SurveyFigure {
    std::string name;      ///< "run_out_mean_m", "speed_mps:road"
    std::size_t site = 0;  ///< place among the sites
};

/// Lets parameter sets fall, on several threads and ranks.
class Simulator {
public:
    /// Of some sites and what they share. `ranks`: all of them do the same steps. Throws InputError (data)
    /// where too many groups and targets were observed.
    Simulator(std::vector<const SiteCase*> sites, const SharedComponents& shared, std::uint64_t seed,
              int threads, RankGroup& ranks);

    [[nodiscard]] const Space& space() const { return space_; }
    [[nodiscard]] const std::vector<const SiteCase*>& sites() const { return sites_; }
    /// Of all sites, those of each behind those of the one before.
    [[nodiscard]] const std::vector<Observation>& observations() const { return observations_; }
    [[nodiscard]] const std::vector<SightLine>& lines() const { return lines_; }
    /// Names of Shown::figures.
    [[nodiscard]] std::vector<SurveyFigure> figures() const;
    /// The summary of what was observed and is fitted to.
    [[nodiscard]] std::vector<double> observed_summary() const;
    /// Of each of its figures the place of the observation.
    [[nodiscard]] std::vector<std::size_t> observations_of_summary() const;
    [[nodiscard]] std::uint64_t seed() const { return seed_; }

    /// Simulates points numbered from `first` in a wave, and hands over what they show in their order,
    /// without samples. Ranks share the points. Throws Interrupted, FailedElsewhere.
    void show(std::span<const Point> points, std::uint16_t wave, std::uint32_t first, std::uint64_t rocks,
              const std::function<void(std::size_t, Shown&)>& take) const;
    /// The same, with samples and kept. Each rank does all of it.
    [[nodiscard]] std::vector<Shown> shown(std::span<const Point> points, std::uint16_t wave,
                                           std::uint64_t rocks) const;

private:
    void fall(std::span<const Point> points, std::uint16_t wave, std::uint32_t first, std::uint64_t rocks,
              const std::function<void(std::size_t, Shown&)>& take) const;

    std::vector<const SiteCase*> sites_;
    Space space_;
    std::vector<std::vector<std::size_t>> places_;  ///< of the components of each site in the space
    std::vector<Observation> observations_;
    std::vector<SightLine> lines_;
    std::uint64_t seed_;
    int threads_;
    RankGroup& ranks_;
};

}  // namespace coupling::calibrate
