#include "coupling/inputs/scenario/block_grounds.hpp"

#include <algorithm>

#include "config/data/shipped_tables.hpp"
#include "config/table/schema.hpp"

namespace coupling {
namespace {

using rockfall::BlockGround;

constexpr config::NumberRange block_friction_range{0.0, 10.0};
constexpr BlockFigure figures_of_blocks[] = {
    {"friction", &BlockGround::friction, block_friction_range,
     "of blocks, or least friction of the slip law"},
    {"friction_max", &BlockGround::friction_max, block_friction_range, "greatest friction of the slip law"},
    {"slip_kappa_pm", &BlockGround::slip_kappa_pm, {0.0, 1000.0}, "growth of friction with the slip"},
    {"slip_beta_ps", &BlockGround::slip_beta_ps, {0.0, 1e5}, "decay of the slip without contact"},
    {"contact_drag_ps", &BlockGround::drag_ps, {0.0, 100.0}, "drag of blocks in contact"},
    {"restitution", &BlockGround::restitution, {0.0, 1.0}, "of slow impacts of blocks"},
    {"rolling_resistance", &BlockGround::rolling_resistance, block_friction_range, "couple against the spin"},
    {"soil_strength_kpa", &BlockGround::soil_strength_kpa, {0.0, 1e6}, "of the scars of impacts; 0: none"},
};

config::Schema<BlockGround> class_columns() {
    std::vector<config::ColumnOf<BlockGround>> columns{
        {"name", &BlockGround::name, ""},
        {"friction_law", &BlockGround::law, "", {.words = friction_laws()}}};
    for (const BlockFigure& figure : figures_of_blocks) {
        columns.push_back(
            {figure.name, figure.value, figure.meaning, {.range = figure.range, .optional = true}});
    }
    return {{.role = "rigid_grounds", .setting = "", .row = "class"}, std::move(columns)};
}

}  // namespace

std::span<const BlockFigure> block_figures() {
    return figures_of_blocks;
}

std::vector<std::string> friction_laws() {
    return {"constant", "slip"};
}

const std::vector<BlockGround>& shipped_block_grounds() {
    static const std::vector<BlockGround> grounds = [] {
        const auto rows = class_columns().all(config::read_shipped_table("rigid_grounds.csv"));
        return std::vector<BlockGround>{rows.begin(), rows.end()};
    }();
    return grounds;
}

const BlockGround* block_class(const std::string& name, const config::Place& place,
                               config::Problems& problems) {
    std::vector<std::string> names;
    for (const BlockGround& of : shipped_block_grounds()) {
        if (of.name == name) {
            return &of;
        }
        names.push_back(of.name);
    }
    const std::string nearest = config::nearest_word(name, names);
    problems.add(config::ExitCode::data, place, config::in_quotes(name),
                 "a class of `bannwald info rigid_grounds`" + (nearest.empty() ? "" : " (" + nearest + "?)"));
    return nullptr;
}

}  // namespace coupling
