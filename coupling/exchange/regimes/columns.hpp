#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/text/numbers.hpp"
#include "config/units/angle.hpp"
#include "coupling/exchange/regimes/intervention.hpp"

namespace coupling {

/// A set of treatments or of places, a bit each.
using Uses = std::uint32_t;

/// Where a column's value goes.
using RegimeField =
    std::variant<int& (*)(Intervention&), std::size_t& (*)(Intervention&), double& (*)(Intervention&),
                 bool& (*)(Intervention&), config::Angle& (*)(Intervention&), std::string& (*)(Intervention&),
                 std::optional<int>& (*)(Intervention&), std::optional<double>& (*)(Intervention&),
                 std::vector<std::uint32_t>& (*)(Intervention&), std::vector<double>& (*)(Intervention&),
                 std::vector<forest::SpeciesId>& (*)(Intervention&), Treatment& (*)(Intervention&),
                 Where& (*)(Intervention&)>;

/// What a column asks for, and where it means something.
struct ColumnRules {
    std::string_view source{};  ///< of usual values and of the default
    config::NumberRange range{};
    Uses treatments = 0;  ///< for which it means something; 0 = for all
    Uses places = 0;      ///< the same by `where`; 0 = everywhere
    bool needed = false;  ///< wherever it means something
};

/// All that is said about a column of a regime, once: it feeds reader, check and listing.
struct RegimeColumn {
    std::string_view name;
    RegimeField field;
    std::string_view meaning;
    ColumnRules rules{};
};

/// All columns, in the order in which a table usually has them.
std::span<const RegimeColumn> regime_columns();

/// Whether a column means something for an intervention whose treatment and place are known.
bool is_used(const RegimeColumn& column, const Intervention& intervention);

/// A column as text, for a listing: its default, empty where there is none, and who uses it ("clear_cut,
/// group_cut", "slits", "all").
std::string default_text(const RegimeColumn& column);
std::string users_text(const RegimeColumn& column);

}  // namespace coupling
