#include "coupling/inputs/plausible/unlike_trees.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "config/text/numbers.hpp"

namespace coupling::plausible {
namespace {

constexpr std::size_t fewest_trees_to_compare = 20;
constexpr double girths_from_cm = 10.0;
constexpr double part_of_heights = 0.4;  // below the median, as girths lift it
constexpr double girth_least = 2.2;
constexpr double girth_most = 5.0;
constexpr double gather_least = 2.6;
constexpr double gather_most = 4.3;
constexpr double tail_least = 1.8;
constexpr double girth_slenderness_most = 40.0;
constexpr std::size_t fewest_girths = 5;
constexpr double least_share_of_girths = 0.03;
constexpr double swapped_slenderness = 100.0;
constexpr double swapped_from_m = 5.0;
constexpr double too_high = 1.57;
constexpr double like_others = 1.35;

struct ListedSize {
    std::size_t line = 0;
    double dbh_cm = 0.0;
    double height_m = 0.0;
};

std::vector<ListedSize> sizes_of_living(const config::Table& table) {
    std::vector<ListedSize> sizes;
    if (!table.has("dbh_cm") || !table.has("height_m")) {
        return sizes;
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string state = table.has("state") ? table.text(row, "state") : "";
        const std::optional<double> dbh_cm = config::parse_number(table.text(row, "dbh_cm"));
        const std::optional<double> height_m = config::parse_number(table.text(row, "height_m"));
        if (dbh_cm && height_m && *dbh_cm > 0.0 && *height_m > 0.0 && (state.empty() || state == "living")) {
            sizes.push_back({table.place(row, "dbh_cm").line, *dbh_cm, *height_m});
        }
    }
    return sizes;
}

/// What trees of about the same size have of another one: a quantile of the nearest trees of the list.
class LikeTrees {
public:
    /// Requires pairs of a size and what is asked for.
    LikeTrees(std::vector<std::pair<double, double>> pairs, double quantile) {
        std::sort(pairs.begin(), pairs.end());
        const std::size_t half = std::max<std::size_t>(10, pairs.size() / 40);
        const std::size_t window = std::min(pairs.size(), 2 * half + 1);
        for (std::size_t middle = 0; middle < pairs.size(); middle += std::max<std::size_t>(1, half / 4)) {
            const std::size_t first =
                std::min(middle > half ? middle - half : std::size_t{0}, pairs.size() - window);
            std::vector<double> values;
            for (std::size_t i = first; i < first + window; ++i) {
                values.push_back(pairs[i].second);
            }
            const auto place =
                values.begin() + static_cast<std::ptrdiff_t>(quantile * static_cast<double>(window - 1));
            std::nth_element(values.begin(), place, values.end());
            nodes_.emplace_back(pairs[middle].first, *place);
        }
    }

    [[nodiscard]] double at(double size) const {
        const auto next =
            std::lower_bound(nodes_.begin(), nodes_.end(), size,
                             [](const std::pair<double, double>& node, double x) { return node.first < x; });
        if (next == nodes_.begin() || next == nodes_.end()) {
            return next == nodes_.begin() ? next->second : nodes_.back().second;
        }
        const auto before = std::prev(next);
        return size - before->first < next->first - size ? before->second : next->second;
    }

private:
    std::vector<std::pair<double, double>> nodes_;
};

std::vector<std::size_t> girth_lines_of(const std::vector<ListedSize>& sizes) {
    std::vector<std::pair<double, double>> dbh_of_height;
    for (const ListedSize& tree : sizes) {
        if (tree.dbh_cm >= girths_from_cm) {
            dbh_of_height.emplace_back(tree.height_m, tree.dbh_cm);
        }
    }
    const std::size_t trees = dbh_of_height.size();
    if (trees < fewest_trees_to_compare) {
        return {};
    }
    const LikeTrees usual_cm{std::move(dbh_of_height), part_of_heights};
    std::vector<std::size_t> lines;
    std::size_t gathered = 0;
    std::size_t in_tail = 0;
    for (const ListedSize& tree : sizes) {
        if (tree.dbh_cm < girths_from_cm) {
            continue;
        }
        const double times = tree.dbh_cm / usual_cm.at(tree.height_m);
        in_tail += times >= tail_least && times < gather_least ? 1U : 0U;
        gathered += times >= gather_least && times < gather_most ? 1U : 0U;
        if (times >= girth_least && times < girth_most &&
            100.0 * tree.height_m / tree.dbh_cm < girth_slenderness_most) {
            lines.push_back(tree.line);
        }
    }
    const bool are_girths =
        lines.size() >= fewest_girths && gathered > in_tail &&
        static_cast<double>(lines.size()) >= least_share_of_girths * static_cast<double>(trees);
    return are_girths ? lines : std::vector<std::size_t>{};
}

std::vector<std::size_t> swapped_lines_of(const std::vector<ListedSize>& sizes) {
    std::vector<std::pair<double, double>> height_of_dbh;
    for (const ListedSize& tree : sizes) {
        height_of_dbh.emplace_back(tree.dbh_cm, tree.height_m);
    }
    const LikeTrees usual_m{std::move(height_of_dbh), 0.5};
    std::vector<std::size_t> lines;
    for (const ListedSize& tree : sizes) {
        const double exchanged = tree.dbh_cm / usual_m.at(tree.height_m);
        if (tree.height_m >= swapped_from_m && 100.0 * tree.height_m / tree.dbh_cm >= swapped_slenderness &&
            tree.height_m > too_high * usual_m.at(tree.dbh_cm) && exchanged < like_others &&
            exchanged > 1.0 / like_others) {
            lines.push_back(tree.line);
        }
    }
    return lines;
}

}  // namespace

UnlikeTrees unlike_trees(const config::Table& table) {
    const std::vector<ListedSize> sizes = sizes_of_living(table);
    if (sizes.size() < fewest_trees_to_compare) {
        return {};
    }
    return {girth_lines_of(sizes), swapped_lines_of(sizes)};
}

}  // namespace coupling::plausible
