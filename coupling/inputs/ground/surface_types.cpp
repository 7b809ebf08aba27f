#include "coupling/inputs/ground/surface_types.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/ground/ground_soils.hpp"
#include "coupling/inputs/ground/stopping_input.hpp"
#include "coupling/inputs/plausible/odd_grounds.hpp"
#include "coupling/inputs/reading/passed_over_columns.hpp"
#include "coupling/inputs/scenario/block_grounds.hpp"
#include "coupling/inputs/scenario/ground_changes.hpp"

namespace coupling {

namespace {

using config::joined;

constexpr config::NumberRange code_range{.low = 0.0, .high = 1e6};
constexpr std::size_t most_types = 255;  // the map keeps a byte for each cell, 255 for none

config::Table shipped(const std::string& name) {
    std::istringstream in{std::string{config::shipped_table(name)}};
    return config::Table::read(in, name);
}

std::vector<std::string> names_of(const std::vector<ShippedSurface>& surfaces) {
    std::vector<std::string> names;
    for (const ShippedSurface& surface : surfaces) {
        names.push_back(surface.name);
    }
    return names;
}

/// Reads the table of ground types row by row.
class TypeReader {
public:
    TypeReader(const config::Table& table, std::map<std::string, StoppingCurves> stopping,
               std::vector<rockfall::Soil> soils, const rockfall::ModelDescription& model,
               const config::Options& settings, config::Problems& problems)
        : table_{table},
          stopping_{std::move(stopping)},
          soils_{std::move(soils)},
          model_{model},
          shipped_{shipped_surfaces(settings)},
          changes_{settings, names_of(shipped_)},
          problems_{problems} {}

    /// Of the codes in [ground.CODE] that no row has, the places.
    [[nodiscard]] std::vector<config::Place> unused_changes(
        const std::vector<rockfall::SurfaceType>& types) const {
        std::vector<std::string> names = names_of(shipped_);
        for (const rockfall::SurfaceType& type : types) {
            names.push_back(std::to_string(type.code));
        }
        return changes_.of_others_than(names);
    }

    std::vector<rockfall::SurfaceType> all() {
        std::vector<rockfall::SurfaceType> types;
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            const rockfall::SurfaceType type = read(row);
            if (type.code >= 0 &&
                std::any_of(types.begin(), types.end(), [&](const auto& t) { return t.code == type.code; })) {
                refuse(row, "code", "code " + table_.text(row, "code") + " a second time", "each code once",
                       "delete one of the rows, or give it a code of its own");
            }
            types.push_back(type);
        }
        return types;
    }

    /// Codes of the stopping table that no row has.
    [[nodiscard]] std::vector<std::string> unused_stopping(
        const std::vector<rockfall::SurfaceType>& types) const {
        std::vector<std::string> unused;
        for (const auto& [code, curves] : stopping_) {
            if (std::none_of(types.begin(), types.end(),
                             [&](const auto& t) { return std::to_string(t.code) == code; })) {
                unused.push_back(code);
            }
        }
        return unused;
    }

private:
    rockfall::SurfaceType read(std::size_t row) {
        rockfall::SurfaceType type;
        const ShippedSurface* like = like_of(row);
        type.code = static_cast<int>(table_.whole(row, "code", code_range, problems_).value_or(-1));
        type.label = has_value(table_, row, "label") ? table_.text(row, "label")
                     : like != nullptr               ? like->type.label
                                                     : "surface " + std::to_string(type.code);
        type.restitution.normal =
            value(row, "r_n", restitution_range, like ? &like->type.restitution.normal : nullptr);
        type.restitution.tangential =
            value(row, "r_t", restitution_range, like ? &like->type.restitution.tangential : nullptr);
        if (like != nullptr && !has_value(table_, row, "r_n") && !has_value(table_, row, "r_t")) {
            type.published = like->type.published;
        }
        const double usual_angle = like ? like->type.jump_angle_factor : 1.0;
        type.jump_angle_factor = value(row, "jump_angle_factor", angle_factor_range, &usual_angle);
        const double no_friction = like ? like->type.rolling_friction : 0.0;
        type.rolling_friction = value(row, "rolling_friction", rolling_friction_range, &no_friction);
        const double no_sliding = like ? like->type.sliding_friction : 0.0;
        type.sliding_friction = value(row, "sliding_friction", sliding_friction_range, &no_sliding);
        read_stopping(row, like, type);
        type.soil = soil_of(row, like, type);
        read_rigid(row, like, type);
        changes_.apply(std::to_string(type.code), type);
        return type;
    }

