#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "coupling/assessments/calibrate/search/emulator.hpp"

namespace coupling::calibrate {

/// A figure of the summary that was observed, and what its emulator says of sets.
struct Rule {
    std::uint32_t figure = 0;  ///< place in the summary
    Emulator emulator{};
    double observed = 0.0;
    /// Of observed - emulated, for a set that shows what was observed: the emulator's error and the scatter
    /// of a sample as large as what was observed.
    double deviation = 0.0;

    [[nodiscard]] double implausibility(const Eigen::VectorXd& terms) const;
};

/// Sets are not simulated whose largest implausibility is above this. 95 % of any distribution with one peak
/// lie within three deviations of it (Pukelsheim 1994).
inline constexpr double most_implausible = 3.0;

/// What a round of history matching rules out (Craig et al. 1997; Vernon, Goldstein & Bower 2010, Bayesian
/// Analysis 5:619): sets that an emulator says would not show what was observed.
struct Ruling {
    std::vector<Rule> rules{};
    double left = 1.0;  ///< share of what the widths allow that neither it nor one before rules out [-]

    /// Whether it keeps a set, whatever those before it say.
    [[nodiscard]] bool keeps(const Eigen::VectorXd& terms) const;
};

/// Whether all of them keep a set.
bool keep(std::span<const Ruling> rulings, const Point& point);

/// A set that fell, for a ruling.
struct Fallen {
    const Point* point = nullptr;
    const std::vector<double>* summary = nullptr;
};

/// Emulators of all figures, fitted to the sets that rulings so far keep, or to all where those are few; sets
/// that lack a figure are left out. Without rules where there are too few sets.
///
/// `observed`: the summary of what was observed; `scatter`: of each figure, see `tolerated`.
Ruling ruling_of(std::span<const Ruling> so_far, const std::vector<Fallen>& sets,
                 const std::vector<double>& observed, const std::vector<double>& scatter);

/// The deviation of each figure over summaries. Requires two of them.
std::vector<double> deviations_of(const std::vector<std::vector<double>>& summaries);

/// For a ruling: the larger of `deviations` and of the root mean square by which the summaries of sets that a
/// search keeps are off what was observed. A figure that the distance hardly sees may be far off: no set is
/// ruled out by it that would be kept.
std::vector<double> tolerated(std::vector<double> deviations, const std::vector<Fallen>& kept,
                              const std::vector<double>& observed);

/// A set by the widths, from uniform numbers.
Point point_by_widths(std::size_t dimensions, const std::function<double()>& uniform);

/// The share of what the widths allow that all rulings keep, by draws; 0 where none of two million is kept.
double share_left(std::span<const Ruling> rulings, std::size_t dimensions,
                  const std::function<double()>& uniform);

/// The share of what the widths allow that the rules of each observation alone rule out, in any ruling, by
/// 20,000 draws. `observation_of`: of each figure of the summary, below `observations`.
std::vector<double> shares_ruled_out(std::span<const Ruling> rulings, std::size_t dimensions,
                                     const std::vector<std::size_t>& observation_of, std::size_t observations,
                                     const std::function<double()>& uniform);

}  // namespace coupling::calibrate
