#include "coupling/inputs/plausible/close_trees.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "config/text/numbers.hpp"

namespace coupling::plausible {
namespace {

/// Two surveys of one tree by tape or GPS differ less; neighbours in a stand seldom stand so near [choice].
constexpr double twin_reach_m = 0.5;
/// Two censuses of ten years differ less in DBH [choice].
constexpr double twin_growth = 0.15;
/// Of random places at 2000 stems/ha of 20 cm 2.5 % lie inside a stem, in real lists below 0.5 % [choice].
constexpr double most_inside = 0.05;
/// At 500 stems/ha 0.3 % have a twin by chance, in thickets of one species 10 %; of two censuses half
/// [choice].
constexpr double most_twins = 0.25;
constexpr std::size_t fewest = 5;

struct PlacedStem {
    double x_m;
    double y_m;
    double dbh_cm;
    std::string species;
};

std::vector<PlacedStem> stems_in(const config::Table& table) {
    std::vector<PlacedStem> stems;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto x_m = config::parse_number(table.text(row, "x_m"));
        const auto y_m = config::parse_number(table.text(row, "y_m"));
        const auto dbh_cm =
            table.has("dbh_cm") ? config::parse_number(table.text(row, "dbh_cm")) : std::nullopt;
        if (x_m && y_m && dbh_cm) {
            stems.push_back({*x_m, *y_m, *dbh_cm, table.text(row, "species")});
        }
    }
    return stems;
}

bool is_inside(double distance_m, const PlacedStem& a, const PlacedStem& b) {
    const double radius_m = 0.005 * std::max(a.dbh_cm, b.dbh_cm);
    return distance_m == 0.0 || distance_m < std::min(radius_m, twin_reach_m);
}

bool are_twins(double distance_m, const PlacedStem& a, const PlacedStem& b) {
    return distance_m <= twin_reach_m && a.species == b.species &&
           std::abs(a.dbh_cm - b.dbh_cm) <= twin_growth * std::max(a.dbh_cm, b.dbh_cm);
}

/// Trees that belong together, directly or around others: groups do not depend on the order of a list.
class Groups {
public:
    explicit Groups(std::size_t trees) : leader_(trees) {
        std::iota(leader_.begin(), leader_.end(), std::size_t{0});
    }
    void join(std::size_t a, std::size_t b) {
        const std::size_t one = leader_of(a), other = leader_of(b);
        joined_ += one != other ? 1 : 0;
        leader_[std::max(one, other)] = std::min(one, other);
    }
    /// Trees less the first of each group.
    [[nodiscard]] std::size_t beyond_the_first() const { return joined_; }

private:
    std::size_t leader_of(std::size_t tree) {
        while (leader_[tree] != tree) {
            tree = leader_[tree] = leader_[leader_[tree]];
        }
        return tree;
    }

    std::vector<std::size_t> leader_;
    std::size_t joined_ = 0;
};

}  // namespace

CloseTrees close_trees(const config::Table& table) {
    using Square = std::pair<double, double>;
    std::map<Square, std::vector<std::size_t>> earlier;
    const std::vector<PlacedStem> stems = stems_in(table);
    Groups inside{stems.size()};
    Groups twins{stems.size()};
    constexpr std::size_t most_in_square = 1000;  // a list with one place for all must not take for ever
    for (std::size_t i = 0; i < stems.size(); ++i) {
        const PlacedStem& stem = stems[i];
        const Square own{std::floor(stem.x_m / twin_reach_m), std::floor(stem.y_m / twin_reach_m)};
        for (int k = 0; k < 9; ++k) {
            const auto near = earlier.find({own.first + k % 3 - 1, own.second + k / 3 - 1});
            if (near == earlier.end()) {
                continue;
            }
            for (const std::size_t j : near->second) {
                const double distance_m = std::hypot(stem.x_m - stems[j].x_m, stem.y_m - stems[j].y_m);
                if (is_inside(distance_m, stem, stems[j])) {
                    inside.join(i, j);
                }
                if (are_twins(distance_m, stem, stems[j])) {
                    twins.join(i, j);
                }
            }
        }
        std::vector<std::size_t>& here = earlier[own];
        if (here.size() < most_in_square) {
            here.push_back(i);
        }
    }
    return {inside.beyond_the_first(), twins.beyond_the_first()};
}

bool are_too_close(const CloseTrees& found, std::size_t all) {
    const auto share = [&](std::size_t count) {
        return static_cast<double>(count) / static_cast<double>(all);
    };
    return (found.inside >= fewest && share(found.inside) > most_inside) ||
           (found.twins >= fewest && share(found.twins) > most_twins);
}

double basal_area_where_trees_stand_m2pha(std::span<const PlacedTree> trees) {
    constexpr double cell_m = 20.0;
    constexpr double cell_ha = cell_m * cell_m * 1e-4;
    std::set<std::pair<double, double>> cells;
    double basal_area_m2 = 0.0;
    for (const PlacedTree& tree : trees) {
        cells.emplace(std::floor(tree.x_m / cell_m), std::floor(tree.y_m / cell_m));
        basal_area_m2 += 0.25 * M_PI * tree.dbh_cm * tree.dbh_cm * 1e-4;
    }
    return cells.empty() ? 0.0 : basal_area_m2 / (cell_ha * static_cast<double>(cells.size()));
}

}  // namespace coupling::plausible
