#include "validation/engine/forest_cases/plain_3pg/light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "forest/climate/calendar.hpp"
#include "forest/production/power.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

namespace {

/// Cosine and sine of any angle.
config::SinCos sin_cos_of_any(double angle_rad) {
    const double turns = std::nearbyint(angle_rad / std::numbers::pi);
    const config::SinCos reduced = config::sin_cos_of(angle_rad - turns * std::numbers::pi);
    const double sign = std::fmod(std::abs(turns), 2.0) == 1.0 ? -1.0 : 1.0;
    return {sign * reduced.sin, sign * reduced.cos};
}

/// Surface of half an ellipsoid or a whole one (Thomsen's approximation), with a horizontal and a vertical
/// half-axis.
double ellipsoid_surface(double horizontal_m, double vertical_m) {
    constexpr double p = 1.6075;
    const double h = forest::power(horizontal_m, p);
    const double v = forest::power(vertical_m, p);
    return 4.0 * std::numbers::pi * forest::power((h * h + 2.0 * h * v) / 3.0, 1.0 / p);
}

/// Sums over the species of one layer that have leaves.
struct Layer {
    double top_m = 0.0;
    double bottom_m = 0.0;
    double extinction = 0.0;  ///< sum of k L
    double lai = 0.0;
    double crown_volume_m3pha = 0.0;
    double vertical = 0.0;         ///< sum of lambda_v before it is made 1
    double leaf_to_surface = 0.0;  ///< k L / S, weighted by k L
    double filled_share = 0.0;
    bool empty = true;
};

void add_to_layer(Layer& layer, const SpeciesMonth& species, const Parameters& parameters,
                  double crown_volume_m3) {
    const Sizes& sizes = species.sizes;
    const double bottom_m = sizes.height_m - sizes.crown_length_m;
    layer.top_m = layer.empty ? sizes.height_m : std::max(layer.top_m, sizes.height_m);
    layer.bottom_m = layer.empty ? bottom_m : std::min(layer.bottom_m, bottom_m);
    layer.extinction += parameters.extinction * species.canopy.lai;
    layer.lai += species.canopy.lai;
    layer.crown_volume_m3pha += crown_volume_m3 * species.stocks.stems_pha;
    layer.empty = false;
}

/// Height of the crown's middle over that of the layer's middle [-].
double relative_middle(const Sizes& sizes, const Layer& layer) {
    return (sizes.height_m - 0.5 * sizes.crown_length_m) / (0.5 * (layer.top_m + layer.bottom_m));
}

/// Share of a layer's light that a species takes, before the shares are made to sum to 1 [Eqs. 2 and 3].
double vertical_share(double share_of_extinction, double middle) {
    return 0.012306 + 0.236609 * share_of_extinction + 0.029118 * middle +
           0.608381 * share_of_extinction * middle;
}

/// Gaps between crowns and slanting light [Eq. 5].
double horizontal_factor(double leaf_to_surface, double filled_share, double noon_deg) {
    const double open = forest::power(0.1, filled_share);
    const double factor = 0.8285 + (1.09498 - 0.781928 * leaf_to_surface) * open - 0.6714096 * open;
    constexpr double high_sun_deg = 30.0;
    return noon_deg > high_sun_deg ? factor + 0.00097 * forest::power(1.08259, noon_deg) : factor;
}

std::vector<int> layers_of(const Stand& stand) {
    std::vector<double> bases;
    std::vector<double> tops;
    for (const SpeciesMonth& species : stand.species) {
        bases.push_back(species.sizes.height_m - species.sizes.crown_length_m);
        tops.push_back(species.sizes.height_m);
    }
    return plain_3pg::layers_of(bases, tops);
}

/// The layers from above, with the vertical shares and the leaf area per crown surface of their species.
std::vector<Layer> build_layers(Stand& stand, const Inputs& inputs) {
    const std::vector<int> ids = layers_of(stand);
    std::vector<Layer> layers(static_cast<std::size_t>(*std::max_element(ids.begin(), ids.end())));
    const auto layer_of = [&](const SpeciesMonth& species) -> Layer& {
        return layers[static_cast<std::size_t>(species.canopy.layer - 1)];
    };
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        SpeciesMonth& species = stand.species[i];
        species.canopy.layer = ids[i];
        species.canopy.leaf_to_surface = 0.0;
        if (species.canopy.lai > 0.0) {
            const CrownBody crown = crown_body(inputs.parameters[i].crown_form, species.sizes.crown_width_m,
                                               species.sizes.crown_length_m);
            constexpr double m2_per_ha = 1e4;
            species.canopy.leaf_to_surface =
                species.canopy.lai * m2_per_ha / species.stocks.stems_pha / crown.surface_m2;
            add_to_layer(layer_of(species), species, inputs.parameters[i], crown.volume_m3);
        }
    }
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        Canopy& canopy = stand.species[i].canopy;
        Layer& layer = layer_of(stand.species[i]);
        if (canopy.lai > 0.0) {
            const double k = inputs.parameters[i].extinction;
            const double share = k * canopy.lai / layer.extinction;
            canopy.vertical = vertical_share(share, relative_middle(stand.species[i].sizes, layer));
            layer.vertical += canopy.vertical;
            layer.leaf_to_surface += k * canopy.leaf_to_surface * share;
        }
    }
    for (Layer& layer : layers) {
        constexpr double m2_per_ha = 1e4;
        layer.leaf_to_surface = std::min(layer.leaf_to_surface, 1.0);
        layer.filled_share =
            layer.empty ? 0.0 : layer.crown_volume_m3pha / ((layer.top_m - layer.bottom_m) * m2_per_ha);
    }
    return layers;
}

}  // namespace

