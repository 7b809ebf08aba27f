#pragma once

#include <string>
#include <vector>

#include "coupling/inputs/forest/forest_site.hpp"
#include "tests/coupling/inputs/opened.hpp"

namespace coupling {

/// The sample project with a forest to simulate for four years: eight years of climate, two stands in the
/// east, soils.
class ForestProject : public SampleProject {
public:
    ForestProject() {
        std::string text = read("scenario.ini");
        text +=
            "[run]\nyears = 4\n[forest]\nlatitude_deg = 47\n[stands]\nmap = stands.asc\n"
            "[soil]\nmap = soil.asc\ntypes = soils.csv\n[climate]\nfile = climate.csv\nelevation_m = 500\n";
        write("scenario.ini", text);
        write("stands.asc", header() + rows([](int column, int row) {
                                return column < 4 ? "0" : row < 5 ? "7" : "8";
                            }));
        write("soil.asc", header() + rows([](int column, int) { return column < 8 ? "1" : "2"; }));
        write("soils.csv",
              "code,water_capacity_mm,texture_class,fertility,nitrogen_kg_per_ha_year,ph\n"
              "1,70,2,0.4,50,4.5\n2,120,3,0.7,60,5.5\n");
        write("climate.csv", climate_of(2001, 2008));
        write("records.csv",
              "stand,species,stems_pha,basal_area_m2pha,mean_dbh_cm,mean_height_m,age_years,structure\n"
              "7,PIAB,600,,25,22,80,even_aged\n7,ABAL,,5,20,,,even_aged\n8,FASY,400,20,,,,plenter\n");
    }

    /// Months of some years; each year is a tenth of a degree warmer than the one before.
    static std::string climate_of(int first, int last) {
        std::string text =
            "year,month,tmin_c,tmax_c,tave_c,prec_mm,rad_mj_m2_d,vpd_kpa,frost_days,gdd55_c_d,abs_tmin_c\n";
        constexpr int degc[] = {-4, -3, 1, 5, 10, 13, 15, 15, 11, 7, 1, -3};
        constexpr int radiation[] = {4, 7, 11, 15, 18, 19, 19, 16, 12, 8, 4, 3};
        for (int year = first; year <= last; ++year) {
            for (int m = 0; m < 12; ++m) {
                const double mean = degc[m] + 0.1 * (year - first);
                std::ostringstream row;
                row << year << ',' << m + 1 << ',' << mean - 4 << ',' << mean + 5 << ',' << mean << ",110,"
                    << radiation[m] << ",0.4,"
                    << (degc[m] < 0   ? 25
                        : degc[m] < 6 ? 10
                                      : 0)
                    << ',' << (degc[m] > 5 ? 30 * (degc[m] - 5) : 0) << ',' << mean - 12 << '\n';
                text += row.str();
            }
        }
        return text;
    }
};

}  // namespace coupling
