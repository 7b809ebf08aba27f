#include "coupling/inputs/scenario/ground_changes.hpp"

#include <algorithm>
#include <string_view>

#include "config/options/options.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/scenario/ground_columns.hpp"

namespace coupling {

namespace {

using config::joined;
using rockfall::SurfaceType;

constexpr std::string_view prefix = "ground.";

const GroundFigure* column_of(std::string_view name) {
    const auto found = std::find_if(ground_figures().begin(), ground_figures().end(),
                                    [&](const GroundFigure& figure) { return figure.name == name; });
    return found == ground_figures().end() ? nullptr : &*found;
}

std::string column_names() {
    std::string names;
    for (const GroundFigure& column : ground_figures()) {
        names = joined(names, names.empty() ? "" : ", ", column.name);
    }
    return names;
}

bool is_code(std::string_view name) {
    return !name.empty() &&
           std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

void GroundChanges::declare(config::Options& options) {
    options.free_section(std::string{prefix});
}

GroundChanges::GroundChanges(const config::Options& options, const std::vector<std::string>& shipped_names) {
    config::Problems problems;
    const auto refuse = [&](const config::FreeEntry& entry, std::string found, std::string expected) {
        problems.add(config::ExitCode::settings, entry.place, std::move(found), std::move(expected));
    };
    for (const config::FreeEntry& entry : options.free_entries()) {
        if (!entry.section.starts_with(prefix)) {
            continue;
        }
        const std::string ground = entry.section.substr(prefix.size());
        const bool is_shipped =
            std::find(shipped_names.begin(), shipped_names.end(), ground) != shipped_names.end();
        if (!is_shipped && !is_code(ground)) {
            const std::string nearest = config::nearest_word(ground, shipped_names);
            refuse(entry, joined("ground type ", config::in_quotes(ground)),
                   nearest.empty() ? "a name of `bannwald info surfaces` or a code of terrain.surface_types"
                                   : config::in_quotes(nearest));
            continue;
        }
        const GroundFigure* column = column_of(entry.key);
        if (column == nullptr) {
            refuse(entry, joined("key ", config::in_quotes(entry.key), " of a ground type"),
                   joined("one of ", column_names()));
            continue;
        }
        const auto value = config::parse_number(entry.value);
        if (!value || *value < column->range.low || *value > column->range.high) {
            refuse(entry, joined(entry.section, ".", entry.key, " = ", config::in_quotes(entry.value)),
                   config::describe("a number", column->range));
            continue;
        }
        changes_.push_back({ground, entry.key, *value, entry.place});
    }
    problems.throw_if_any();
}

void GroundChanges::apply(const std::string& name, SurfaceType& type) const {
    for (const Change& change : changes_) {
        if (change.ground == name) {
            column_of(change.column)->set(type, change.value);
        }
    }
}

std::vector<config::Place> GroundChanges::of_others_than(const std::vector<std::string>& names) const {
    std::vector<config::Place> places;
    for (const Change& change : changes_) {
        if (std::find(names.begin(), names.end(), change.ground) == names.end()) {
            places.push_back(change.place);
        }
    }
    return places;
}

}  // namespace coupling