    /// Figures of blocks with a shape: those of the ground class that the row names, else of the shipped
    /// type, and what its columns say.
    void read_rigid(std::size_t row, const ShippedSurface* like, rockfall::SurfaceType& type) {
        if (like != nullptr) {
            type.block = like->type.block;
        }
        read_block_ground(table_, row, type.block, problems_);
    }

    /// The soil that the row names, else that of the shipped type.
    std::optional<rockfall::Soil> soil_of(std::size_t row, const ShippedSurface* like,
                                          const rockfall::SurfaceType& type) {
        if (has_value(table_, row, "soil")) {
            return named_soil(table_, row, "soil", soils_, problems_);
        }
        if (like != nullptr) {
            return like->type.soil;
        }
        if (model_.needs_soils) {
            refuse(row, table_.has("soil") ? "soil" : "code",
                   "code " + table_.text(row, "code") + " without soil",
                   joined("a soil in a column soil, as rockfall.motion = ", model_.name, " needs it"),
                   joined("write soil = ", nearest_soil(type.as_published(), soils_)->name,
                          " (nearest in r_n and r_t), or another name of `bannwald info pir3d_soils` or of "
                          "terrain.soils"));
        }
        return std::nullopt;
    }

    /// Probabilities from the stopping table, else scaled from p_stop, else those of the shipped type; rates
    /// likewise.
    void read_stopping(std::size_t row, const ShippedSurface* like, rockfall::SurfaceType& type) {
        const auto curves = stopping_.find(std::to_string(type.code));
        const bool has_curves = curves != stopping_.end();
        if (has_curves) {
            type.stopping = curves->second.stopping;
        } else if (like != nullptr && !has_value(table_, row, "p_stop")) {
            type.stopping = like->type.stopping;
        } else {
            type.stopping = stop_curve(value(row, "p_stop", probability_range, nullptr));
        }
        if (has_curves && curves->second.has_rolling) {
            type.rolling_stops_per_m = curves->second.rolling_stops_per_m;
        } else if (has_value(table_, row, "rolling_stops_per_m")) {
            const double rate = value(row, "rolling_stops_per_m", rolling_stops_range, nullptr);
            type.rolling_stops_per_m = rockfall::StopCurve{{{1.0, rate}}};
        } else if (like != nullptr) {
            type.rolling_stops_per_m = like->type.rolling_stops_per_m;
        }
    }

    const ShippedSurface* like_of(std::size_t row) {
        if (!has_value(table_, row, "like")) {
            return nullptr;
        }
        const std::string& name = table_.text(row, "like");
        const auto found = std::find_if(shipped_.begin(), shipped_.end(),
                                        [&](const ShippedSurface& surface) { return surface.name == name; });
        if (found != shipped_.end()) {
            return &*found;
        }
        const std::string nearest = config::nearest_word(name, names_of(shipped_));
        refuse(row, "like", config::in_quotes(name),
               "a shipped ground type" + (nearest.empty() ? "" : " (" + nearest + "?)"),
               "`bannwald info surfaces` prints them");
        return nullptr;
    }

