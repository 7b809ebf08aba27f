#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/forest/nais_input.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "forest/stand/patch.hpp"

namespace coupling::decades {

/// The name under which the worst of all criteria stands: the whole profile of a stand and hazard.
inline constexpr const char* whole_profile = "all";

/// A criterion of a stand in a year under a course: how many replicates have which status.
struct NaisCell {
    std::size_t course = 0;
    std::uint32_t stand = 0;  ///< number of the management unit
    std::int32_t year = 0;
    std::string site_type;
    std::string hazard;
    std::string criterion;
    std::string minimal;
    std::string ideal;
    std::string source;
    double area_ha = 0.0;     ///< of the stand
    double mean_value = 0.0;  ///< over replicates that have one; NaN: of the whole profile, or none has
    std::array<std::size_t, forest::nais_statuses> replicates{};  ///< by status
    [[nodiscard]] std::size_t all_replicates() const;
};

/// Every stand in every year against its profile: course by course, stands rising, years rising, criteria as
/// in the profile, then the whole profile of each hazard.
std::vector<NaisCell> nais_over_years(const Names& names, const forest::PatchGrid& grid,
                                      std::span<const MemberYears> members, std::span<const NaisRow> profile);

TableLayout nais_layout();

/// Writes tables/nais.csv; nothing without a profile.
std::vector<WrittenFile> write_nais(const std::filesystem::path& folder, const Names& names,
                                    std::span<const NaisCell> cells);

}  // namespace coupling::decades
