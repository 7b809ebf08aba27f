#include "forest/light/light.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/math/elementary.hpp"
#include "forest/light/optical_depth.hpp"

namespace forest {
namespace {

/// Less deciduous extinction than this does not justify a second canopy.
constexpr double few_deciduous = 0.05;

/// Beyond this much leaf area nothing arrives that matters.
constexpr float dark = 7.0F;

/// Ground on which a tree's own leaves count as its shade, whatever the columns: the patch of the
/// calibration.
constexpr double own_shade_area_m2 = 100.0;

/// Direct sun shines on the ground while it is dimmed by less than a half.
constexpr float half_shade = 0.69314718F;

constexpr float hours_of_step = 0.5F;

constexpr std::size_t months_a_year = 12;

/// Weather of the year as factors of a view, for one state of the leaves.
struct Weights {
    std::array<float, months_a_year> diffuse_mjpm2{};  ///< 0 in months of the other state
    std::array<float, months_a_year> direct_mjpm2{};
    std::array<float, months_a_year> season_direct_mjpm2{};
    float season_diffuse_mjpm2 = 0.0F;
};

Weights weights_of(const LightYear& year, bool with_leaves, bool two_states) {
    Weights weights;
    for (std::size_t month = 0; month < months_a_year; ++month) {
        const auto diffuse = static_cast<float>(year.radiation.diffuse_mjpm2[month]);
        const auto direct = static_cast<float>(year.radiation.direct_mjpm2[month]);
        if (!two_states || year.leaves_on[month] == with_leaves) {
            weights.diffuse_mjpm2[month] = diffuse;
            weights.direct_mjpm2[month] = direct;
        }
        if (with_leaves && year.season[month]) {
            weights.season_diffuse_mjpm2 += diffuse;
            weights.season_direct_mjpm2[month] = direct;
        }
    }
    return weights;
}

/// Sums of one column over the zones.
struct ColumnSums {
    Layers diffuse{};
    Layers season{};
    std::array<Layers, months_a_year> beam{};
    float ground_diffuse = 0.0F;
    float ground_season = 0.0F;
    std::array<float, months_a_year> ground_beam{};
    float open_season = 0.0F;         ///< at right angles
    float open_ground_season = 0.0F;  ///< on the ground
    float open_ground_diffuse = 0.0F;
    std::array<float, months_a_year> open_ground_beam{};
};

/// Mean of e^-t over a cell in which t rises by tau, divided by its value in the middle: sinh(x) / x, x = tau
/// / 2, as its series; x stays below 3.
inline float thick_cell(float tau) {
    const float x = 0.5F * (tau < 6.0F ? tau : 6.0F);
    const float q = x * x;
    return 1.0F +
           q * (1.0F / 6) * (1.0F + q * (1.0F / 20) * (1.0F + q * (1.0F / 42) * (1.0F + q * (1.0F / 72))));
}

/// Light of one zone in a column.
struct ZoneLight {
    Layers centre;  ///< transmittance at the centres of the cells
    Layers thick;   ///< the same with the correction for thickness
    float ground = 0.0F;
};

/// Length of the path of a ray through its own cell per height of a layer.
float own_path(const RayWalk& walk, const PaddedGround& ground, PaddedGround::Gradient rise) {
    const double climb = walk.tangent - (rise.x * walk.across_x + rise.y * walk.across_y);
    const double across_m = std::min(layer_height_m / std::max(std::abs(climb), 1e-3), ground.column_m());
    return static_cast<float>(across_m / (walk.cosine * layer_height_m));
}

template <std::size_t lanes>
ZoneLight light_of_zone(const LightSite& site, const PrefixSums& leaves, double top_m, std::size_t zone,
                        std::size_t column, PaddedGround::Gradient rise) {
    const PaddedGround& ground = site.ground();
    const RayWalk& walk = site.walk(zone);
    const std::size_t padded = ground.padded(column);
    const OpticalDepth depth = column_depth<lanes>(ground, leaves, top_m, walk, padded);
    ZoneLight light;
    const float path_per_layer = own_path(walk, ground, rise);
    const float* nodes = leaves.of(padded) + PrefixSums::nodes_below;
    // Depths of the layers with one more below, as if the canopy went on; above the last nothing is known.
    std::array<float, lanes + 2> around{};
    around[0] = 2.0F * depth.ground - depth.layers[0];
    std::copy_n(depth.layers.begin(), lanes, around.begin() + 1);
    around[lanes + 1] = around[lanes];
    for (std::size_t l = 0; l < lanes; ++l) {
        light.centre[l] = exp_minus(depth.layers[l]);
        // A cell is thick across, as far as its own leaves reach, or from above to below, where its
        // neighbours shade it too.
        const float own = (nodes[l + 1] - nodes[l]) * path_per_layer;
        const float to_below = around[l] - around[l + 1];
        const float to_above = around[l + 1] - around[l + 2];
        const float downwards = to_below > to_above ? to_below : to_above;
        light.thick[l] = light.centre[l] * thick_cell(own > downwards ? own : downwards);
    }
    const std::span<const RayWalk> points = site.ground_walks(zone);
    if (points.empty()) {
        light.ground = exp_minus(depth.ground);
    }
    for (const RayWalk& point : points) {
        light.ground += exp_minus(ground_depth(ground, leaves, top_m, point, padded, dark)) /
                        static_cast<float>(points.size());
    }
    return light;
}

template <std::size_t lanes>
inline void add(Layers& sum, float weight, const Layers& light) {
    for (std::size_t l = 0; l < lanes; ++l) {
        sum[l] += weight * light[l];
    }
}

template <std::size_t lanes>
void add_zone(const LightSite& site, const SkyView& view, const Weights& weights, std::size_t zone,
              const ZoneLight& light, ColumnSums& sums) {
    const float on_ground = view.on_ground[zone];
    float season = view.diffuse[zone] * weights.season_diffuse_mjpm2;
    add<lanes>(sums.diffuse, view.diffuse[zone], light.thick);
    sums.ground_diffuse += view.diffuse[zone] * on_ground * light.ground;
    sums.open_ground_diffuse += view.diffuse[zone] * on_ground;
    for (std::size_t beam = site.first_beam(zone); beam < site.first_beam(zone + 1); ++beam) {
        const std::uint32_t month = site.sky().beams()[beam].month;
        const float energy = view.beam[beam];
        season += energy * weights.season_direct_mjpm2[month];
        add<lanes>(sums.beam[month], energy, light.thick);
        sums.ground_beam[month] += energy * on_ground * light.ground;
        sums.open_ground_beam[month] += energy * on_ground;
    }
    add<lanes>(sums.season, season, light.centre);
    sums.ground_season += season * on_ground * light.ground;
    sums.open_season += season;
    sums.open_ground_season += season * on_ground;
}

template <std::size_t lanes>
ColumnSums sum_zones(const LightSite& site, const PrefixSums& leaves, double top_m, const Weights& weights,
                     std::size_t column) {
    const SkyView& view = site.view(column);
    const PaddedGround::Gradient rise = site.ground().gradient(column);
    ColumnSums sums;
    for (std::size_t zone = 0; zone < site.sky().zones().size(); ++zone) {
        if (site.is_visible(view, zone)) {
            add_zone<lanes>(site, view, weights, zone,
                            light_of_zone<lanes>(site, leaves, top_m, zone, column, rise), sums);
        }
    }
    return sums;
}

/// Sums over the cells that have leaves, in the width of a vector; those above stay dark.
ColumnSums sum_used(const LightSite& site, const Canopy& canopy, const PrefixSums& leaves,
                    const Weights& weights, std::size_t column) {
    const std::size_t used = canopy.layers_used(column);
    return used <= 4   ? sum_zones<4>(site, leaves, canopy.top_m(), weights, column)
           : used <= 8 ? sum_zones<8>(site, leaves, canopy.top_m(), weights, column)
                       : sum_zones<12>(site, leaves, canopy.top_m(), weights, column);
}

/// Adds the months of one state of the leaves to a column.
void write_months(const ColumnSums& sums, const Weights& weights, std::size_t column, LightField& field) {
    for (std::size_t month = 0; month < months_a_year; ++month) {
        const float diffuse = weights.diffuse_mjpm2[month];
        const float direct = weights.direct_mjpm2[month];
        field.ground_mjpm2[column * months_a_year + month] +=
            diffuse * sums.ground_diffuse + direct * sums.ground_beam[month];
        field.incoming_mjpm2[column * months_a_year + month] +=
            diffuse * sums.open_ground_diffuse + direct * sums.open_ground_beam[month];
        float* cells = field.cells.data() + column * canopy_layers * LightField::values_of_cell + month;
        for (std::size_t l = 0; l < canopy_layers; ++l) {
            cells[l * LightField::values_of_cell] += diffuse * sums.diffuse[l] + direct * sums.beam[month][l];
        }
    }
}

void write_season(const ColumnSums& sums, std::size_t column, LightField& field) {
    field.open_season[column] = sums.open_season;
    field.ground_light[column] =
        sums.open_ground_season > 0.0F ? std::min(1.0F, sums.ground_season / sums.open_ground_season) : 1.0F;
    float* cells =
        field.cells.data() + column * canopy_layers * LightField::values_of_cell + LightField::season_value;
    for (std::size_t l = 0; l < canopy_layers; ++l) {
        cells[l * LightField::values_of_cell] = sums.season[l];
    }
}

float june_sun(const LightSite& site, const Canopy& canopy, std::size_t column) {
    const std::uint64_t shining = site.view(column).june_suns;
    float hours = 0.0F;
    for (std::size_t sun = 0; sun < site.sky().june_suns().size(); ++sun) {
        if (((shining >> sun) & 1U) != 0) {
            const float tau = ground_depth(site.ground(), canopy.leaf_on(), canopy.top_m(),
                                           site.june_walk(sun), site.ground().padded(column), half_shade);
            hours += tau < half_shade ? hours_of_step : 0.0F;
        }
    }
    return hours;
}

/// Mean light in the shade of leaves of optical depth t.
double own_shade(double t) {
    return t < 1e-4 ? 1.0 - 0.5 * t : (1.0 - config::exp_of(-std::min(t, 80.0))) / t;
}

}  // namespace

LightField make_light_field(const LightSite& site, std::size_t trees) {
    const std::size_t columns = site.ground().frame().size();
    LightField field;
    field.cells.resize(columns * canopy_layers * LightField::values_of_cell);
    field.ground_light.resize(columns);
    field.june_sun_hours.resize(columns);
    field.open_season.resize(columns);
    field.ground_mjpm2.resize(columns * months_a_year);
    field.incoming_mjpm2.resize(columns * months_a_year);
    field.light_ratio.resize(trees);
    field.absorbed_mj.resize(trees * months_a_year);
    return field;
}

void compute_columns(const LightSite& site, const Canopy& canopy, const LightYear& year, std::size_t first,
                     std::size_t last, LightField& field) {
    const bool two_states = canopy.deciduous_share() >= few_deciduous;
    const Weights on = weights_of(year, true, two_states);
    const Weights off = weights_of(year, false, two_states);
    constexpr std::size_t column_values = canopy_layers * LightField::values_of_cell;
    for (std::size_t column = first; column < last; ++column) {
        std::fill_n(field.cells.begin() + static_cast<std::ptrdiff_t>(column * column_values), column_values,
                    0.0F);
        std::fill_n(field.ground_mjpm2.begin() + static_cast<std::ptrdiff_t>(column * months_a_year),
                    months_a_year, 0.0F);
        std::fill_n(field.incoming_mjpm2.begin() + static_cast<std::ptrdiff_t>(column * months_a_year),
                    months_a_year, 0.0F);
        const ColumnSums sums = sum_used(site, canopy, canopy.leaf_on(), on, column);
        write_season(sums, column, field);
        write_months(sums, on, column, field);
        if (two_states) {
            write_months(sum_used(site, canopy, canopy.leaf_off(), off, column), off, column, field);
        }
        field.june_sun_hours[column] = june_sun(site, canopy, column);
    }
}

void compute_trees(const Canopy& canopy, const LightYear& year, std::span<const LightTree> trees,
                   std::size_t first, std::size_t last, LightField& field) {
    for (std::size_t i = first; i < last; ++i) {
        const LightTree& tree = trees[i];
        std::array<float, LightField::values_of_cell> mean{};
        float open = 0.0F;
        for (const LeafShare& leaves : canopy.cells_of(i)) {
            const float* cell = field.cells.data() + leaves.cell * LightField::values_of_cell;
            for (std::size_t value = 0; value < LightField::values_of_cell; ++value) {
                mean[value] += leaves.share * cell[value];
            }
            open += leaves.share * field.open_season[leaves.cell / canopy_layers];
        }
        const double shade = own_shade(tree.extinction * tree.leaf_area_m2 / own_shade_area_m2);
        const double ratio =
            open > 0.0F ? static_cast<double>(mean[LightField::season_value] / open) / shade : 1.0;
        field.light_ratio[i] = static_cast<float>(std::clamp(ratio, 0.0, 1.0));
        const auto extinction_m2 = static_cast<float>(tree.extinction * tree.leaf_area_m2);
        for (std::size_t month = 0; month < months_a_year; ++month) {
            const bool bare = tree.deciduous && !year.leaves_on[month];
            field.absorbed_mj[i * months_a_year + month] = bare ? 0.0F : extinction_m2 * mean[month];
        }
    }
}

void close_budget(const LightSite& site, LightField& field) {
    const double column_m2 = site.ground().column_m() * site.ground().column_m();
    const std::size_t columns = field.ground_light.size();
    const std::size_t trees = field.light_ratio.size();
    for (std::size_t month = 0; month < months_a_year; ++month) {
        double intercepted_mj = 0.0;
        for (std::size_t column = 0; column < columns; ++column) {
            const std::size_t at = column * months_a_year + month;
            intercepted_mj += column_m2 * (static_cast<double>(field.incoming_mjpm2[at]) -
                                           static_cast<double>(field.ground_mjpm2[at]));
        }
        // Trees come in any order: whole joules sum up the same.
        std::int64_t absorbed_j = 0;
        for (std::size_t tree = 0; tree < trees; ++tree) {
            absorbed_j += static_cast<std::int64_t>(
                1e6 * static_cast<double>(field.absorbed_mj[tree * months_a_year + month]));
        }
        const double absorbed_mj = 1e-6 * static_cast<double>(absorbed_j);
        field.closure[month] = absorbed_mj > 0.0 ? intercepted_mj / absorbed_mj : 1.0;
        if (site.edges() != Edges::open) {
            for (std::size_t tree = 0; tree < trees; ++tree) {
                field.absorbed_mj[tree * months_a_year + month] *= static_cast<float>(field.closure[month]);
            }
        }
    }
}

std::vector<float> mean_over_patches(const config::GridFrame& columns, std::span<const float> values,
                                     int side) {
    assert(side >= 1 && columns.columns % side == 0 && columns.rows % side == 0 &&
           values.size() == columns.size());
    const int across = columns.columns / side;
    std::vector<float> means(static_cast<std::size_t>(across * (columns.rows / side)));
    for (std::size_t column = 0; column < values.size(); ++column) {
        const config::Cell at = columns.cell_of(column);
        means[static_cast<std::size_t>(at.row / side * across + at.column / side)] +=
            values[column] / static_cast<float>(side * side);
    }
    return means;
}

LightField compute_light(const LightSite& site, const Canopy& canopy, const LightYear& year,
                         std::span<const LightTree> trees) {
    LightField field = make_light_field(site, trees.size());
    compute_columns(site, canopy, year, 0, site.ground().frame().size(), field);
    compute_trees(canopy, year, trees, 0, trees.size(), field);
    close_budget(site, field);
    return field;
}

}  // namespace forest
