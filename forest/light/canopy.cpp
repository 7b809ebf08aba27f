#include "forest/light/canopy.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace forest {
namespace {

/// Whole-number units of extinction-weighted leaf area: a millionth of a square metre, roughly.
constexpr double units_per_m2 = 1048576.0;

constexpr std::size_t rings = 4;
constexpr std::size_t ground_points = 4;
constexpr std::size_t columns_of_crown = rings * ground_points;

/// Where the points of a ring lie, as shares of the crown's radius. Every second ring is turned by an eighth
/// of a circle, so the crown looks the same in a mirror.
struct Point {
    double x;
    double y;
};
constexpr std::array<double, rings> ring_area{0.125, 0.375, 0.625,
                                              0.875};  // middle of each ring, as (r / R)^2

constexpr double sqrt_half = 0.70710678118654752;

std::array<Point, columns_of_crown> points_of_crown() {
    constexpr std::array<Point, ground_points> straight{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}}};
    constexpr std::array<Point, ground_points> diagonal{
        {{sqrt_half, sqrt_half}, {-sqrt_half, sqrt_half}, {-sqrt_half, -sqrt_half}, {sqrt_half, -sqrt_half}}};
    std::array<Point, columns_of_crown> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t ring = i / ground_points;
        const double radius = std::sqrt(ring_area[ring]);
        const Point at = ring % 2 == 0 ? diagonal[i % ground_points] : straight[i % ground_points];
        all[i] = {radius * at.x, radius * at.y};
    }
    return all;
}

/// The leaves above one ring: between which relative heights of the crown, and which share of its volume.
struct Stick {
    double low;
    double high;
    double share;
};

/// A paraboloid ends at 1 - (r/R)^2; an ellipsoid reaches sqrt(1 - (r/R)^2) / 2 above and below its middle.
std::array<Stick, rings> sticks_of(CrownShape shape) {
    std::array<Stick, rings> sticks{};
    double sum = 0.0;
    for (std::size_t ring = 0; ring < rings; ++ring) {
        const double inside = 1.0 - ring_area[ring];
        if (shape == CrownShape::paraboloid) {
            sticks[ring] = {0.0, inside, inside};
        } else {
            const double half = 0.5 * std::sqrt(inside);
            sticks[ring] = {0.5 - half, 0.5 + half, 2.0 * half};
        }
        sum += sticks[ring].share;
    }
    for (Stick& stick : sticks) {
        stick.share /= sum * static_cast<double>(ground_points);
    }
    return sticks;
}

/// The cells of one crown while it is being cut up: a few columns with a share in each layer.
struct CutCrown {
    std::array<std::size_t, columns_of_crown> column{};
    std::array<std::array<float, canopy_layers>, columns_of_crown> share{};
    std::size_t columns = 0;

    std::array<float, canopy_layers>& layers_of(std::size_t wanted) {
        for (std::size_t i = 0; i < columns; ++i) {
            if (column[i] == wanted) {
                return share[i];
            }
        }
        column[columns] = wanted;
        share[columns].fill(0.0F);
        return share[columns++];
    }
};

/// Spreads a share evenly between two heights over the layers; what lies outside the canopy goes to its first
/// or last layer.
void pour(std::array<float, canopy_layers>& layers, double low_m, double high_m, double share) {
    constexpr double thinnest_m = 0.01;
    const double low = low_m / layer_height_m;
    const double high = std::max(high_m, low_m + thinnest_m) / layer_height_m;
    const auto layer_of = [](double place) {
        return static_cast<std::size_t>(std::clamp(place, 0.0, canopy_layers - 0.5));
    };
    const std::size_t first = layer_of(low);
    const std::size_t last = layer_of(high);
    const double per_layer = share / (high - low);
    double from = low;
    for (std::size_t layer = first; layer <= last; ++layer) {
        const double to = layer == last ? high : static_cast<double>(layer + 1);
        layers[layer] += static_cast<float>(per_layer * (to - from));
        from = to;
    }
}

/// Columns of points; those outside go to the border, on a torus around it.
class ColumnFinder {
public:
    explicit ColumnFinder(const PaddedGround& ground)
        : ground_{ground},
          left_m_{ground.frame().x_west_m - ground.margin() * ground.column_m()},
          upper_m_{ground.frame().y_north_m() + ground.margin() * ground.column_m()},
          per_m_{1.0 / ground.column_m()} {}

    [[nodiscard]] std::size_t at(double x_m, double y_m) const {
        const config::GridFrame& frame = ground_.frame();
        const int twice = 2 * ground_.margin();
        const double columns = frame.columns + twice - 0.5;
        const double rows = frame.rows + twice - 0.5;
        const int column = static_cast<int>(std::clamp((x_m - left_m_) * per_m_, 0.0, columns));
        const int row = static_cast<int>(std::clamp((upper_m_ - y_m) * per_m_, 0.0, rows));
        const std::size_t padded =
            static_cast<std::size_t>(row) * ground_.stride() + static_cast<std::size_t>(column);
        const std::size_t source = ground_.source(padded);
        if (source != PaddedGround::none) {
            return source;
        }
        return frame.index({std::clamp(column - ground_.margin(), 0, frame.columns - 1),
                            std::clamp(row - ground_.margin(), 0, frame.rows - 1)});
    }

private:
    const PaddedGround& ground_;
    double left_m_;
    double upper_m_;
    double per_m_;
};