void absorb_as_one_canopy(Stand& stand, const Inputs& inputs, const ClimateMonth& month) {
    const double light_mjpm2 = month.radiation_mjpm2 * forest::days_in_month(month.when.month);
    for (std::size_t i = 0; i < stand.species.size(); ++i) {
        const Parameters& parameters = inputs.parameters[i];
        SpeciesMonth& species = stand.species[i];
        const double age_years = species.age.previous_years;
        const bool young = parameters.full_canopy_years > 0.0 && age_years < parameters.full_canopy_years;
        // The hundredth of a year keeps the cover of a stand planted this month above 0.
        const double cover = young ? (age_years + 0.01) / parameters.full_canopy_years : 1.0;
        species.canopy.cover = cover;
        species.canopy.absorbed_mjpm2 =
            light_mjpm2 * (1.0 - config::exp_of(-parameters.extinction * species.canopy.lai / cover)) * cover;
    }
}

void absorb_by_layers(Stand& stand, const Inputs& inputs, const ClimateMonth& month) {
    const std::vector<Layer> layers = build_layers(stand, inputs);
    const double noon_deg = noon_angle_deg(inputs.site.latitude, month.when.month);
    const double above_mjpm2 = month.radiation_mjpm2 * forest::days_in_month(month.when.month);

    std::vector<double> absorbed_mjpm2;
    double light_mjpm2 = above_mjpm2;
    for (const Layer& layer : layers) {
        absorbed_mjpm2.push_back(light_mjpm2 * (1.0 - config::exp_of(-layer.extinction)));
        light_mjpm2 -= absorbed_mjpm2.back();
    }
    for (SpeciesMonth& species : stand.species) {
        Canopy& canopy = species.canopy;
        const auto id = static_cast<std::size_t>(canopy.layer - 1);
        const Layer& layer = layers[id];
        const bool leaves = canopy.lai > 0.0;
        canopy.vertical = leaves ? canopy.vertical / layer.vertical : 0.0;
        canopy.horizontal =
            leaves ? horizontal_factor(layer.leaf_to_surface, layer.filled_share, noon_deg) : 0.0;
        canopy.filled_share = layer.filled_share;
        canopy.absorbed_mjpm2 = absorbed_mjpm2[id] * canopy.vertical * canopy.horizontal;
        canopy.absorbed_share = above_mjpm2 > 0.0 ? canopy.absorbed_mjpm2 / above_mjpm2 : 0.0;

        canopy.lai_above = 0.0;
        for (std::size_t higher = 0; higher < id; ++higher) {
            canopy.lai_above += layers[higher].lai;
        }
        if (leaves) {  // in the lower half of its layer it stands under part of that, too
            const double middle = relative_middle(species.sizes, layer);
            canopy.lai_above += middle < 0.9999999999999 ? layer.lai * (1.0 - middle) : 0.0;
        }
    }
}

