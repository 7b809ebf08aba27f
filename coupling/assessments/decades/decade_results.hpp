#pragma once

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/decades/decision/decision.hpp"
#include "coupling/assessments/decades/members/management.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/risk/risk_over_years.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/forest/forest_site.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// A finished run over years, ready to be written.
struct DecadeResults {
    const Scenario& scenario;
    const Site& site;  ///< with its forest
    Names names;
    std::span<const MemberYears> members;  ///< by regime, climate, replicate
    std::uint64_t simulated_years = 0;     ///< years of members that this run simulated itself
    std::uint64_t rocks = 0;               ///< of a year; 0: no rockfall
    const config::Warnings& warnings;
    std::string version;
    const Management* management = nullptr;  ///< for maps of its areas and target profiles
    const RiskOverYears* risk = nullptr;     ///< with risk.assess
    const Decision* decision = nullptr;      ///< with protection figures after the start
};

/// Writes tables/, rasters/, summary.json and report.html into an existing folder; returns all files. Throws
/// config::InputError (file); what was written so far stays.
std::vector<WrittenFile> write_results(const DecadeResults& results, const std::filesystem::path& folder,
                                       const WriteWatch& watch = {});

/// What the run says of the question which regime keeps protection, in sentences (decision/verdict.hpp); none
/// without a decision.
std::vector<std::string> verdict_of(const DecadeResults& results);

/// In results/summary.cpp, where all summaries are written.
void write_summary(std::ostream& out, const DecadeResults& results, const std::vector<WrittenFile>& files);

}  // namespace coupling::decades
