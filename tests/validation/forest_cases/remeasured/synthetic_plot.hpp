#pragma once

#include <sstream>
#include <string>

#include "tests/validation/forest_cases/shipped_case.hpp"
#include "validation/engine/case/case_files.hpp"

namespace coupling::validation::forest_cases::remeasured {

// A synthetic plot: nobody measured it.

inline std::string synthetic_site() {
    return "width_m,length_m,elevation_m,latitude_deg,slope_deg,aspect_deg,fertility,water_mm,"
           "nitrogen_kg_ha_yr,ph,first_year,last_year,least_dbh_cm\n"
           "30,30,1000,47.5,20,180,0.7,120,60,5,1990,2000,7\n";
}

/// Spruces and beeches five metres apart, 12 to 47 cm thick; numbers 1 to 36.
inline double synthetic_dbh_cm(int number) {
    return 12.0 + (number * 11) % 36;
}
inline const char* synthetic_species(int number) {
    return number % 2 == 0 ? "piab" : "fasy";
}
inline std::string synthetic_trees() {
    std::ostringstream out;
    out << "tree_id,x_m,y_m,species,dbh_cm\n";
    for (int number = 1; number <= 36; ++number) {
        out << number << ',' << 2.5 + 5.0 * ((number - 1) % 6) << ',' << 2.5 + 5.0 * ((number - 1) / 6) << ','
            << synthetic_species(number) << ',' << synthetic_dbh_cm(number) << '\n';
    }
    return out.str();
}

/// Ten years later: each tree 2 cm thicker, numbers 3 and 4 dead, 6 felled, a new fir of 7.5 cm.
inline std::string synthetic_end() {
    std::ostringstream out;
    out << "tree_id,species,dbh_cm\n";
    for (int number = 1; number <= 36; ++number) {
        if (number != 3 && number != 4 && number != 6) {
            out << number << ',' << synthetic_species(number) << ',' << synthetic_dbh_cm(number) + 2.0
                << '\n';
        }
    }
    out << "101,abal,7.5\n102,abal,6.5\n";
    return out.str();
}

inline CaseFiles synthetic_case() {
    CaseFiles files;
    files.name = files.folder = "synthetic";
    files.texts["case.ini"] =
        "[case]\ntitle = A synthetic plot measured twice\ncitation = nobody measured it\n"
        "kind = forest_remeasured\nrebuilt = all of it\n\n[remeasured]\nreplicates = 2\n";
    files.texts["README.md"] = "Synthetic.\n";
    files.texts["site.csv"] = synthetic_site();
    files.texts["trees.csv"] = synthetic_trees();
    files.texts["trees_end.csv"] = synthetic_end();
    files.texts["fell_list.csv"] = "tree_id,year\n6,1995\n";
    files.texts["climate.csv"] = shipped_text("forest_belts", "climate.csv");
    files.texts["criteria.csv"] =
        "quantity,low,high,rests_on,rule,cause\nincrement_ratio:all:all,0.2,5,independent,,\n";
    return files;
}

}  // namespace coupling::validation::forest_cases::remeasured
