#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "coupling/assessments/consequences/risk_plan.hpp"
#include "coupling/assessments/hazard/risk/risk_sums.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/json.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::hazard::risk {

using consequences::RiskPlan;

/// An exposed target.
struct TargetRisk {
    std::size_t target = 0;  ///< as in the site
    TargetExposure exposure;
    PlaceRisk risk;
};

/// Risk of all exposed targets.
struct RiskResults {
    Curves curves;
    RiskSettings settings;
    std::vector<Cover> slopes;        ///< with forest where there is one, then bare
    std::vector<TargetRisk> targets;  ///< in the order of targets.file
    PlaceRisk all;                    ///< together

    [[nodiscard]] bool with_forest() const { return slopes.front() == Cover::forest; }
    /// The exposed targets from most money a year to least, on the slope as it is; where no money comes
    /// together by arrivals.
    [[nodiscard]] std::vector<std::size_t> ranked() const;
};

/// Adds up return periods one after the other.
class RiskOfPeriods {
public:
    explicit RiskOfPeriods(const RiskPlan& plan);

    /// From arrivals.csv of a finished return period: 32 bytes for each hit of an exposed target while it is
    /// read. Throws as `hits::for_each_arrival`.
    void add(const std::filesystem::path& folder, double return_period_years, const Site& site,
             const hits::BlockRows& blocks);
    [[nodiscard]] RiskResults results(const Site& site, std::vector<Cover> slopes) const;

private:
    RiskPlan plan_;
    RiskSums sums_;
};

/// Tables of a risk: risk.csv, risk_total.csv, risk_classes.csv.
const std::vector<TableLayout>& risk_layouts();
std::vector<WrittenFile> write_tables(const RiskResults& results, const Site& site,
                                      const std::filesystem::path& folder);

/// `risk` of summary.json.
Json risk_json(const RiskResults& results, const Site& site);

/// Fields of risk_section.html.
report::PageFields risk_fields(const RiskResults& results, const Site& site, const Scenario& scenario);

}  // namespace coupling::hazard::risk
