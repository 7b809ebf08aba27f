#pragma once

// Cases as texts, without files.

#include <string>

#include "validation/engine/case/case_files.hpp"

namespace coupling::validation::testing {

/// An even slope of 38 degrees, 300 m in plan, of fine debris; `more` is appended to its case.ini.
inline CaseFiles even_slope(const std::string& kind = "slope", const std::string& more = "") {
    CaseFiles files{.name = "even", .folder = "cases/even", .texts = {}};
    files.texts["case.ini"] = "[case]\ntitle = even slope\nkind = " + kind +
                              "\n[rock]\ndiameter_m = 0.95\n[series]\nrocks = 40\nseries = 2\n"
                              "rocks_per_series = 10\n[stations]\nnames = foot\ndistances_m = 290\n" +
                              more;
    files.texts["profile.csv"] = "length_m,slope_deg,surface\n300,38,fine_debris\n";
    return files;
}

inline const char* stand_of_site_2 =
    "[stand]\nstems_per_ha = 290\ndbh_mean_cm = 31\ndbh_deviation_cm = 14\n"
    "species = ABAL:72, FASY:14, PIAB:6, ACPS:6\nfrom_m = 0\nto_m = 300\nspacing_m = 2\nstands = 2\n";

}  // namespace coupling::validation::testing
