#include "forest/production/transpiration.hpp"

#include <algorithm>

namespace forest {

namespace {

constexpr double saturation_slope = 2.2;  // of saturation pressure / psychrometric constant, at 20 degC
constexpr double air_density_kgpm3 = 1.2;
constexpr double latent_heat_jpkg = 2.46e6;   // of evaporation
constexpr double humidity_per_kpa = 0.00622;  // saturation deficit [kg/kg] per kPa: 18 / 29 / 100

}  // namespace

double evaporation_mm(const EvaporationDay& day, double conductance_mps, double boundary_layer_mps) {
    const double deficit_wpm2 =
        air_density_kgpm3 * latent_heat_jpkg * humidity_per_kpa * day.vpd_kpa * boundary_layer_mps;
    const double resistance = conductance_mps * (1.0 + saturation_slope) + boundary_layer_mps;
    const double flux_wpm2 =
        conductance_mps * (saturation_slope * day.net_radiation_wpm2 + deficit_wpm2) / resistance;
    return flux_wpm2 / latent_heat_jpkg * day.day_length_s * day.days;
}

double canopy_conductance_mps(double lai, double min_mps, double max_mps, double full_lai) {
    return lai > full_lai ? max_mps : min_mps + (max_mps - min_mps) * lai / full_lai;
}

double interception_share(double lai, double max_share, double full_lai) {
    return full_lai > 0.0 ? max_share * std::min(1.0, lai / full_lai) : max_share;
}

}  // namespace forest
