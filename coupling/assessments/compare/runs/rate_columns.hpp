#pragma once

#include <string>
#include <vector>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"

namespace coupling::compare {

/// Columns and figures of rocks above an energy: "above_300_kj" + "_bare" + "_per_1000".
struct RateColumn {
    std::string begin;
    [[nodiscard]] std::string with(const std::string& infix) const {
        return config::joined(begin, infix, "_per_1000");
    }
};

/// Those that a table has; runs of earlier versions have none. Throws config::InputError (data) for one that
/// lacks one of its `wanted` columns.
std::vector<RateColumn> rate_columns(const config::Table& table, const std::vector<std::string>& wanted);

}  // namespace coupling::compare
