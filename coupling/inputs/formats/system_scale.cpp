#include "coupling/inputs/formats/system_scale.hpp"

#include <cmath>
#include <numbers>

#include "coupling/inputs/formats/proj_handles.hpp"

namespace coupling::formats {
namespace {

constexpr std::size_t longest_text_bytes = 20'000;  // [choice] texts of systems have less than 4000

/// The text to the bracket that closes its first one: ESRI writes the system of heights behind it.
std::string first_element(const std::string& text) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < text.size(); ++at) {
        quoted = quoted != (text[at] == '"');
        depth += !quoted && text[at] == '[' ? 1 : 0;
        if (!quoted && text[at] == ']' && --depth == 0) {
            return text.substr(0, at + 1);
        }
    }
    return text;
}

/// Longitude and latitude in degrees of coordinates of a projected system, on its own datum.
std::optional<PJ_COORD> degrees_of(PJ_CONTEXT* context, const PJ* system, double x_m, double y_m) {
    const ProjSystem degrees{proj_crs_get_geodetic_crs(context, system)};
    if (!degrees) {
        return std::nullopt;
    }
    const ProjSystem way{proj_create_crs_to_crs_from_pj(context, system, degrees.get(), nullptr, nullptr)};
    const ProjSystem east_first{way ? proj_normalize_for_visualization(context, way.get()) : nullptr};
    if (!east_first) {
        return std::nullopt;
    }
    const PJ_COORD place = proj_trans(east_first.get(), PJ_FWD, proj_coord(x_m, y_m, 0.0, 0.0));
    const bool is_known = std::isfinite(place.lp.lam) && std::isfinite(place.lp.phi) &&
                          std::abs(place.lp.lam) <= 360.0 && std::abs(place.lp.phi) <= 90.0;
    return is_known ? std::optional{place} : std::nullopt;
}

}  // namespace

std::optional<SystemScale> system_scale(const std::string& text, double x_m, double y_m) {
    if (text.size() > longest_text_bytes) {
        return std::nullopt;
    }
    const ProjContext context = silent_context();
    ProjSystem system{
        proj_create_from_wkt(context.get(), first_element(text).c_str(), nullptr, nullptr, nullptr)};
    if (system && proj_get_type(system.get()) == PJ_TYPE_COMPOUND_CRS) {
        system.reset(proj_crs_get_sub_crs(context.get(), system.get(), 0));
    }
    if (!system || proj_get_type(system.get()) != PJ_TYPE_PROJECTED_CRS) {
        return std::nullopt;
    }
    const auto place = degrees_of(context.get(), system.get(), x_m, y_m);
    if (!place) {
        return std::nullopt;
    }
    constexpr double radians = std::numbers::pi / 180.0;
    const PJ_FACTORS factors =
        proj_factors(system.get(), proj_coord(radians * place->lp.lam, radians * place->lp.phi, 0.0, 0.0));
    if (proj_errno(system.get()) != 0 || !std::isfinite(factors.tissot_semimajor) ||
        !(factors.tissot_semiminor > 0.0)) {
        return std::nullopt;
    }
    return SystemScale{factors.tissot_semimajor, factors.tissot_semiminor};
}

}  // namespace coupling::formats