CrownBody crown_body(CrownForm form, double width_m, double length_m) {
    const double radius_m = 0.5 * width_m;
    const double disc_m2 = std::numbers::pi * radius_m * radius_m;
    switch (form) {
        case CrownForm::cone:
            return {
                disc_m2 + std::numbers::pi * radius_m * std::sqrt(radius_m * radius_m + length_m * length_m),
                disc_m2 * length_m / 3.0};
        case CrownForm::ellipsoid:
            return {ellipsoid_surface(radius_m, 0.5 * length_m), disc_m2 * length_m * 2.0 / 3.0};
        case CrownForm::half_ellipsoid:
            return {disc_m2 + 0.5 * ellipsoid_surface(radius_m, length_m), disc_m2 * length_m * 2.0 / 3.0};
        case CrownForm::box:
            break;
    }
    return {2.0 * width_m * width_m + 4.0 * width_m * length_m, width_m * width_m * length_m};
}

std::vector<int> layers_of(std::span<const double> crown_bases_m, std::span<const double> heights_m) {
    struct Edge {
        double height_m;
        int step;  ///< 1 where a crown begins, -1 where it ends
    };
    std::vector<Edge> edges;
    for (const double base_m : crown_bases_m) {
        edges.push_back({base_m, 1});
    }
    for (const double height_m : heights_m) {
        edges.push_back({height_m, -1});
    }
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return a.height_m < b.height_m; });
    std::vector<double> tops_m;
    int open = 0;
    for (const Edge& edge : edges) {
        open += edge.step;
        if (open == 0) {
            tops_m.push_back(edge.height_m);
        }
    }
    std::vector<int> layers;
    for (const double height_m : heights_m) {
        const auto below = std::lower_bound(tops_m.begin(), tops_m.end(), height_m) - tops_m.begin();
        layers.push_back(static_cast<int>(below) + 1);
    }
    const int highest = layers.empty() ? 0 : *std::max_element(layers.begin(), layers.end());
    for (int& layer : layers) {
        layer = highest - layer + 1;
    }
    return layers;
}

double noon_angle_deg(config::Angle latitude, int month) {
    const double day_angle_rad = 2.0 * std::numbers::pi / 365.0 * (forest::middle_day(month) - 1.0);
    const config::SinCos one = sin_cos_of_any(day_angle_rad);
    const config::SinCos two = sin_cos_of_any(2.0 * day_angle_rad);
    const config::SinCos three = sin_cos_of_any(3.0 * day_angle_rad);
    // Declination (Spencer 1971).
    const double declination_rad = 0.006918 - 0.399912 * one.cos + 0.070257 * one.sin - 0.006758 * two.cos +
                                   0.000907 * two.sin - 0.002697 * three.cos + 0.00148 * three.sin;
    const double latitude_deg = latitude.in_degrees();
    const double angle_deg = std::abs(latitude.in_radians() + declination_rad) * 180.0 / std::numbers::pi;
    // Between the tropics the sun passes the zenith twice a year, with the sign of the side it stands on.
    constexpr double tropic_deg = 23.4;
    const double cubed = latitude_deg * latitude_deg * latitude_deg;
    const double squared = latitude_deg * latitude_deg;
    const double first_day = -0.0018 * cubed + 0.0021 * squared - 2.3459 * latitude_deg + 80.097;
    const double second_day = 0.0018 * cubed - 0.0031 * squared + 2.3826 * latitude_deg + 266.62;
    const int day = forest::middle_day(month);
    const bool north = latitude_deg >= 0.0 && latitude_deg <= tropic_deg;
    const bool south = latitude_deg >= -tropic_deg && latitude_deg < 0.0;
    const bool beyond =
        (north && (day > second_day || day < first_day)) || (south && day > first_day && day < second_day);
    return beyond ? -angle_deg : angle_deg;
}

}  // namespace coupling::validation::forest_cases::plain_3pg
