#include "coupling/inputs/systems/system_way.hpp"

#include <proj_experimental.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "coupling/inputs/formats/proj_handles.hpp"
#include "coupling/inputs/formats/system_text.hpp"

namespace coupling::systems {
namespace {

using formats::ProjContext;
using formats::ProjSystem;

constexpr std::size_t longest_text_bytes = 20'000;  // [choice] texts of systems have less than 4000

/// A system with its plan alone; nothing where PROJ does not know the text.
ProjSystem plan_of(PJ_CONTEXT* context, const std::string& text) {
    if (text.size() > longest_text_bytes) {
        return {};
    }
    ProjSystem system{
        text == wgs84_system
            ? proj_create(context, wgs84_system)
            : proj_create_from_wkt(context, formats::first_element(text).c_str(), nullptr, nullptr, nullptr)};
    if (system && proj_get_type(system.get()) == PJ_TYPE_COMPOUND_CRS) {
        system.reset(proj_crs_get_sub_crs(context, system.get(), 0));
    }
    return system;
}

/// The system of EPSG or ESRI that a text describes, where PROJ is sure of it: it knows the ways between
/// them, while a .prj file of ESRI names no codes.
ProjSystem identified(PJ_CONTEXT* context, ProjSystem system, bool& is_known) {
    constexpr int sure = 90;  // percent: all that matters is equal
    for (const char* authority : {"EPSG", "ESRI"}) {
        int* confidences = nullptr;
        PJ_OBJ_LIST* found = proj_identify(context, system.get(), authority, nullptr, &confidences);
        ProjSystem known;
        if (found != nullptr && confidences != nullptr && proj_list_get_count(found) > 0 &&
            confidences[0] >= sure) {
            known.reset(proj_list_get(context, found, 0));
        }
        proj_int_list_destroy(confidences);
        proj_list_destroy(found);
        if (known) {
            is_known = true;
            return known;
        }
    }
    return system;
}

/// The same; a projection of somebody's own (another scale or origin) is put upon the geographic system that
/// PROJ is sure of: a datum by the name of ESRI is then the one that has ways to others.
ProjSystem known_as(PJ_CONTEXT* context, ProjSystem system) {
    bool is_known = false;
    system = identified(context, std::move(system), is_known);
    if (is_known || proj_get_type(system.get()) != PJ_TYPE_PROJECTED_CRS) {
        return system;
    }
    ProjSystem below{proj_crs_get_geodetic_crs(context, system.get())};
    below = below ? identified(context, std::move(below), is_known) : std::move(below);
    ProjSystem altered;
    if (is_known) {
        altered.reset(proj_crs_alter_geodetic_crs(context, system.get(), below.get()));
    }
    return altered ? std::move(altered) : std::move(system);
}

}  // namespace

struct SystemWay::Handles {
    ProjContext context = formats::silent_context();
    ProjSystem way{};
    double target_unit = 1000.0;                  ///< about a kilometre in units of the target
    std::set<std::pair<double, double>> asked{};  ///< squares of that size
    bool is_ballpark = false;
    bool is_accuracy_known = true;
    double accuracy_m = 0.0;
    std::string name{};

    /// Asks PROJ which operation it took. That costs fifty times as much as the transformation, and PROJ
    /// takes another one only beyond the border of an area: once for each square kilometre is enough
    /// [choice].
    void note_operation(const PlaceInSystem& place) {
        if (!asked.insert({std::floor(place.x / target_unit), std::floor(place.y / target_unit)}).second) {
            return;
        }
        const ProjSystem used{proj_trans_get_last_used_operation(way.get())};
        if (!used) {
            return;
        }
        const double least_m = proj_coordoperation_get_accuracy(context.get(), used.get());
        is_accuracy_known = is_accuracy_known && least_m >= 0.0;
        accuracy_m = std::max(accuracy_m, least_m);
        is_ballpark =
            is_ballpark || proj_coordoperation_has_ballpark_transformation(context.get(), used.get()) != 0;
        const PJ_PROJ_INFO info = proj_pj_info(used.get());
        name = info.description == nullptr ? std::string{} : std::string{info.description};
    }
};

SystemWay::SystemWay(const std::string& from, const std::string& to) : handles_{std::make_unique<Handles>()} {
    PJ_CONTEXT* const context = handles_->context.get();
    ProjSystem source = plan_of(context, from);
    ProjSystem target = plan_of(context, to);
    if (!source || !target) {
        return;
    }
    source = known_as(context, std::move(source));
    target = known_as(context, std::move(target));
    if (to == wgs84_system) {
        handles_->target_unit = 0.01;  // degrees
    }
    // Without a known way between two datums PROJ would leave the shift out ("ballpark").
    const char* const options[] = {"ALLOW_BALLPARK=NO", nullptr};
    const ProjSystem way{
        proj_create_crs_to_crs_from_pj(context, source.get(), target.get(), nullptr, options)};
    if (way) {
        handles_->way.reset(proj_normalize_for_visualization(context, way.get()));
    }
}

SystemWay::~SystemWay() = default;
SystemWay::SystemWay(SystemWay&&) noexcept = default;
SystemWay& SystemWay::operator=(SystemWay&&) noexcept = default;

bool SystemWay::is_known() const {
    return handles_->way != nullptr;
}

std::optional<PlaceInSystem> SystemWay::at(double x, double y) {
    const PJ_COORD place = proj_trans(handles_->way.get(), PJ_FWD, proj_coord(x, y, 0.0, HUGE_VAL));
    if (!std::isfinite(place.xy.x) || !std::isfinite(place.xy.y)) {
        return std::nullopt;
    }
    const PlaceInSystem found{place.xy.x, place.xy.y};
    handles_->note_operation(found);
    return found;
}

bool SystemWay::is_ballpark() const {
    return handles_->is_ballpark;
}

std::optional<double> SystemWay::accuracy_m() const {
    return handles_->is_accuracy_known ? std::optional{handles_->accuracy_m} : std::nullopt;
}

const std::string& SystemWay::name() const {
    return handles_->name;
}

}  // namespace coupling::systems
