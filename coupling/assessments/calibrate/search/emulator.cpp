#include "coupling/assessments/calibrate/search/emulator.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace coupling::calibrate {

std::size_t terms_of(Form form, std::size_t dimensions) {
    switch (form) {
        case Form::linear:
            return 1 + dimensions;
        case Form::squares:
            return 1 + 2 * dimensions;
        case Form::full:
            break;
    }
    return 1 + 2 * dimensions + dimensions * (dimensions - 1) / 2;
}

Eigen::VectorXd terms_at(const Point& point) {
    const Eigen::Index size = point.size();
    Eigen::VectorXd terms(static_cast<Eigen::Index>(terms_of(Form::full, static_cast<std::size_t>(size))));
    terms[0] = 1.0;
    terms.segment(1, size) = point;
    terms.segment(1 + size, size) = point.cwiseAbs2();
    Eigen::Index place = 1 + 2 * size;
    for (Eigen::Index i = 0; i < size; ++i) {
        for (Eigen::Index j = i + 1; j < size; ++j) {
            terms[place++] = point[i] * point[j];
        }
    }
    return terms;
}

double Emulator::at(const Eigen::VectorXd& terms) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        sum += coefficients[i] * terms[static_cast<Eigen::Index>(i)];
    }
    return sum;
}

std::vector<Emulator> fitted_emulators(const std::vector<Point>& points,
                                       const std::vector<std::vector<double>>& figures) {
    if (points.empty()) {
        return {};
    }
    const auto dimensions = static_cast<std::size_t>(points.front().size());
    const auto sets = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd all(sets, static_cast<Eigen::Index>(terms_of(Form::full, dimensions)));
    for (Eigen::Index row = 0; row < sets; ++row) {
        all.row(row) = terms_at(points[static_cast<std::size_t>(row)]).transpose();
    }
    std::vector<Emulator> best(figures.size());
    bool is_fitted = false;
    for (const Form form : {Form::linear, Form::squares, Form::full}) {
        const auto terms = static_cast<Eigen::Index>(terms_of(form, dimensions));
        if (sets < 2 * terms) {
            break;
        }
        const Eigen::MatrixXd x = all.leftCols(terms);
        Eigen::MatrixXd normal = x.transpose() * x;
        // Keeps it definite where a parameter hardly varies [choice].
        normal.diagonal().array() += 1e-6 * static_cast<double>(sets);
        const Eigen::LLT<Eigen::MatrixXd> factored{normal};
        const Eigen::MatrixXd half = factored.matrixL().solve(x.transpose());
        const Eigen::VectorXd own =
            half.colwise().squaredNorm().transpose();  // what a set has in its own prediction
        for (std::size_t figure = 0; figure < figures.size(); ++figure) {
            const Eigen::Map<const Eigen::VectorXd> values{figures[figure].data(), sets};
            const Eigen::VectorXd coefficients = factored.solve(x.transpose() * values);
            const Eigen::VectorXd missed =
                ((values - x * coefficients).array() / (1.0 - own.array()).max(1e-9)).matrix();
            const double error = std::sqrt(missed.squaredNorm() / static_cast<double>(sets));
            if (form == Form::linear || error < best[figure].error) {
                const double variance =
                    (values.array() - values.mean()).square().sum() / static_cast<double>(sets);
                best[figure] = {form,
                                {coefficients.begin(), coefficients.end()},
                                error,
                                variance > 0.0 ? 1.0 - error * error / variance : 0.0};
            }
        }
        is_fitted = true;
    }
    return is_fitted ? best : std::vector<Emulator>{};
}

}  // namespace coupling::calibrate
