#include "coupling/inputs/scenario/block_grounds.hpp"

#include <algorithm>
#include <sstream>

#include "config/data/shipped_tables.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling {
namespace {

using rockfall::BlockGround;
using rockfall::FrictionLaw;

constexpr config::NumberRange share_range{.low = 0.0, .high = 1.0};

struct Figure {
    const char* name;
    double BlockGround::*value;
    config::NumberRange range;
};
constexpr Figure figures[] = {
    {"friction", &BlockGround::friction, block_friction_range},
    {"friction_max", &BlockGround::friction_max, block_friction_range},
    {"slip_beta_ps", &BlockGround::slip_beta_ps, slip_beta_range},
    {"slip_kappa_pm", &BlockGround::slip_kappa_pm, slip_kappa_range},
    {"contact_drag_ps", &BlockGround::drag_ps, contact_drag_range},
    {"restitution", &BlockGround::restitution, share_range},
    {"rolling_resistance", &BlockGround::rolling_resistance, block_friction_range},
};

void read_figures(const config::Table& table, std::size_t row, BlockGround& ground,
                  config::Problems& problems) {
    if (has_value(table, row, "friction_law")) {
        const std::string& law = table.text(row, "friction_law");
        if (law == "constant" || law == "slip") {
            ground.law = law == "slip" ? FrictionLaw::slip : FrictionLaw::constant;
        } else {
            problems.add(config::ExitCode::data, table.place(row, "friction_law"),
                         "friction_law " + config::in_quotes(law), "constant or slip");
        }
    }
    for (const Figure& figure : figures) {
        if (has_value(table, row, figure.name)) {
            ground.*figure.value =
                table.number(row, figure.name, figure.range, problems).value_or(ground.*figure.value);
        }
    }
    if (ground.law == FrictionLaw::slip && ground.friction_max < ground.friction) {
        problems.add(config::ExitCode::data,
                     table.place(row, table.has("friction_max") ? "friction_max" : "friction"),
                     "friction_max below friction", "friction that grows with the slip");
    }
}

}  // namespace

std::vector<std::string> block_ground_columns() {
    std::vector<std::string> names{"rigid_ground", "friction_law"};
    for (const Figure& figure : figures) {
        names.emplace_back(figure.name);
    }
    return names;
}

const std::vector<BlockGround>& shipped_block_grounds() {
    static const std::vector<BlockGround> grounds = [] {
        std::istringstream in{std::string{config::shipped_table("rigid_grounds.csv")}};
        const config::Table table = config::Table::read(in, "rigid_grounds.csv");
        config::Problems problems;
        std::vector<BlockGround> all;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            BlockGround ground;
            ground.name = table.text(row, "name");
            read_figures(table, row, ground, problems);
            all.push_back(std::move(ground));
        }
        problems.throw_if_any();
        return all;
    }();
    return grounds;
}

void read_block_ground(const config::Table& table, std::size_t row, BlockGround& ground,
                       config::Problems& problems) {
    if (has_value(table, row, "rigid_ground")) {
        const std::string& name = table.text(row, "rigid_ground");
        const std::vector<BlockGround>& shipped = shipped_block_grounds();
        const auto found = std::find_if(shipped.begin(), shipped.end(),
                                        [&](const BlockGround& of) { return of.name == name; });
        if (found != shipped.end()) {
            ground = *found;
        } else {
            std::vector<std::string> names;
            for (const BlockGround& of : shipped) {
                names.push_back(of.name);
            }
            const std::string nearest = config::nearest_word(name, names);
            problems.add(
                config::ExitCode::data, table.place(row, "rigid_ground"), config::in_quotes(name),
                "a class of `bannwald info rigid_grounds`" + (nearest.empty() ? "" : " (" + nearest + "?)"));
        }
    }
    read_figures(table, row, ground, problems);
}

}  // namespace coupling
