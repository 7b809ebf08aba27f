#include "coupling/inputs/systems/transform_layer.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/formats/proj_handles.hpp"
#include "coupling/inputs/formats/system_text.hpp"
#include "coupling/inputs/systems/same_system.hpp"

namespace coupling::systems {
namespace {

using config::joined;
using formats::ProjContext;
using formats::ProjSystem;

constexpr std::size_t longest_text_bytes = 20'000;  // [choice] texts of systems have less than 4000
constexpr double accurate_m = 5.0;                  // [choice] the size of a cell

/// Two coordinates in a text of a shape, and where they stand.
struct PlaceInText {
    std::size_t begin = 0;
    std::size_t end = 0;  ///< behind the second one
    double x = 0.0;
    double y = 0.0;
};

bool begins_number(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '+' || c == '.';
}

/// The first two numbers of each point of well-known text. What is no shape is found by its reader later.
std::vector<PlaceInText> places_in(std::string_view text) {
    std::vector<PlaceInText> places;
    bool is_new = false;  // behind a bracket or a comma a point begins
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '(' || c == ',') {
            is_new = true;
            ++at;
            continue;
        }
        if (!is_new || !begins_number(c)) {
            is_new = is_new && std::isspace(static_cast<unsigned char>(c)) != 0;
            ++at;
            continue;
        }
        constexpr std::string_view ends = " \t\r\n,()";
        const std::size_t first_end = std::min(text.find_first_of(ends, at), text.size());
        const std::size_t second = std::min(text.find_first_not_of(" \t\r\n", first_end), text.size());
        const std::size_t second_end = std::min(text.find_first_of(ends, second), text.size());
        const auto x = config::parse_number(text.substr(at, first_end - at));
        const auto y = config::parse_number(text.substr(second, second_end - second));
        if (x && y) {
            places.push_back({at, second_end, *x, *y});
        }
        is_new = false;
        at = std::max(second_end, at + 1);
    }
    return places;
}

/// A system with its plan alone; nothing where PROJ does not know the text.
ProjSystem plan_of(PJ_CONTEXT* context, const std::string& text) {
    if (text.size() > longest_text_bytes) {
        return {};
    }
    ProjSystem system{
        proj_create_from_wkt(context, formats::first_element(text).c_str(), nullptr, nullptr, nullptr)};
    if (system && proj_get_type(system.get()) == PJ_TYPE_COMPOUND_CRS) {
        system.reset(proj_crs_get_sub_crs(context, system.get(), 0));
    }
    return system;
}

/// The system of EPSG or ESRI that a text describes, where PROJ is sure of it: it knows the ways between
/// them, while a .prj file of ESRI names no codes.
ProjSystem known_as(PJ_CONTEXT* context, ProjSystem system) {
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
            return known;
        }
    }
    return system;
}

/// How PROJ goes from one system to another.
class Way {
public:
    Way(const std::string& from, const std::string& to) : context_{formats::silent_context()} {
        ProjSystem source = plan_of(context_.get(), from);
        ProjSystem target = plan_of(context_.get(), to);
        if (!source || !target) {
            return;
        }
        source = known_as(context_.get(), std::move(source));
        target = known_as(context_.get(), std::move(target));
        // Without a known way between two datums PROJ would leave the shift out ("ballpark").
        const char* const options[] = {"ALLOW_BALLPARK=NO", nullptr};
        const ProjSystem way{
            proj_create_crs_to_crs_from_pj(context_.get(), source.get(), target.get(), nullptr, options)};
        if (way) {
            way_.reset(proj_normalize_for_visualization(context_.get(), way.get()));
        }
    }

