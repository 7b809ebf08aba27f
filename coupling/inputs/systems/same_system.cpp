#include "coupling/inputs/systems/same_system.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"

namespace coupling::plausible {
namespace {

using Value = std::optional<double> Projection::*;

/// A value that decides where a coordinate lies, and how near two of it are the same.
struct DecidingValue {
    Value value;
    double tolerance;
};

constexpr double degree = 1e-6;
constexpr double metre = 0.01;
constexpr std::array deciding_values{
    DecidingValue{&Projection::central_meridian_deg, degree},
    DecidingValue{&Projection::latitude_of_origin_deg, degree},
    DecidingValue{&Projection::false_easting, metre}, DecidingValue{&Projection::false_northing, metre},
    DecidingValue{&Projection::scale, 1e-9}, DecidingValue{&Projection::metres_per_unit, 1e-9},
    DecidingValue{&Projection::major_axis_m, 0.5},
    // GRS 80 and WGS 84 differ by 1.5e-6, Bessel and either by nearly one.
    DecidingValue{&Projection::inverse_flattening, 1e-3}};

std::string plain_letters(std::string_view text) {
    std::string letters;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0) {
            letters += static_cast<char>(std::tolower(byte));
        }
    }
    return letters;
}

bool has_origin(const Projection& projection) {
    return projection.is_geographic ||
           (projection.central_meridian_deg && projection.false_easting && projection.false_northing);
}

}  // namespace

Sameness compare_systems(std::string_view one, std::string_view two) {
    one = config::trimmed(one);
    two = config::trimmed(two);
    if (one.empty() || two.empty()) {
        return Sameness::silent;
    }
    if (one == two) {
        return Sameness::same;
    }
    const auto a = read_projection(one);
    const auto b = read_projection(two);
    if (!a || !b) {
        return Sameness::unknown;
    }
    if (a->epsg && a->epsg == b->epsg) {
        return Sameness::same;
    }
    if (a->is_geographic != b->is_geographic) {
        return Sameness::other;
    }
    for (const DecidingValue& deciding : deciding_values) {
        const auto& of_a = (*a).*deciding.value;
        const auto& of_b = (*b).*deciding.value;
        if (of_a && of_b && std::abs(*of_a - *of_b) > deciding.tolerance) {
            return Sameness::other;
        }
    }
    if (!has_origin(*a) || !has_origin(*b)) {
        return plain_letters(a->name) == plain_letters(b->name) ? Sameness::same : Sameness::unknown;
    }
    const bool other_codes = a->epsg && b->epsg;  // not the same ones: see above
    const bool other_datums =
        (one.find("ETRS") == std::string_view::npos) != (two.find("ETRS") == std::string_view::npos);
    return other_codes || other_datums ? Sameness::nearly : Sameness::same;
}

std::optional<int> code_of_system(std::string_view text) {
    const auto projection = read_projection(text);
    if (!projection || projection->epsg) {
        return projection ? projection->epsg : std::nullopt;
    }
    const KnownSystem* const known = system_of(*projection, text);
    return known != nullptr && known->epsg > 0 ? std::optional{known->epsg} : std::nullopt;
}

std::string name_of_system(std::string_view text) {
    const auto projection = read_projection(text);
    if (!projection) {
        return "a system that cannot be read";
    }
    const std::optional<int> code = code_of_system(text);
    return config::joined(config::in_quotes(projection->name),
                          code ? config::joined(" (EPSG ", std::to_string(*code), ")") : std::string{});
}

}  // namespace coupling::plausible
