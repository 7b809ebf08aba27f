#pragma once

#include <span>
#include <string_view>

#include "config/text/numbers.hpp"
#include "forest/stand/species.hpp"

namespace forest {

/// A column of numbers in a species table: its unit, what it may hold, where it goes.
struct NumberField {
    std::string_view column;
    std::string_view unit;
    config::NumberRange range;
    double& (*of)(Species&);
};

/// A column of whole numbers.
struct WholeField {
    std::string_view column;
    std::string_view unit;
    config::NumberRange range;
    int& (*of)(Species&);
};

/// A column of yes (1) and no (0).
struct FlagField {
    std::string_view column;
    bool& (*of)(Species&);
};

/// A column of words.
struct TextField {
    std::string_view column;
    std::string& (*of)(Species&);
};

std::span<const NumberField> number_fields();
std::span<const WholeField> whole_fields();
std::span<const FlagField> flag_fields();
std::span<const TextField> text_fields();

/// The one column that is of another kind: P for paraboloid, E for ellipsoid.
inline constexpr std::string_view crown_shape_column = "crown_shape";

}  // namespace forest
