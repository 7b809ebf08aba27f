#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/parameters/parameter_widths.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "rockfall/slope/slope.hpp"

namespace coupling {

/// Values that go together, as `bannwald calibrate` leaves them: parameters trade off against each other.
struct JointSample {
    std::string file;
    std::vector<std::string> parameters;       ///< names as of components of ParameterDraws
    std::vector<std::vector<double>> factors;  ///< by set, by parameter, above 0 [-]
    std::vector<double> weights;               ///< of each set, sum 1

    /// Place of a parameter; nothing where the sample does not have it.
    [[nodiscard]] std::optional<std::size_t> find(const std::string& parameter) const;
    /// The set in which a share `uniform` [0, 1) of the weights ends.
    [[nodiscard]] std::size_t set_at(double uniform) const;
    /// The geometric mean of each factor: its values go together as those of the sets do.
    [[nodiscard]] std::vector<double> centre() const;
};

/// What is known of the laws of the fall: widths of factors around 1, and a sample of some of them, which
/// then count instead of their widths.
struct ParameterKnowledge {
    std::vector<ParameterWidth> widths;
    std::optional<JointSample> sample{};
    bool is_drawn = true;  ///< false: all rocks fall by the central values (run.parameter_draws)

    /// Whether rocks or replicates fall by different values.
    [[nodiscard]] bool has_spread() const;
};

/// The shipped widths with what run.parameters says: a table of widths, or a joint sample (it has a column
/// `weight`). `types`: of the site, which parameters may name by their codes. Throws InputError (data).
std::shared_ptr<const ParameterKnowledge> read_parameter_knowledge(
    const std::vector<rockfall::SurfaceType>& types, Reading& reading);

}  // namespace coupling