    [[nodiscard]] bool is_known() const { return way_ != nullptr; }
    /// Coordinates in the target system; nothing where there are none.
    [[nodiscard]] std::optional<PJ_XY> at(double x, double y) {
        const PJ_COORD place = proj_trans(way_.get(), PJ_FWD, proj_coord(x, y, 0.0, HUGE_VAL));
        if (!std::isfinite(place.xy.x) || !std::isfinite(place.xy.y)) {
            return std::nullopt;
        }
        note_operation(place.xy);
        return place.xy;
    }
    [[nodiscard]] bool is_ballpark() const { return is_ballpark_; }
    /// The least accurate that was used [m]; nothing where PROJ does not know.
    [[nodiscard]] std::optional<double> accuracy_m() const {
        return is_accuracy_known_ ? std::optional{accuracy_m_} : std::nullopt;
    }
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    /// Asks PROJ which operation it took. That costs fifty times as much as the transformation, and PROJ
    /// takes another one only beyond the border of an area: once for each square kilometre is enough
    /// [choice].
    void note_operation(const PJ_XY& place) {
        constexpr double km = 1000.0;
        if (!asked_.insert({std::floor(place.x / km), std::floor(place.y / km)}).second) {
            return;
        }
        const ProjSystem used{proj_trans_get_last_used_operation(way_.get())};
        if (!used) {
            return;
        }
        const double accuracy_m = proj_coordoperation_get_accuracy(context_.get(), used.get());
        is_accuracy_known_ = is_accuracy_known_ && accuracy_m >= 0.0;
        accuracy_m_ = std::max(accuracy_m_, accuracy_m);
        is_ballpark_ =
            is_ballpark_ || proj_coordoperation_has_ballpark_transformation(context_.get(), used.get()) != 0;
        const PJ_PROJ_INFO info = proj_pj_info(used.get());
        name_ = info.description == nullptr ? std::string{} : std::string{info.description};
    }

    ProjContext context_;
    ProjSystem way_;
    std::set<std::pair<double, double>> asked_;  ///< square kilometres of the target
    bool is_ballpark_ = false;
    bool is_accuracy_known_ = true;
    double accuracy_m_ = 0.0;
    std::string name_;
};

std::string rounded(double value) {
    constexpr double per_m = 1e4;
    return config::to_text(std::round(per_m * value) / per_m);
}

[[noreturn]] void refuse(const formats::Layer& layer, const std::string& target, const std::string& like,
                         const std::string& why) {
    config::fail(config::ExitCode::data, {layer.table.file()},
                 joined("coordinates in ", plausible::name_of_system(layer.projection), why),
                 joined("those of ", like, ", ", plausible::name_of_system(target),
                        ", or a system that PROJ can transform into it"),
                 "transform the layer (QGIS: Reproject layer), or give it its true system (QGIS: Assign "
                 "projection)");
}

/// A shape with other coordinates.
std::string with_places(std::string_view text, const std::vector<PlaceInText>& places,
                        const std::vector<PJ_XY>& coordinates) {
    std::string result;
    std::size_t at = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        result += joined(text.substr(at, places[i].begin - at), rounded(coordinates[i].x), " ",
                         rounded(coordinates[i].y));
        at = places[i].end;
    }
    return joined(result, text.substr(at));
}

}  // namespace

Transformed transform_layer(formats::Layer& layer, const std::string& target, const std::string& like) {
    Way way{layer.projection, target};
    if (!way.is_known()) {
        refuse(layer, target, like, ", between which and that of the terrain no way is known");
    }
    config::Table& table = layer.table;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string text = table.seen_text(row, "wkt");
        const std::vector<PlaceInText> places = places_in(text);
        std::vector<PJ_XY> coordinates;
        for (const PlaceInText& place : places) {
            const auto moved = way.at(place.x, place.y);
            if (!moved) {
                config::fail(config::ExitCode::data, table.place(row, "wkt"),
                             joined("a place ", config::to_text(place.x), " ", config::to_text(place.y),
                                    " outside the area of ", plausible::name_of_system(layer.projection)),
                             joined("coordinates of that system, to be transformed into ",
                                    plausible::name_of_system(target)),
                             "give the layer its true system (QGIS: Assign projection)");
            }
            coordinates.push_back(*moved);
        }
        table.set_text(row, "wkt", with_places(text, places, coordinates));
    }
    if (way.is_ballpark()) {
        refuse(layer, target, like, ", whose datum is not known");
    }
    const auto accuracy_m = way.accuracy_m();
    const std::string accuracy =
        accuracy_m ? joined("accurate to ", config::to_text(*accuracy_m), " m") : "of unknown accuracy";
    const std::string from = plausible::name_of_system(layer.projection);
    Transformed done;
    done.note = joined(table.file(), ": transformed from ", from, " to ", plausible::name_of_system(target),
                       " by ", way.name().empty() ? "PROJ" : way.name(), ", ", accuracy);
    if (!accuracy_m || *accuracy_m > accurate_m) {
        done.warning = joined("a transformation from ", from, " ", accuracy);
    }
    layer.projection = target;
    return done;
}

}  // namespace coupling::systems
