#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "validation/engine/forest_cases/remeasured/stand.hpp"

namespace coupling::validation::forest_cases::remeasured {

/// Growth that can hardly be: of single trees a warning with their lines, of the plot an error.
class GrowthCheck {
public:
    explicit GrowthCheck(const MeasuredStand& stand)
        : years_{static_cast<double>(stand.years())}, least_dbh_cm_{stand.least_dbh_cm} {}

    /// A tree that was too thin to be counted before.
    void add_new(double dbh_cm, std::size_t line);
    /// A tree of both measurements. Requires its diameter at the end.
    void add(const MeasuredTree& tree, std::size_t line);
    /// Whether a new tree can hardly have grown in.
    [[nodiscard]] bool has_thick_new_trees() const { return !too_thick_.empty(); }
    void report(const config::Table& table, config::Warnings& warnings, config::Problems& problems);

private:
    double years_;
    double least_dbh_cm_;
    double sum_cm_pyear_ = 0.0;
    double trees_ = 0.0;
    std::vector<std::size_t> fast_;
    std::vector<std::size_t> shrunk_;
    std::vector<std::size_t> too_thick_;
};

}  // namespace coupling::validation::forest_cases::remeasured
