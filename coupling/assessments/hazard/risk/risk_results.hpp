#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/consequences/risk_plan.hpp"
#include "coupling/assessments/hazard/risk/avoided_risk.hpp"
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
    std::vector<Cover> slopes;             ///< with forest where there is one, then bare
    std::vector<TargetRisk> targets;       ///< in the order of targets.file
    PlaceRisk all;                         ///< together
    std::optional<AvoidedRisk> avoided{};  ///< with risk.without

    [[nodiscard]] bool with_forest() const { return slopes.front() == Cover::forest; }
    /// The exposed targets from most money a year to least, on the slope as it is; where no money comes
    /// together by arrivals.
    [[nodiscard]] std::vector<std::size_t> ranked() const;
};

/// Adds up return periods one after the other.
class RiskOfPeriods {
public:
    /// `without`: the folder of a finished hazard run of the same rocks without nets and works; empty: none.
    RiskOfPeriods(const RiskPlan& plan, std::filesystem::path without);

    /// From arrivals.csv of a finished return period: 32 bytes for each hit of an exposed target while it is
    /// read. Throws as `hits::for_each_arrival`.
    void add(const std::filesystem::path& folder, double return_period_years, const Site& site,
             const hits::BlockRows& blocks, std::uint64_t seed);
    [[nodiscard]] RiskResults results(const Site& site, std::vector<Cover> slopes) const;

private:
    [[nodiscard]] std::vector<Hit> hits_in(const std::filesystem::path& folder, const Site& site,
                                           const hits::BlockRows& blocks) const;
    [[nodiscard]] AvoidedRisk avoided_on(const Site& site, const std::vector<Cover>& slopes) const;

    RiskPlan plan_;
    RiskSums sums_;
    std::filesystem::path without_;
    std::filesystem::path last_period_without_;
    /// By slope, with the run with nets and works as its forest, and the one without as its bare slope.
    std::vector<RiskSums> with_and_without_;
};

/// Tables of a risk: risk.csv, risk_total.csv, risk_classes.csv, and of what nets and works spare
/// risk_avoided.csv and risk_barriers.csv.
const std::vector<TableLayout>& risk_layouts();
std::vector<WrittenFile> write_tables(const RiskResults& results, const Site& site,
                                      const std::filesystem::path& folder);

/// `risk` of summary.json.
Json risk_json(const RiskResults& results, const Site& site);

/// Of what nets and works spare.
std::vector<TableLayout> avoided_layouts();
std::vector<WrittenFile> write_avoided(const RiskResults& results, const std::filesystem::path& folder);
Json avoided_json(const RiskResults& results);
report::PageFields avoided_fields(const RiskResults& results);

/// Fields of risk_section.html.
report::PageFields risk_fields(const RiskResults& results, const Site& site, const Scenario& scenario);

}  // namespace coupling::hazard::risk
