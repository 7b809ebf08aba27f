#include "validation/engine/case/profile.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/units/angle.hpp"
#include "coupling/inputs/ground/surface_types.hpp"

namespace coupling::validation {
namespace {

using config::joined;

double tangent_of_deg(double degrees) {
    return std::tan(config::Angle::from_degrees(degrees).in_radians());
}

/// Reads rows of either form and collects what is wrong.
class ProfileReader {
public:
    explicit ProfileReader(const config::Table& table) : table_{table} {
        for (const ShippedSurface& surface : shipped_surfaces()) {
            known_.push_back(surface.name);
        }
    }

    Profile read() {
        const bool pieces = table_.has("length_m") || table_.has("slope_deg");
        table_.require(pieces ? std::vector<std::string>{"length_m", "slope_deg", "surface"}
                              : std::vector<std::string>{"distance_m", "height_m", "surface"},
                       problems_);
        problems_.throw_if_any();
        Profile profile = pieces ? read_pieces() : read_survey();
        problems_.throw_if_any();
        if (profile.size() < 2) {
            problems_.add(config::ExitCode::data, {table_.file()}, "a profile without length",
                          pieces ? "at least one piece" : "at least two corners");
        } else if (profile.back().height_m > profile.front().height_m) {
            problems_.add(config::ExitCode::data, {table_.file()},
                          joined("a profile that rises from ", config::to_text(profile.front().height_m),
                                 " m to ", config::to_text(profile.back().height_m), " m"),
                          "corners from above to below");
        }
        problems_.throw_if_any();
        return profile;
    }

private:
    Profile read_survey() {
        Profile profile;
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            const auto distance_m = table_.number(row, "distance_m", {}, problems_);
            const auto height_m = table_.number(row, "height_m", {}, problems_);
            const bool last = row + 1 == table_.rows();
            std::string surface = last && table_.text(row, "surface").empty() && !profile.empty()
                                      ? profile.back().surface
                                      : surface_of(row);
            if (!distance_m || !height_m) {
                continue;
            }
            if (!profile.empty() && *distance_m <= profile.back().distance_m) {
                problems_.add(config::ExitCode::data, table_.place(row, "distance_m"),
                              config::in_quotes(table_.text(row, "distance_m")),
                              "a distance beyond that of the corner above");
            }
            profile.push_back({*distance_m, *height_m, std::move(surface)});
        }
        return profile;
    }

    Profile read_pieces() {
        constexpr config::NumberRange lengths{.low = 0.0, .high = 10'000.0, .low_excluded = true};
        constexpr config::NumberRange slopes{.low = -60.0, .high = 89.0};
        Profile profile;
        double distance_m = 0.0;
        double height_m = 0.0;
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            const auto length_m = table_.number(row, "length_m", lengths, problems_);
            const auto slope_deg = table_.number(row, "slope_deg", slopes, problems_);
            const std::string surface = surface_of(row);
            profile.push_back({distance_m, height_m, surface});
            distance_m += length_m.value_or(1.0);
            height_m -= length_m.value_or(1.0) * tangent_of_deg(slope_deg.value_or(0.0));
        }
        if (!profile.empty()) {
            profile.push_back({distance_m, height_m, profile.back().surface});
            for (ProfileCorner& corner : profile) {
                corner.height_m -= height_m;
            }
        }
        return profile;
    }

    std::string surface_of(std::size_t row) {
        const std::string& name = table_.text(row, "surface");
        if (std::find(known_.begin(), known_.end(), name) == known_.end()) {
            const std::string nearest = config::nearest_word(name, known_);
            problems_.add(
                config::ExitCode::data, table_.place(row, "surface"), config::in_quotes(name),
                nearest.empty() ? "a name of `bannwald info surfaces`" : config::in_quotes(nearest));
        }
        return name;
    }

    const config::Table& table_;
    std::vector<std::string> known_;
    config::Problems problems_;
};

/// The piece that a distance lies on, or the one that is carried on to it: its upper corner.
std::size_t piece_at(std::span<const ProfileCorner> profile, double distance_m) {
    return std::min(corner_above(profile, distance_m), profile.size() - 2);
}

}  // namespace

Profile read_profile(std::string_view text, const std::string& file) {
    std::istringstream in{std::string{text}};
    const config::Table table = config::Table::read(in, file);
    return ProfileReader{table}.read();
}

Profile with_slope_change(const Profile& profile, double change_deg) {
    constexpr double steep_deg = 15.0;
    Profile changed = profile;
    for (std::size_t k = profile.size() - 1; k > 0; --k) {
        const double length_m = profile[k].distance_m - profile[k - 1].distance_m;
        const double drop_m = profile[k - 1].height_m - profile[k].height_m;
        const double slope_deg = config::Angle::from_radians(std::atan2(drop_m, length_m)).in_degrees();
        const bool moved = slope_deg > steep_deg && change_deg != 0.0;
        changed[k - 1].height_m =
            changed[k].height_m +
            (moved ? length_m * tangent_of_deg(std::min(slope_deg + change_deg, 89.0)) : drop_m);
    }
    return changed;
}

std::size_t corner_above(std::span<const ProfileCorner> profile, double distance_m) {
    const auto beyond =
        std::upper_bound(profile.begin(), profile.end(), distance_m,
                         [](double value, const ProfileCorner& corner) { return value < corner.distance_m; });
    return beyond == profile.begin() ? 0 : static_cast<std::size_t>(beyond - profile.begin()) - 1;
}

double height_at(std::span<const ProfileCorner> profile, double distance_m) {
    const std::size_t k = piece_at(profile, distance_m);
    const ProfileCorner& from = profile[k];
    const ProfileCorner& to = profile[k + 1];
    const double share = (distance_m - from.distance_m) / (to.distance_m - from.distance_m);
    return from.height_m + share * (to.height_m - from.height_m);
}

SlopeLength::SlopeLength(std::span<const ProfileCorner> profile) : profile_{profile}, to_corner_m_{0.0} {
    for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
        to_corner_m_.push_back(to_corner_m_.back() +
                               std::hypot(profile[k + 1].distance_m - profile[k].distance_m,
                                          profile[k + 1].height_m - profile[k].height_m));
    }
}

double SlopeLength::at_m(double distance_m) const {
    const std::size_t k = piece_at(profile_, distance_m);
    const double share =
        (distance_m - profile_[k].distance_m) / (profile_[k + 1].distance_m - profile_[k].distance_m);
    return to_corner_m_[k] + share * (to_corner_m_[k + 1] - to_corner_m_[k]);
}

}  // namespace coupling::validation