void cut(const LightTree& tree, const PaddedGround& ground, const ColumnFinder& columns,
         const std::array<Stick, rings>& sticks, CutCrown& crown) {
    static const std::array<Point, columns_of_crown> crown_points = points_of_crown();
    crown.columns = 0;
    const PaddedGround::Gradient rise = ground.gradient(columns.at(tree.x_m, tree.y_m));
    const double length_m = tree.height_m - tree.crown_base_m;
    for (std::size_t ring = 0; ring < rings; ++ring) {
        for (std::size_t point = 0; point < ground_points; ++point) {
            const Point at = crown_points[ring * ground_points + point];
            const double x_m = tree.crown_radius_m * at.x;
            const double y_m = tree.crown_radius_m * at.y;
            // The layers follow the ground, the crown does not: down the slope it stands higher above the
            // ground.
            const double base_m = tree.crown_base_m - (rise.x * x_m + rise.y * y_m);
            auto& layers = crown.layers_of(columns.at(tree.x_m + x_m, tree.y_m + y_m));
            pour(layers, base_m + sticks[ring].low * length_m, base_m + sticks[ring].high * length_m,
                 sticks[ring].share);
        }
    }
}

/// Fills the nodes of a column from the leaf area per ground area of its layers.
void sum_up(const std::array<float, canopy_layers>& layers, float* nodes) {
    constexpr auto down_m = static_cast<float>(layer_height_m);
    float sum = 0.0F;
    for (std::size_t node = 0; node < PrefixSums::nodes; ++node) {
        if (node < PrefixSums::nodes_below) {
            nodes[node] =
                -PrefixSums::soil_per_m * down_m * static_cast<float>(PrefixSums::nodes_below - node);
            continue;
        }
        nodes[node] = sum;
        const std::size_t layer = node - PrefixSums::nodes_below;
        sum += layer < canopy_layers ? layers[layer] : 0.0F;
    }
}

PrefixSums prefix_sums(const PaddedGround& ground, std::span<const std::int64_t> leaf_units) {
    PrefixSums sums;
    sums.below.resize(ground.padded_size() * PrefixSums::nodes);
    const double per_area = 1.0 / (units_per_m2 * ground.column_m() * ground.column_m());
    for (std::size_t padded = 0; padded < ground.padded_size(); ++padded) {
        std::array<float, canopy_layers> layers{};
        const std::size_t column = ground.source(padded);
        if (column != PaddedGround::none) {
            for (std::size_t layer = 0; layer < canopy_layers; ++layer) {
                layers[layer] = static_cast<float>(
                    static_cast<double>(leaf_units[column * canopy_layers + layer]) * per_area);
            }
        }
        sum_up(layers, sums.below.data() + padded * PrefixSums::nodes);
    }
    return sums;
}

}  // namespace

Canopy::Canopy(const PaddedGround& ground, std::span<const LightTree> trees) {
    const std::array<Stick, rings> paraboloid = sticks_of(CrownShape::paraboloid);
    const std::array<Stick, rings> ellipsoid = sticks_of(CrownShape::ellipsoid);
    std::vector<std::int64_t> on(ground.frame().size() * canopy_layers);
    std::vector<std::int64_t> off(on.size());
    std::int64_t all = 0;
    std::int64_t evergreen = 0;
    CutCrown crown;
    const ColumnFinder columns{ground};
    for (const LightTree& tree : trees) {
        assert(tree.height_m > tree.crown_base_m && tree.leaf_area_m2 >= 0.0 && tree.crown_radius_m >= 0.0);
        cut(tree, ground, columns, tree.shape == CrownShape::paraboloid ? paraboloid : ellipsoid, crown);
        for (std::size_t i = 0; i < crown.columns; ++i) {
            for (std::size_t layer = 0; layer < canopy_layers; ++layer) {
                const float share = crown.share[i][layer];
                if (share > 0.0F) {
                    const std::size_t cell = crown.column[i] * canopy_layers + layer;
                    const auto units = static_cast<std::int64_t>(
                        static_cast<double>(share) * tree.extinction * tree.leaf_area_m2 * units_per_m2);
                    shares_.push_back({static_cast<std::uint32_t>(cell), share});
                    on[cell] += units;
                    off[cell] += tree.deciduous ? 0 : units;
                    all += units;
                    evergreen += tree.deciduous ? 0 : units;
                }
            }
        }
        first_share_.push_back(shares_.size());
    }
    deciduous_share_ = all > 0 ? 1.0 - static_cast<double>(evergreen) / static_cast<double>(all) : 0.0;
    leaf_on_ = prefix_sums(ground, on);
    leaf_off_ = prefix_sums(ground, off);
    layers_used_.resize(ground.frame().size());
    for (std::size_t column = 0; column < layers_used_.size(); ++column) {
        for (std::size_t layer = 0; layer < canopy_layers; ++layer) {
            if (on[column * canopy_layers + layer] > 0) {
                layers_used_[column] = static_cast<std::uint8_t>(layer + 1);
                top_m_ = std::max(top_m_, layer_height_m * static_cast<double>(layer + 1));
            }
        }
    }
}

}  // namespace forest
