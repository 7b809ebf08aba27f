#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "validation/engine/case/case_result.hpp"

namespace coupling::validation {

/// A slope from above to below, corner by corner; straight between them. A surface holds from its corner to
/// the next.
using Profile = std::vector<ProfileCorner>;

/// Reads a profile in one of its two forms.
///
///     distance_m,height_m,surface    a survey: corners, distances in plan rising
///     length_m,slope_deg,surface     rebuilt: pieces one below the other, lengths in plan; ends at height 0
///
/// Surfaces are names of config/data/surfaces.csv; that of the last corner of a survey may be left out.
/// Throws InputError (data) with every problem.
Profile read_profile(std::string_view text, const std::string& file);

/// The profile with `change_deg` added to every piece steeper than 15 deg downwards; plan distances and the
/// lowest end stay.
Profile with_slope_change(const Profile& profile, double change_deg);

/// Height at a plan distance; the first and last piece go on beyond the ends.
double height_at(std::span<const ProfileCorner> profile, double distance_m);

/// Length along the slope from its upper end to plan distances, going on beyond the ends.
class SlopeLength {
public:
    /// Keeps a view of the profile, which must outlive it.
    explicit SlopeLength(std::span<const ProfileCorner> profile);
    [[nodiscard]] double at_m(double distance_m) const;

private:
    std::span<const ProfileCorner> profile_;
    std::vector<double> to_corner_m_;
};

/// The corner from which the surface at a plan distance holds.
std::size_t corner_above(std::span<const ProfileCorner> profile, double distance_m);

}  // namespace coupling::validation
