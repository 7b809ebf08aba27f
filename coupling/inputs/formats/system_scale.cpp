#include "coupling/inputs/formats/system_scale.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "coupling/inputs/formats/proj_handles.hpp"
#include "coupling/inputs/formats/system_text.hpp"

namespace coupling::formats {
namespace {

constexpr std::size_t longest_text_bytes = 20'000;  // [choice] texts of systems have less than 4000

/// The unit of the angles of a geographic system: degrees, or grads of the old French ones; 0 without any.
double radians_per_unit(PJ_CONTEXT* context, const PJ* geographic) {
    const ProjSystem axes{proj_crs_get_coordinate_system(context, geographic)};
    double radians = 0.0;
    const bool is_known = axes && proj_cs_get_axis_info(context, axes.get(), 0, nullptr, nullptr, nullptr,
                                                        &radians, nullptr, nullptr, nullptr) != 0;
    return is_known ? radians : 0.0;
}

/// From coordinates of a projected system to its own longitude and latitude [radians].
class WayToTheGlobe {
public:
    WayToTheGlobe(PJ_CONTEXT* context, const PJ* system) {
        const ProjSystem geographic{proj_crs_get_geodetic_crs(context, system)};
        if (!geographic) {
            return;
        }
        radians_ = radians_per_unit(context, geographic.get());
        const ProjSystem ellipsoid{proj_get_ellipsoid(context, geographic.get())};
        double minor_m = 0.0;
        if (ellipsoid && proj_ellipsoid_get_parameters(context, ellipsoid.get(), &major_m_, &minor_m, nullptr,
                                                       nullptr) != 0) {
            eccentricity_squared_ = 1.0 - std::pow(minor_m / major_m_, 2);
        }
        const ProjSystem way{
            proj_create_crs_to_crs_from_pj(context, system, geographic.get(), nullptr, nullptr)};
        east_first_.reset(way ? proj_normalize_for_visualization(context, way.get()) : nullptr);
    }

    [[nodiscard]] bool is_known() const { return east_first_ && radians_ > 0.0 && major_m_ > 0.0; }

    /// Longitude and latitude [radians]; not finite where there are none.
    [[nodiscard]] PJ_COORD at(double x_m, double y_m) const {
        PJ_COORD place = proj_trans(east_first_.get(), PJ_FWD, proj_coord(x_m, y_m, 0.0, 0.0));
        place.lp.lam *= radians_;
        place.lp.phi *= radians_;
        return place;
    }
    /// The way on the ground from one place to another close to it [m], east and north.
    [[nodiscard]] std::pair<double, double> ground_m(const PJ_COORD& from, const PJ_COORD& to) const {
        const double phi = 0.5 * (from.lp.phi + to.lp.phi);
        const double root = std::sqrt(1.0 - eccentricity_squared_ * std::pow(std::sin(phi), 2));
        const double across_m = major_m_ / root;  // radius of curvature from east to west
        const double along_m = major_m_ * (1.0 - eccentricity_squared_) / std::pow(root, 3);
        return {across_m * std::cos(phi) * std::remainder(to.lp.lam - from.lp.lam, 2.0 * std::numbers::pi),
                along_m * (to.lp.phi - from.lp.phi)};
    }

private:
    ProjSystem east_first_;
    double radians_ = 0.0;
    double major_m_ = 0.0;
    double eccentricity_squared_ = 0.0;
};

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
    const WayToTheGlobe way{context.get(), system.get()};
    if (!way.is_known()) {
        return std::nullopt;
    }
    // Far above the rounding of longitudes (1e-9 m) and far below the bend of any projection.
    constexpr double half_m = 100.0;
    const auto [east_by_x, north_by_x] = way.ground_m(way.at(x_m - half_m, y_m), way.at(x_m + half_m, y_m));
    const auto [east_by_y, north_by_y] = way.ground_m(way.at(x_m, y_m - half_m), way.at(x_m, y_m + half_m));
    // Singular values of the matrix that takes metres of the map to metres of the ground.
    const double straight = std::hypot(east_by_x + north_by_y, north_by_x - east_by_y);
    const double crossed = std::hypot(east_by_x - north_by_y, north_by_x + east_by_y);
    const double longest_ground = 0.5 * (straight + crossed) / (2.0 * half_m);
    const double shortest_ground = 0.5 * std::abs(straight - crossed) / (2.0 * half_m);
    if (!std::isfinite(longest_ground) || !(shortest_ground > 0.0)) {
        return std::nullopt;
    }
    return SystemScale{1.0 / shortest_ground, 1.0 / longest_ground};
}

}  // namespace coupling::formats
