#include "coupling/assessments/calibrate/search/adjustment.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "coupling/inputs/parameters/correlated_draws.hpp"

namespace coupling::calibrate {

Adjustment adjust(std::vector<Member>& members, const std::vector<double>& observed) {
    Adjustment adjustment;
    for (const Member& member : members) {
        adjustment.before.push_back(member.point);
    }
    adjustment.pulls.assign(members.size(), 0.0);
    const auto figures = static_cast<Eigen::Index>(observed.size());
    constexpr std::size_t sets_a_figure = 5;
    if (members.empty() || members.size() < sets_a_figure * observed.size()) {
        return adjustment;
    }
    const bool all_known = std::all_of(members.begin(), members.end(), [](const Member& member) {
        return std::all_of(member.summary.begin(), member.summary.end(),
                           [](double figure) { return std::isfinite(figure); });
    });
    if (!all_known) {  // some sets show nothing of something that was seen: they do not lie on one plane
        return adjustment;
    }
    // Figures by mean and deviation: their units differ.
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(figures);
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(figures);
    const auto summary = [](const Member& member) {
        return Eigen::Map<const Eigen::VectorXd>(member.summary.data(),
                                                 static_cast<Eigen::Index>(member.summary.size()));
    };
    for (const Member& member : members) {
        mean += member.weight * summary(member);
    }
    for (const Member& member : members) {
        squares += member.weight * (summary(member) - mean).cwiseAbs2();
    }
    const Eigen::VectorXd deviation = squares.cwiseSqrt().cwiseMax(1e-12);
    const auto standard = [&](const Eigen::VectorXd& values) -> Eigen::VectorXd {
        return (values - mean).cwiseQuotient(deviation);
    };
    const Eigen::VectorXd seen = standard(Eigen::Map<const Eigen::VectorXd>(observed.data(), figures));
    const Eigen::Index size = members.front().point.size();
    Point mean_point = Point::Zero(size);
    for (const Member& member : members) {
        mean_point += member.weight * member.point;
    }
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(figures, figures);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(figures, size);
    for (const Member& member : members) {
        const Eigen::VectorXd x = standard(summary(member));
        normal += member.weight * x * x.transpose();
        right += member.weight * x * (member.point - mean_point).transpose();
    }
    // A ridge of one hundredth [choice]: figures of a summary go together.
    normal.diagonal().array() += 0.01;
    const Eigen::LLT<Eigen::MatrixXd> factored{normal};
    const Eigen::MatrixXd slopes = factored.solve(right);
    // What the plane takes of the scatter by following chance: with few sets, or unequal weights, much.
    for (std::size_t i = 0; i < members.size(); ++i) {
        const Eigen::VectorXd x = standard(summary(members[i]));
        adjustment.pulls[i] = x.dot(factored.solve(x));
        adjustment.followed += members[i].weight * members[i].weight * adjustment.pulls[i];
    }
    constexpr double most_followed = 0.5;
    const double widening = 1.0 / std::sqrt(1.0 - std::min(most_followed, adjustment.followed));
    adjustment.is_capped = adjustment.followed > most_followed;
    const Point centre = mean_point + slopes.transpose() * seen;
    for (Member& member : members) {
        const Point residual = member.point - mean_point - slopes.transpose() * standard(summary(member));
        member.point = centre + widening * residual;
        member.point = member.point.cwiseMax(-most_deviations).cwiseMin(most_deviations);
    }
    return adjustment;
}

}  // namespace coupling::calibrate