    /// A number of the row, else the fallback, else a problem.
    double value(std::size_t row, const std::string& column, const config::NumberRange& range,
                 const double* fallback) {
        if (fallback != nullptr && !has_value(table_, row, column)) {
            return *fallback;
        }
        if (!table_.has(column)) {
            refuse(row, "code", "code " + table_.text(row, "code") + " without " + column,
                   "a column " + column,
                   "add it, or name a shipped ground type in a column like (`bannwald info surfaces`)");
            return 0.0;
        }
        return table_.number(row, column, range, problems_).value_or(0.0);
    }

    void refuse(std::size_t row, const std::string& column, std::string found, std::string expected,
                std::string advice) {
        problems_.add(config::ExitCode::data, table_.place(row, column), std::move(found),
                      std::move(expected), std::move(advice));
    }

    const config::Table& table_;
    std::map<std::string, StoppingCurves> stopping_;
    std::vector<rockfall::Soil> soils_;
    const rockfall::ModelDescription& model_;
    std::vector<ShippedSurface> shipped_;
    GroundChanges changes_;
    config::Problems& problems_;
};

/// Beyond its first and last diameter a stopping table holds its end values, which may be far off.
void doubt_sizes_beyond(const std::map<std::string, StoppingCurves>& stopping,
                        const rockfall::DiameterRange& rocks, Reading& reading) {
    const auto [smallest_m, largest_m, mean_m] = rocks;
    for (const auto& [code, curves] : stopping) {
        if (smallest_m < curves.smallest_m || largest_m > curves.largest_m) {
            reading.warn({reading.shown(reading.scenario().stopping)},
                         "diameters of " + config::to_text(curves.smallest_m) + " to " +
                             config::to_text(curves.largest_m) + " m for code " + code,
                         "those of the rocks, " + config::to_text(smallest_m) + " to " +
                             config::to_text(largest_m) + " m: beyond its ends a table keeps its last value");
        }
    }
}

/// Without a table of ground types there are no codes that a setting could change.
void refuse_codes(const config::Options& settings) {
    const std::vector<std::string> names = names_of(shipped_surfaces());
    config::Problems problems;
    for (const config::Place& place : GroundChanges{settings, names}.of_others_than(names)) {
        problems.add(config::ExitCode::settings, place, "a code without terrain.surface_types",
                     "a name of `bannwald info surfaces`");
    }
    problems.throw_if_any();
}

std::vector<rockfall::SurfaceType> read_type_table(const rockfall::DiameterRange& rocks, Reading& reading) {
    config::Problems problems;
    std::map<std::string, StoppingCurves> stopping;
    if (const std::string& file = reading.scenario().stopping; !file.empty()) {
        const auto curves = reading.attempt([&] {
            return read_stopping_curves(reading.table("terrain.stopping", "stopping", file), "code",
                                        problems);
        });
        stopping = curves.value_or(stopping);
    }
    const config::Table table =
        reading.table("terrain.surface_types", "surface_types", reading.scenario().surface_types);
    table.require({"code"}, problems);
    problems.throw_if_any();

    std::vector<std::string> known{"code",
                                   "label",
                                   "r_n",
                                   "r_t",
                                   "jump_angle_factor",
                                   "p_stop",
                                   "like",
                                   "soil",
                                   "rolling_stops_per_m",
                                   "rolling_friction",
                                   "sliding_friction"};
    for (std::string& column : block_ground_columns()) {
        known.push_back(std::move(column));
    }
    warn_of_columns(table, known, reading);
    const std::map<std::string, StoppingCurves> stopping_kept = stopping;
    const rockfall::ModelDescription& model =
        rockfall::description_of(reading.scenario().rockfall.fall.motion.model);
    TypeReader reader{table, std::move(stopping),         read_ground_soils(reading),
                      model, *reading.scenario().options, problems};
    std::vector<rockfall::SurfaceType> types = reader.all();
    for (const config::Place& place : reader.unused_changes(types)) {
        problems.add(config::ExitCode::settings, place, "a code without a row", "a code of " + table.file());
    }
    if (types.empty() || types.size() >= most_types) {
        problems.add(config::ExitCode::data, {table.file()}, counted(types.size(), "ground type"), "1 to 254",
                     "give each ground of the map a row, and similar grounds one code");
    }
    config::Problems shown;
    add_first(shown, problems, table.file());
    shown.throw_if_any();
    for (const std::string& code : reader.unused_stopping(types)) {
        reading.warn({reading.shown(reading.scenario().stopping)}, "code " + code, "codes of " + table.file(),
                     "", config::Effect::detail);
    }
    doubt_sizes_beyond(stopping_kept, rocks, reading);
    plausible::judge_restitutions(types, table.file(), reading);
    return types;
}

}  // namespace

