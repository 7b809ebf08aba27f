#include "coupling/assessments/calibrate/model/surveyed_trees.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace coupling::calibrate {
namespace {

/// Further away a stem is another one.
constexpr double same_place_m = 1.0;
/// Diameters further apart than by this factor are not of one stem.
constexpr double same_size = 1.33;

std::pair<double, double> place_of(const Eigen::Vector2d& point) {
    return {point.x(), point.y()};
}

/// Stems from west to east.
std::vector<const rockfall::Stem*> from_west(const Site& site) {
    std::vector<const rockfall::Stem*> stems;
    for (const TreeRecord& tree : site.trees) {
        stems.push_back(&tree.stem);
    }
    std::stable_sort(stems.begin(), stems.end(),
                     [](const rockfall::Stem* a, const rockfall::Stem* b) { return a->x_m < b->x_m; });
    return stems;
}

/// The nearest stem within reach, nullptr without any.
const rockfall::Stem* stem_at(const std::vector<const rockfall::Stem*>& stems, const Eigen::Vector2d& at_m) {
    const rockfall::Stem* nearest = nullptr;
    double least_m = same_place_m;
    for (auto stem =
             std::lower_bound(stems.begin(), stems.end(), at_m.x() - same_place_m,
                              [](const rockfall::Stem*one, double west_m) { return one->x_m < west_m; });
         stem != stems.end() && (*stem)->x_m <= at_m.x() + same_place_m; ++stem) {
        const double off_m = (Eigen::Vector2d{(*stem)->x_m, (*stem)->y_m} - at_m).norm();
        if (off_m < least_m || (nearest == nullptr && off_m <= least_m)) {
            least_m = off_m;
            nearest = *stem;
        }
    }
    return nearest;
}

}  // namespace

SurveyedTrees::SurveyedTrees(const Site& site, double least_dbh_cm) {
    const std::vector<const rockfall::Stem*> stems = from_west(site);
    std::set<const rockfall::Stem*> taken;
    for (const ObservedTree& tree : site.observed_events.trees) {
        const rockfall::Stem* stem = stem_at(stems, tree.at_m);
        if (stem == nullptr) {
            without_stem_.push_back(tree.line);
            continue;
        }
        if (!taken.insert(stem).second) {
            repeated_.push_back(tree.line);
            continue;
        }
        if (tree.dbh_cm &&
            (*tree.dbh_cm > same_size * stem->dbh_cm || stem->dbh_cm > same_size * *tree.dbh_cm)) {
            of_other_size_.push_back(tree.line);
        }
        if (stem->dbh_cm >= least_dbh_cm) {
            trees_.push_back({{stem->x_m - site.origin_m().x(), stem->y_m - site.origin_m().y()},
                              stem->dbh_cm,
                              tree.scars});
        }
    }
    std::sort(trees_.begin(), trees_.end(),
              [](const Tree& a, const Tree& b) { return place_of(a.stem_m) < place_of(b.stem_m); });
}

SurveyedTrees SurveyedTrees::with_mark(const std::vector<bool>& marks, bool wanted) const {
    SurveyedTrees some = *this;
    some.trees_.clear();
    for (std::size_t i = 0; i < trees_.size(); ++i) {
        if (marks[i] == wanted) {
            some.trees_.push_back(trees_[i]);
        }
    }
    return some;
}

std::uint64_t SurveyedTrees::scars() const {
    std::uint64_t sum = 0;
    for (const Tree& tree : trees_) {
        sum += tree.scars;
    }
    return sum;
}

std::optional<std::size_t> SurveyedTrees::find(const Eigen::Vector2d& stem_m) const {
    const auto found = std::lower_bound(
        trees_.begin(), trees_.end(), stem_m,
        [](const Tree& tree, const Eigen::Vector2d& at) { return place_of(tree.stem_m) < place_of(at); });
    if (found == trees_.end() || found->stem_m != stem_m) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - trees_.begin());
}

}  // namespace coupling::calibrate
