#pragma once

#include <functional>
#include <span>
#include <vector>

#include "coupling/assessments/calibrate/model/observations.hpp"
#include "coupling/assessments/calibrate/search/space.hpp"
#include "coupling/run/in_order.hpp"
#include "coupling/run/ranks.hpp"

namespace coupling::calibrate {

/// What a parameter set shows of each observation, and figures that any site has.
struct Shown {
    std::vector<Sample> samples;    ///< by observation
    std::vector<double> distances;  ///< of as many of them as were observed, by observation
    std::vector<double> summary;    ///< of the same: see add_summary
    std::vector<double> figures;    ///< by name of `figure_names`; NaN where nothing shows it
};

/// Adds a few figures of a sample, of places by their line: mean, median, binary logarithm of the deviation;
/// of places the mean across, too.
void add_summary(const Sample& sample, const SightLine& line, std::vector<double>& summary);

/// Figures of a simulated set for the table of what observations would tell.
std::vector<std::string> figure_names(const Site& site, bool has_forest);

/// Lets parameter sets fall, on several threads and ranks.
class Simulator {
public:
    using Draw = std::function<rockfall::FallDraw(const std::vector<double>& factors)>;

    /// `draw`: laws of a set, from factors of the components in their order. `ranks`: all of them do the same
    /// steps.
    Simulator(const rockfall::Assessment& assessment, const Site& site, const Space& space,
              std::span<const Observation> observations, std::span<const SightLine> lines,
              const Search& search, Draw draw, int threads, RankGroup& ranks);

    [[nodiscard]] const Space& space() const { return space_; }
    [[nodiscard]] std::span<const Observation> observations() const { return observations_; }
    /// The summary of what was observed and is fitted to.
    [[nodiscard]] std::vector<double> observed_summary() const;
    [[nodiscard]] std::uint64_t seed() const { return assessment_.seed; }

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
    [[nodiscard]] std::vector<double> figures_of(const SetRocks& rocks) const;

    const rockfall::Assessment& assessment_;
    const Site& site_;
    const Space& space_;
    std::span<const Observation> observations_;
    std::span<const SightLine> lines_;
    const Search& search_;
    Draw draw_;
    int threads_;
    RankGroup& ranks_;
};

}  // namespace coupling::calibrate
