#include "coupling/assessments/decades/tables/patch_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/assessments/decades/tables/protection_places.hpp"
#include "coupling/results/maps/rasters.hpp"

namespace coupling::decades {
namespace {

using config::joined;

struct PatchQuantity {
    const char* name;
    const char* unit;
    const char* meaning;
    float PatchRow::*value;
};

constexpr std::array patch_quantities{
    PatchQuantity{"stems", "1/ha", "Stems", &PatchRow::stems_pha},
    PatchQuantity{"basal_area", "m2/ha", "Basal area", &PatchRow::basal_area_m2pha},
    PatchQuantity{"volume", "m3/ha", "Stem volume over bark", &PatchRow::volume_m3pha},
    PatchQuantity{"top_height", "m", "Height of the tallest tree", &PatchRow::top_height_m},
    PatchQuantity{"leaf_area_index", "-", "Leaf area index", &PatchRow::leaf_area_index},
    PatchQuantity{"ground_light", "-", "Light at the ground, May to September, relative to the open",
                  &PatchRow::ground_light},
};

/// Sums over replicates, patch by patch.
struct YearSum {
    std::vector<double> values;
    std::size_t members = 0;
};
using Sums = std::map<std::pair<std::size_t, std::int32_t>, YearSum>;  ///< by course and year

/// Of all patches, courses and years: all maps of a quantity share their colours.
float highest_mean(const Sums& sums) {
    double highest = 0.0;
    for (const auto& [key, sum] : sums) {
        for (const double value : sum.values) {
            highest = std::max(highest, value / static_cast<double>(sum.members));
        }
    }
    return static_cast<float>(highest);
}

/// Where the forest protects, of all years together.
struct ProtectionQuantity {
    const char* name;
    const char* unit;
    const char* meaning;
    config::Raster<float> PatchProtection::*raster;
};

constexpr std::array protection_quantities{
    ProtectionQuantity{"protection_spared", "%",
                       "Share of the rocks that the forest stops whose last tree or log stands on the patch",
                       &PatchProtection::spared},
    ProtectionQuantity{"protection_lost_if_cut", "%",
                       "Estimated points of protection lost if nothing stood on the patch alone",
                       &PatchProtection::lost},
};

template <class AnyQuantity>
RasterKind drawn_as(const AnyQuantity& quantity) {
    RasterKind kind{};
    kind.stem = quantity.name;
    kind.unit = quantity.unit;
    kind.palette = Palette::impacts;
    return kind;
}

}  // namespace

std::vector<Column> patch_raster_columns() {
    std::vector<Column> columns;
    for (const PatchQuantity& quantity : patch_quantities) {
        columns.push_back({quantity.name, quantity.unit, quantity.meaning, "simulated"});
    }
    for (const ProtectionQuantity& quantity : protection_quantities) {
        columns.push_back({quantity.name, quantity.unit, quantity.meaning, "simulated"});
    }
    return columns;
}

std::vector<WrittenFile> write_patch_maps(const std::filesystem::path& folder, const Names& names,
                                          std::span<const MemberYears> members, const forest::PatchGrid& grid,
                                          const std::string& projection, const WriteWatch& watch) {
    std::vector<WrittenFile> written;
    for (const PatchQuantity& quantity : patch_quantities) {
        Sums sums;
        for (const MemberYears& member : members) {
            for (const PatchRow& row : member.patches) {
                YearSum& sum = sums[{names.course_of(member.member), row.year}];
                sum.values.resize(grid.size());
                sum.values[row.patch] += row.*quantity.value;
                sum.members += row.patch == 0 ? 1 : 0;
            }
        }
        for (const auto& [key, sum] : sums) {
            if (std::isnan(sum.values.front())) {
                continue;  // light at the start
            }
            config::Raster<float> raster{grid.frame(), std::numeric_limits<float>::quiet_NaN()};
            for (std::size_t p = 0; p < grid.size(); ++p) {
                raster.at(grid.patches()[p].cell) =
                    static_cast<float>(sum.values[p] / static_cast<double>(sum.members));
            }
            const std::string year = std::to_string(key.second);
            const std::string path =
                joined("rasters/forest/", names.course_folder(key.first), "/year_", year);
            watch(path);
            make_folder(folder / path);
            const std::string sentence =
                joined(quantity.meaning, " [", quantity.unit, "], by patch in year ", year, ".");
            written.push_back(write_raster(folder, {joined(path, "/", quantity.name), sentence, raster},
                                           projection, drawn_as(quantity), {0.0F, highest_mean(sums)}));
        }
    }
    return written;
}

std::vector<WrittenFile> write_protection_maps(const std::filesystem::path& folder, const Names& names,
                                               std::span<const MemberYears> members,
                                               const forest::PatchGrid& grid, const std::string& projection,
                                               const WriteWatch& watch) {
    std::vector<PatchProtection> courses;
    for (std::size_t course = 0; course < names.courses(); ++course) {
        courses.push_back(patch_protection(names, members, course, grid));
    }
    std::vector<WrittenFile> written;
    for (const ProtectionQuantity& quantity : protection_quantities) {
        float highest = 0.0F;  // the same colours for all
        for (const PatchProtection& course : courses) {
            highest = std::max(highest, range_of(course.*quantity.raster).high);
        }
        for (std::size_t course = 0; course < courses.size(); ++course) {
            const std::string path = joined("rasters/forest/", names.course_folder(course), "/all_years");
            watch(path);
            make_folder(folder / path);
            const std::string sentence =
                joined(quantity.meaning, " [", quantity.unit, "], all years with rocks together.");
            written.push_back(write_raster(
                folder, {joined(path, "/", quantity.name), sentence, courses[course].*quantity.raster},
                projection, drawn_as(quantity), {0.0F, highest}));
        }
    }
    return written;
}

}  // namespace coupling::decades
