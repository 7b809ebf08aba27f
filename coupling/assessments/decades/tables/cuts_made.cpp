#include "coupling/assessments/decades/tables/cuts_made.hpp"

#include <map>
#include <tuple>

#include "coupling/assessments/decades/tables/intervention_areas.hpp"
#include "coupling/assessments/decades/tables/member_columns.hpp"

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

namespace {

struct CutRow {
    const Names& names;
    std::size_t course;
    const CutMade& cut;
    std::string outline;

    [[nodiscard]] const auto& row_of_regime() const {
        return names.interventions[names.regime_of(course)][cut.intervention];
    }
};

TableOf<CutRow> table_of_cuts() {
    constexpr const char* given = "input regimes.list";
    constexpr const char* done = "simulated, first replicate";
    return {"cuts_made.csv",
            "Where each regime felled trees in each year of the first replicate, as polygons.",
            "the ground on which a row of a regime felled or girdled trees in a year, first replicate",
            {course_columns<CutRow>(),
             {"year", "simulated years since the start; 0 is the start", done,
              [](const auto& row) { return row.cut.year; }},
             {"intervention", "name of the row of the regime", given,
              [](const auto& row) { return row.row_of_regime().first; }},
             {"treatment", "kind of treatment", given,
              [](const auto& row) { return row.row_of_regime().second; }},
             {"area_ha", 2, "patches of 10 m that lost a tree by it", done,
              [](const auto& row) {
                  return static_cast<double>(row.cut.patches.size()) * (forest::patch_area_m2 / 10'000.0);
              }},
             {"wkt", "their outline as well-known text", done, &CutRow::outline}}};
}

}  // namespace

TableLayout cuts_made_layout() {
    return table_of_cuts();
}

std::vector<WrittenFile> write_cuts_made(const std::filesystem::path& folder, const Names& names,
                                         const forest::PatchGrid& grid, std::span<const CutMade> cuts) {
    if (cuts.empty()) {
        return {};
    }
    return {table_of_cuts().write(folder, [&](auto& rows) {
        for (const CutMade& cut : cuts) {
            rows.add({names, cut.course, cut, wkt_of(outline_of(grid, cut.patches))});
        }
    })};
}

}  // namespace coupling::decades
