#include "coupling/decades/patch_maps.hpp"

#include <array>
#include <limits>
#include <map>
#include <utility>

#include "config/grid/ascii_grid.hpp"
#include "coupling/results/joined.hpp"

namespace coupling::decades {
namespace {

struct Quantity {
    const char* name;
    const char* unit;
    const char* meaning;
    float PatchRow::*value;
};

constexpr std::array quantities{
    Quantity{"stems", "1/ha", "Stems", &PatchRow::stems_pha},
    Quantity{"basal_area", "m2/ha", "Basal area", &PatchRow::basal_area_m2pha},
    Quantity{"volume", "m3/ha", "Stem volume over bark", &PatchRow::volume_m3pha},
    Quantity{"top_height", "m", "Height of the tallest tree", &PatchRow::top_height_m},
    Quantity{"leaf_area_index", "-", "Leaf area index", &PatchRow::leaf_area_index},
    Quantity{"ground_light", "-", "Light at the ground, May to September, relative to the open",
             &PatchRow::ground_light},
};

/// Sums over replicates, patch by patch.
struct YearSum {
    std::vector<double> values;
    std::size_t members = 0;
};

}  // namespace

std::vector<Column> patch_raster_columns() {
    std::vector<Column> columns;
    for (const Quantity& quantity : quantities) {
        columns.push_back({quantity.name, quantity.unit, quantity.meaning, "simulated"});
    }
    return columns;
}

std::vector<WrittenFile> write_patch_maps(const std::filesystem::path& folder, const Names& names,
                                          std::span<const MemberYears> members, const forest::PatchGrid& grid,
                                          const std::string& projection) {
    std::vector<WrittenFile> written;
    for (const Quantity& quantity : quantities) {
        std::map<std::pair<std::uint32_t, std::int32_t>, YearSum> sums;  // by regime and year
        for (const MemberYears& member : members) {
            for (const PatchRow& row : member.patches) {
                YearSum& sum = sums[{member.member.regime, row.year}];
                sum.values.resize(grid.size());
                sum.values[row.patch] += row.*quantity.value;
                sum.members += row.patch == 0 ? 1 : 0;
            }
        }
        for (const auto& [key, sum] : sums) {
            config::Raster<float> raster{grid.frame(), std::numeric_limits<float>::quiet_NaN()};
            for (std::size_t p = 0; p < grid.size(); ++p) {
                raster.at(grid.patches()[p].cell) =
                    static_cast<float>(sum.values[p] / static_cast<double>(sum.members));
            }
            const std::string year = std::to_string(key.second);
            const std::string path = joined("rasters/forest/", names.regimes[key.first], "/year_", year);
            make_folder(folder / path);
            OutFile file{folder / path / joined(quantity.name, ".asc")};
            config::write_ascii_grid(file.stream(), raster);
            file.close();
            if (!projection.empty()) {
                OutFile prj{folder / path / joined(quantity.name, ".prj")};
                prj.stream() << projection;
                prj.close();
            }
            written.push_back(
                {joined(path, "/", quantity.name, ".asc"),
                 joined(quantity.meaning, " [", quantity.unit, "], by patch in year ", year, ".")});
        }
    }
    return written;
}

}  // namespace coupling::decades
