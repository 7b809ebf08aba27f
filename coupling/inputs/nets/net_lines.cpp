#include "coupling/inputs/nets/net_lines.hpp"

#include <algorithm>
#include <array>

namespace coupling {
namespace {

double side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool is_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return side_of(a, b, p) == 0.0 && (p - a).dot(p - b) <= 0.0;
}

/// Whether two pieces of line have a point in common.
bool touch(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
           const Eigen::Vector2d& d) {
    const double c_side = side_of(a, b, c);
    const double d_side = side_of(a, b, d);
    const double a_side = side_of(c, d, a);
    const double b_side = side_of(c, d, b);
    return (c_side * d_side < 0.0 && a_side * b_side < 0.0) || is_between(a, b, c) || is_between(a, b, d) ||
           is_between(c, d, a) || is_between(c, d, b);
}

/// A part of a line, by the way along it from its first corner.
struct Stretch {
    double first_m = 0.0;
    double last_m = 0.0;
};

/// The part of the piece c-d that lies beside a-b, no farther than `within_m`; from c on. Ends before it
/// begins where there is none.
Stretch part_beside(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                    const Eigen::Vector2d& d, double within_m) {
    const double length_m = (b - a).norm();
    const Eigen::Vector2d along = (b - a) / length_m;
    const Eigen::Vector2d across{-along.y(), along.x()};
    double first = 0.0;  // of the way from c to d
    double last = 1.0;
    const auto keep_between = [&](const Eigen::Vector2d& axis, double low_m, double high_m) {
        const double start_m = (c - a).dot(axis);
        const double way_m = (d - c).dot(axis);
        if (way_m == 0.0) {
            last = start_m < low_m || start_m > high_m ? first : last;
            return;
        }
        const auto [enters, leaves] = std::minmax({(low_m - start_m) / way_m, (high_m - start_m) / way_m});
        first = std::max(first, enters);
        last = std::min(last, leaves);
    };
    keep_between(along, 0.0, length_m);
    keep_between(across, -within_m, within_m);
    const double way_m = (d - c).norm();
    return {first * way_m, last * way_m};
}

/// The sum of all stretches longer than `least_m`; those that overlap or follow each other within `gap_m` are
/// one.
double length_of_all_m(std::vector<Stretch> stretches, double gap_m, double least_m) {
    std::sort(stretches.begin(), stretches.end(),
              [](const Stretch& a, const Stretch& b) { return a.first_m < b.first_m; });
    double sum_m = 0.0;
    for (std::size_t i = 0; i < stretches.size();) {
        Stretch joined = stretches[i];
        for (++i; i < stretches.size() && stretches[i].first_m <= joined.last_m + gap_m; ++i) {
            joined.last_m = std::max(joined.last_m, stretches[i].last_m);
        }
        const double length_m = joined.last_m - joined.first_m;
        sum_m += length_m > least_m ? length_m : 0.0;
    }
    return sum_m;
}

}  // namespace

bool meets_itself(const PlanLine& line) {
    const std::size_t pieces = line.size() - 1;
    const bool closed = line.front() == line.back();
    for (std::size_t i = 0; i < pieces; ++i) {
        for (std::size_t j = i + 1; j < pieces; ++j) {
            const bool next_to_it = j == i + 1 || (closed && i == 0 && j + 1 == pieces);
            if (!next_to_it && touch(line[i], line[i + 1], line[j], line[j + 1])) {
                return true;
            }
            if (j == i + 1 && (is_between(line[i], line[i + 1], line[j + 1]) ||
                               is_between(line[j], line[j + 1], line[i]))) {
                return true;  // folds back onto itself
            }
        }
    }
    return false;
}

double shared_length_m(const PlanLine& line, const PlanLine& other, double within_m, double least_m) {
    std::vector<Stretch> beside;
    double way_m = 0.0;
    for (std::size_t j = 1; j < other.size(); ++j) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Stretch part = part_beside(line[i - 1], line[i], other[j - 1], other[j], within_m);
            if (part.last_m > part.first_m) {
                beside.push_back({way_m + part.first_m, way_m + part.last_m});
            }
        }
        way_m += (other[j] - other[j - 1]).norm();
    }
    // Between two pieces that meet at an angle a part as wide as both reach is beside neither.
    return length_of_all_m(std::move(beside), 2.0 * within_m, least_m);
}

double length_in_one_place_m(const PlanLine& line, const PlanLine& other) {
    struct Rule {
        double within_m;
        double least_m;
    };
    constexpr std::array rules{Rule{1e-6, 1e-3}, Rule{0.01, 0.1}};
    double longest_m = 0.0;
    for (const Rule& rule : rules) {
        longest_m = std::max(longest_m, shared_length_m(line, other, rule.within_m, rule.least_m));
    }
    return longest_m;
}

}  // namespace coupling
