#include "coupling/results/tables/table_layout.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr std::string_view any_year = "YEAR";

bool is_file_of(const TableLayout& layout, std::string_view file) {
    const std::string_view pattern = layout.file;
    const std::size_t at = pattern.find(any_year);
    if (at == std::string_view::npos) {
        return file == pattern;
    }
    const std::string_view end = pattern.substr(at + any_year.size());
    if (file.size() <= at + end.size() || file.substr(0, at) != pattern.substr(0, at) ||
        !file.ends_with(end)) {
        return false;
    }
    const std::string_view year = file.substr(at, file.size() - at - end.size());
    return std::all_of(year.begin(), year.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Names end with the first of these.
constexpr std::pair<std::string_view, std::string_view> endings[]{{"_percent_years", "% years"},
                                                                  {"_hours_pha", "h/ha"},
                                                                  {"_eur_pha", "EUR/ha"},
                                                                  {"_per_1000", "1/1000"},
                                                                  {"_m3pha", "m3/ha"},
                                                                  {"_m2pha", "m2/ha"},
                                                                  {"_tpha", "t/ha"},
                                                                  {"_pha", "1/ha"},
                                                                  {"_mps2", "m/s2"},
                                                                  {"_mps", "m/s"},
                                                                  {"_kmph", "km/h"},
                                                                  {"_percent", "%"},
                                                                  {"_degc", "degC"},
                                                                  {"_years", "years"},
                                                                  {"_deg", "deg"},
                                                                  {"_ha", "ha"},
                                                                  {"_kg", "kg"},
                                                                  {"_kj", "kJ"},
                                                                  {"_mj", "MJ"},
                                                                  {"_m3", "m3"},
                                                                  {"_m2", "m2"},
                                                                  {"_mm", "mm"},
                                                                  {"_cm", "cm"},
                                                                  {"_m", "m"},
                                                                  {"_s", "s"}};

std::string unit_of_name(std::string_view name) {
    for (const std::string_view interval : {"_low_90", "_high_90", "_low_95", "_high_95"}) {
        if (name.ends_with(interval)) {
            return unit_of_name(name.substr(0, name.size() - interval.size()));
        }
    }
    if (constexpr std::string_view a_year = "_yr"; name.ends_with(a_year)) {
        return joined(unit_of_name(name.substr(0, name.size() - a_year.size())), "/yr");
    }
    const auto found = std::find_if(std::begin(endings), std::end(endings),
                                    [&](const auto& each) { return name.ends_with(each.first); });
    return found == std::end(endings) ? "" : std::string{found->second};
}

}  // namespace

const TableLayout* find_layout(const std::vector<TableLayout>& layouts, std::string_view file) {
    const auto found = std::find_if(layouts.begin(), layouts.end(),
                                    [&](const TableLayout& layout) { return is_file_of(layout, file); });
    return found == layouts.end() ? nullptr : &*found;
}

std::string unit_in(const Column& column) {
    const std::string unit = unit_of_name(column.name);
    return !unit.empty() ? unit : column.holds == Holds::text ? "text" : "-";
}

void write_header(std::ostream& out, const TableLayout& layout) {
    const char* separator = "";
    for (const Column& column : layout.columns) {
        out << separator << column.name;
        separator = ",";
    }
    out << '\n';
}

}  // namespace coupling
