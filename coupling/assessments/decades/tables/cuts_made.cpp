#include "coupling/assessments/decades/tables/cuts_made.hpp"

#include <map>
#include <tuple>

#include "coupling/assessments/decades/tables/intervention_areas.hpp"
#include "coupling/results/tables/table_layout.hpp"

namespace coupling::decades {

std::vector<CutMade> cuts_made(const Names& names, std::span<const MemberYears> members) {
    std::map<std::tuple<std::size_t, std::int32_t, std::size_t>, std::vector<forest::PatchId>> sorted;
    for (const MemberYears& member : members) {
        for (const CutPatchRow& row : member.cut_patches) {
            sorted[{names.course_of(member.member), row.year, row.intervention}].push_back(
                forest::PatchId{row.patch});
        }
    }
    std::vector<CutMade> cuts;
    for (auto& [key, patches] : sorted) {
        cuts.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), std::move(patches)});
    }
    return cuts;
}

TableLayout cuts_made_layout() {
    constexpr const char* given = "input regimes.list";
    constexpr const char* done = "simulated, first replicate";
    return {"cuts_made.csv",
            "the ground on which a row of a regime felled or girdled trees in a year, first replicate",
            {{"regime", "text", "name of the regime", given},
             {"climate", "text", "name of the climate", "input climate.variants"},
             {"year", "-", "simulated years since the start; 0 is the start", done},
             {"intervention", "text", "name of the row of the regime", given},
             {"treatment", "text", "kind of treatment", given},
             {"area_ha", "ha", "patches of 10 m that lost a tree by it", done},
             {"wkt", "text", "their outline as well-known text", done}}};
}

std::vector<WrittenFile> write_cuts_made(const std::filesystem::path& folder, const Names& names,
                                         const forest::PatchGrid& grid, std::span<const CutMade> cuts) {
    if (cuts.empty()) {
        return {};
    }
    constexpr double patch_ha = forest::patch_area_m2 / 10'000.0;
    return {write_table(folder, "cuts_made.csv",
                        "Where each regime felled trees in each year of the first replicate, as polygons.",
                        [&](std::ostream& out) {
                            TableRows row{out, cuts_made_layout()};
                            for (const CutMade& cut : cuts) {
                                const std::size_t regime = names.regime_of(cut.course);
                                const auto& [name, treatment] = names.interventions[regime][cut.intervention];
                                row.text(names.regimes[regime]);
                                row.text(names.climates[names.climate_of(cut.course)]);
                                row.whole(static_cast<std::uint32_t>(cut.year)).text(name).text(treatment);
                                row.number<2>(static_cast<double>(cut.patches.size()) * patch_ha);
                                row.text(wkt_of(outline_of(grid, cut.patches))).end();
                            }
                        })};
}

}  // namespace coupling::decades
