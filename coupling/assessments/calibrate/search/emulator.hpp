#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "coupling/assessments/calibrate/search/space.hpp"

namespace coupling::calibrate {

/// Terms of a polynomial of the numbers of a set. Each form has the terms of the one before, too.
enum class Form : std::uint8_t {
    linear,   ///< 1, x_i
    squares,  ///< x_i^2, too
    full,     ///< x_i x_j, too
};

/// How many terms a form has in so many dimensions.
std::size_t terms_of(Form form, std::size_t dimensions);

/// All terms of the full form at a point; other forms are the first ones of them.
Eigen::VectorXd terms_at(const Point& point);

/// What a figure of a summary would be, as a polynomial, without a simulation.
struct Emulator {
    Form form = Form::linear;
    std::vector<double> coefficients{};  ///< by term
    /// Root of the mean square of what the polynomial misses sets by that it was not fitted to, each left out
    /// in turn: what chance makes of a set, what the form cannot follow, and what so few sets leave open.
    double error = 0.0;
    double explained = 0.0;  ///< share of the variance that it predicts, so judged [-]; below 0: nothing

    /// `terms`: of terms_at.
    [[nodiscard]] double at(const Eigen::VectorXd& terms) const;
};

/// Least squares, of each figure with the form that misses left-out sets least. A form is tried where there
/// are twice as many sets as terms; none, where there are too few for any.
///
/// `figures`: by figure, of each point. All finite.
std::vector<Emulator> fitted_emulators(const std::vector<Point>& points,
                                       const std::vector<std::vector<double>>& figures);

}  // namespace coupling::calibrate