std::vector<ShippedSurface> shipped_surfaces() {
    config::Problems problems;
    const config::Table table = shipped("surfaces.csv");
    const auto curves = read_stopping_curves(shipped("stopping.csv"), "name", problems);
    const std::vector<rockfall::Soil> soils = shipped_ground_soils();
    std::vector<ShippedSurface> surfaces;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        ShippedSurface surface;
        surface.name = table.text(row, "name");
        surface.type.label = table.text(row, "label");
        const double r_n = table.number(row, "r_n", restitution_range, problems).value_or(0.0);
        const auto restitution = [&](const char* r_t) {
            return rockfall::Restitution{r_n,
                                         table.number(row, r_t, restitution_range, problems).value_or(0.0)};
        };
        surface.type.restitution = restitution("r_t");
        surface.type.published = restitution("r_t_published");
        surface.type.jump_angle_factor =
            table.number(row, "jump_angle_factor", angle_factor_range, problems).value_or(1.0);
        surface.type.stopping = curves.at(surface.name).stopping;
        surface.type.rolling_stops_per_m = curves.at(surface.name).rolling_stops_per_m;
        surface.type.sliding_friction =
            table.number(row, "sliding_friction", sliding_friction_range, problems).value_or(0.0);
        surface.type.soil = named_soil(table, row, "soil", soils, problems);
        read_block_ground(table, row, surface.type.block, problems);
        surfaces.push_back(std::move(surface));
    }
    problems.throw_if_any();
    return surfaces;
}

std::vector<ShippedSurface> shipped_surfaces(const config::Options& settings) {
    std::vector<ShippedSurface> surfaces = shipped_surfaces();
    const GroundChanges changes{settings, names_of(surfaces)};
    for (ShippedSurface& surface : surfaces) {
        changes.apply(surface.name, surface.type);
    }
    return surfaces;
}

std::optional<std::vector<rockfall::SurfaceType>> read_surface_types(const rockfall::DiameterRange& rocks,
                                                                     Reading& reading) {
    if (reading.scenario().surface_types.empty()) {
        return reading.attempt([&] {
            refuse_codes(*reading.scenario().options);
            return std::vector<rockfall::SurfaceType>{};
        });
    }
    return reading.attempt([&] { return read_type_table(rocks, reading); });
}

std::optional<rockfall::SurfaceType> uniform_ground(const Scenario& scenario) {
    if (scenario.ground.empty()) {
        return std::nullopt;
    }
    const std::vector<ShippedSurface> shipped = shipped_surfaces(*scenario.options);
    const auto found = std::find_if(shipped.begin(), shipped.end(), [&](const ShippedSurface& surface) {
        return surface.name == scenario.ground;
    });
    if (found != shipped.end()) {
        return found->type;
    }
    const std::string nearest = config::nearest_word(scenario.ground, names_of(shipped));
    config::fail(config::ExitCode::settings, scenario.options->place_of("terrain.ground"),
                 "terrain.ground " + config::in_quotes(scenario.ground),
                 nearest.empty() ? "a name of `bannwald info surfaces`" : config::in_quotes(nearest));
}

}  // namespace coupling
