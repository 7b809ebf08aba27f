#include "coupling/assessments/decades/decade_layouts.hpp"

#include "coupling/assessments/decades/decision/decision_tables.hpp"
#include "coupling/assessments/decades/risk/risk_years_table.hpp"
#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/assessments/decades/tables/cuts_made.hpp"
#include "coupling/assessments/decades/tables/fall_tables.hpp"
#include "coupling/assessments/decades/tables/intervention_areas.hpp"
#include "coupling/assessments/decades/tables/nais_years.hpp"
#include "coupling/assessments/decades/tables/pooled_reduction.hpp"
#include "coupling/assessments/decades/tables/profile_tables.hpp"
#include "coupling/assessments/decades/tables/protection_places.hpp"
#include "coupling/assessments/decades/tables/replicate_draws.hpp"
#include "coupling/assessments/decades/tables/storm_table.hpp"
#include "coupling/assessments/decades/tables/variance_split.hpp"
#include "coupling/assessments/decades/tables/work_tables.hpp"

namespace coupling::decades {

const std::vector<TableLayout>& decade_layouts() {
    static const std::vector<TableLayout> layouts = together(
        forest_layouts(), work_layouts(), fall_layouts(), profile_layouts(), comparison_layouts(),
        decision_layouts(),
        std::vector{risk_by_year_layout(), pooled_reduction_layout(), protection_by_distance_layout(),
                    variance_split_layout(), replicate_draws_layout(), storms_layout(), nais_layout(),
                    intervention_areas_layout(), cuts_made_layout()});
    return layouts;
}

}  // namespace coupling::decades
