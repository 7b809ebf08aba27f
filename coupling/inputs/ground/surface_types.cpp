#include "coupling/inputs/ground/surface_types.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "config/data/shipped_tables.hpp"
#include "config/text/coordinates.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/ground/ground_soils.hpp"
#include "coupling/inputs/ground/stopping_input.hpp"
#include "coupling/inputs/plausible/odd_grounds.hpp"
#include "coupling/inputs/reading/declared_tables.hpp"
#include "coupling/inputs/scenario/block_grounds.hpp"
#include "coupling/inputs/scenario/ground_changes.hpp"
#include "coupling/inputs/scenario/terrain_settings.hpp"
#include "rockfall/parameters.hpp"

namespace coupling {

struct SurfaceTypeRow {
    int code = -1;
    std::string label, like, soil, rigid_ground;
    std::optional<rockfall::FrictionLaw> friction_law;
    std::map<std::string, std::optional<double>> figures;  ///< by column

    [[nodiscard]] std::optional<double> figure(const std::string& column) const {
        const auto found = figures.find(column);
        return found == figures.end() ? std::nullopt : found->second;
    }
};

namespace {

using config::joined;

constexpr std::size_t most_types = 255;  // the map keeps a byte for each cell, 255 for none

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
               const config::Options& settings, config::RowProblems& wrong)
        : table_{table},
          stopping_{std::move(stopping)},
          soils_{std::move(soils)},
          model_{model},
          shipped_{shipped_surfaces(settings)},
          changes_{settings, names_of(shipped_)},
          wrong_{wrong} {}

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
        for (const config::Read<SurfaceTypeRow>& row : surface_type_columns().rows(table_, wrong_)) {
            types.push_back(type_of(row));
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
    using Row = config::Read<SurfaceTypeRow>;

    rockfall::SurfaceType type_of(const Row& row) {
        const ShippedSurface* like = like_of(row);
        rockfall::SurfaceType type = like != nullptr ? like->type : rockfall::SurfaceType{};
        type.code = row.code;
        type.label = !row.label.empty() ? row.label
                     : like != nullptr  ? like->type.label
                                        : "surface " + std::to_string(type.code);
        if (row.figure("r_n") || row.figure("r_t")) {
            type.published.reset();
        }
        if (!row.rigid_ground.empty() || like == nullptr) {
            const std::string name = row.rigid_ground.empty() ? "hard" : row.rigid_ground;
            const config::Place place =
                table_.has("rigid_ground") ? table_.place(row.row, "rigid_ground") : config::Place{};
            const auto* found = block_class(name, place, wrong_);
            type.block = found != nullptr ? *found : type.block;
        }
        type.block.law = row.friction_law.value_or(type.block.law);
        const auto curves = stopping_.find(std::to_string(type.code));
        for (const GroundFigure& figure : ground_figures()) {
            if (const auto value = row.figure(figure.name)) {
                figure.set(type, *value);
            } else if (like == nullptr && (figure.name == "r_n" || figure.name == "r_t" ||
                                           (figure.name == "p_stop" && curves == stopping_.end()))) {
                refuse_missing(row, figure);
            }
        }
        if (type.block.law == rockfall::FrictionLaw::slip && type.block.friction_max < type.block.friction) {
            wrong_.refuse(row.row, table_.has("friction_max") ? "friction_max" : "friction",
                          "friction_max below friction", "friction that grows with the slip");
        }
        if (curves != stopping_.end()) {
            type.stopping = curves->second.stopping;
            type.rolling_stops_per_m =
                curves->second.has_rolling ? curves->second.rolling_stops_per_m : type.rolling_stops_per_m;
        }
        type.soil = soil_of(row, like, type);
        changes_.apply(std::to_string(type.code), type);
        return type;
    }

    void refuse_missing(const Row& row, const GroundFigure& figure) {
        if (table_.has(figure.name)) {
            table_.number(row.row, figure.name, figure.range, wrong_);  // it is empty
            return;
        }
        wrong_.refuse(row.row, "code", joined("code ", std::to_string(row.code), " without ", figure.name),
                      "a column " + figure.name,
                      "add it, or name a shipped ground type in a column like (`bannwald info surfaces`)");
    }

    /// The soil that the row names, else that of the shipped type.
    std::optional<rockfall::Soil> soil_of(const Row& row, const ShippedSurface* like,
                                          const rockfall::SurfaceType& type) {
        if (!row.soil.empty()) {
            return named_soil(table_, row.row, "soil", soils_, wrong_);
        }
        if (like != nullptr) {
            return like->type.soil;
        }
        if (model_.needs_soils) {
            wrong_.refuse(row.row, table_.has("soil") ? "soil" : "code",
                          joined("code ", std::to_string(row.code), " without soil"),
                          joined("a soil in a column soil, as rockfall.motion = ", model_.name, " needs it"),
                          joined("write soil = ", nearest_soil(type.as_published(), soils_)->name,
                                 " (nearest in r_n and r_t), or another name of `bannwald info pir3d_soils` "
                                 "or of terrain.soils"));
        }
        return std::nullopt;
    }

    const ShippedSurface* like_of(const Row& row) {
        if (row.like.empty()) {
            return nullptr;
        }
        const auto found = std::find_if(shipped_.begin(), shipped_.end(), [&](const ShippedSurface& surface) {
            return surface.name == row.like;
        });
        if (found != shipped_.end()) {
            return &*found;
        }
        const std::string nearest = config::nearest_word(row.like, names_of(shipped_));
        wrong_.refuse(row.row, "like", config::in_quotes(row.like),
                      "a shipped ground type" + (nearest.empty() ? "" : " (" + nearest + "?)"),
                      "`bannwald info surfaces` prints them");
        return nullptr;
    }

    const config::Table& table_;
    std::map<std::string, StoppingCurves> stopping_;
    std::vector<rockfall::Soil> soils_;
    const rockfall::ModelDescription& model_;
    std::vector<ShippedSurface> shipped_;
    GroundChanges changes_;
    config::RowProblems& wrong_;
};

/// Beyond its first and last diameter a stopping table holds its end values, which may be far off.
void doubt_sizes_beyond(const std::map<std::string, StoppingCurves>& stopping,
                        const rockfall::DiameterRange& rocks, Reading& reading) {
    const auto [smallest_m, largest_m, mean_m] = rocks;
    for (const auto& [code, curves] : stopping) {
        if (smallest_m < curves.smallest_m || largest_m > curves.largest_m) {
            reading.warn({reading.shown(reading.terrain().stopping)},
                         "diameters of " + config::to_text(curves.smallest_m) + " to " +
                             config::to_text(curves.largest_m) + " m for code " + code,
                         "those of the rocks, " + config::metres_in_words(smallest_m) + " to " +
                             config::metres_in_words(largest_m) +
                             " m: beyond its ends a table keeps its last value");
        }
    }
}

/// Without a table of ground types there are no codes that a setting could change.
void refuse_codes(const config::Options& settings) {
    const std::vector<std::string> names = names_of(shipped_surfaces());
    const GroundChanges changes{settings, names};
    config::Problems problems;
    for (const config::Place& place : changes.of_others_than(names)) {
        problems.add(config::ExitCode::settings, place, "a code without terrain.surface_types",
                     "a name of `bannwald info surfaces`");
    }
    problems.throw_if_any();
}

std::vector<rockfall::SurfaceType> read_type_table(const rockfall::DiameterRange& rocks, Reading& reading) {
    std::map<std::string, StoppingCurves> stopping;
    config::Problems of_stopping;
    if (const std::string& file = reading.terrain().stopping; !file.empty()) {
        const auto curves = reading.attempt([&] {
            return read_stopping_curves(table_of(stopping_columns(true), file, reading), "code", of_stopping);
        });
        stopping = curves.value_or(stopping);
    }
    for (const config::Problem& problem : of_stopping.list()) {
        reading.problems().add(problem);
    }
    const config::Table table = table_of(surface_type_columns(), reading.terrain().surface_types, reading);
    config::RowProblems wrong{table};
    const std::map<std::string, StoppingCurves> stopping_kept = stopping;
    const rockfall::ModelDescription& model = rockfall::description_of(reading.rockfall().fall.motion.model);
    TypeReader reader{table, std::move(stopping),         read_ground_soils(reading),
                      model, *reading.settings().options, wrong};
    std::vector<rockfall::SurfaceType> types = reader.all();
    if (types.size() == table.rows()) {
        for (const config::Place& place : reader.unused_changes(types)) {
            wrong.add(config::ExitCode::settings, place, "a code without a row", "a code of " + table.file());
        }
    }
    if (table.rows() == 0 || table.rows() >= most_types) {
        wrong.refuse(counted(table.rows(), "ground type"), "1 to 254",
                     "give each ground of the map a row, and similar grounds one code");
    }
    wrong.throw_first();
    for (const std::string& code : reader.unused_stopping(types)) {
        reading.warn({reading.shown(reading.terrain().stopping)}, "code " + code, "codes of " + table.file(),
                     "", config::Effect::detail);
    }
    doubt_sizes_beyond(stopping_kept, rocks, reading);
    plausible::judge_restitutions(types, table.file(), reading);
    return types;
}

}  // namespace

const config::Schema<SurfaceTypeRow>& surface_type_columns() {
    static const config::Schema<SurfaceTypeRow> columns = [] {
        using R = SurfaceTypeRow;
        // clang-format off
        std::vector<config::ColumnOf<R>> all{
            {"code", &R::code, "as on the map", {.range = {0.0, 1e6}, .unique = true, .advice = "delete one of the rows, or give it a code of its own"}},
            {"label", &R::label, "on pages", {.optional = true}},
            {"like", &R::like, "a shipped ground type, for what the row leaves out", {.optional = true}},
            {"soil", &R::soil, "for motion models that take the ground from soils", {.optional = true}},
            {"rigid_ground", &R::rigid_ground, "class of `bannwald info rigid_grounds`, for rocks with a shape", {.optional = true}},
            {"friction_law", &R::friction_law, "of blocks with a shape", {.words = friction_laws()}}};
        // clang-format on
        const auto figure_called = [](const std::string& name) {
            return [name](R& row) -> std::optional<double>& { return row.figures[name]; };
        };
        for (const GroundFigure& figure : ground_figures()) {
            const char* unit = figure.name.starts_with("r_") ? "-" : "";  // r_t is no mass in tonnes
            all.push_back({figure.name,
                           figure_called(figure.name),
                           figure.meaning,
                           {.unit = unit, .range = figure.range}});
        }
        return config::Schema<R>{
            {.role = "surface_types", .setting = "terrain.surface_types", .row = "ground type"},
            std::move(all)};
    }();
    return columns;
}

std::vector<ShippedSurface> shipped_surfaces() {
    config::Problems problems;
    const config::Table table = config::read_shipped_table("surfaces.csv");
    const auto curves = read_stopping_curves(config::read_shipped_table("stopping.csv"), "name", problems);
    const std::vector<rockfall::Soil> soils = shipped_ground_soils();
    std::vector<ShippedSurface> surfaces;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        ShippedSurface surface;
        surface.name = table.text(row, "name");
        surface.type.label = table.text(row, "label");
        surface.type.like = surface.name;
        for (const GroundFigure& figure : ground_figures()) {
            if (table.has(figure.name) && !table.text(row, figure.name).empty()) {
                figure.set(surface.type,
                           table.number(row, figure.name, figure.range, problems).value_or(1.0));
            }
        }
        surface.type.published = surface.type.restitution;
        surface.type.published->tangential =
            table.number(row, "r_t_published", {0.0, 1.0}, problems).value_or(0.0);
        surface.type.stopping = curves.at(surface.name).stopping;
        surface.type.rolling_stops_per_m = curves.at(surface.name).rolling_stops_per_m;
        surface.type.soil = named_soil(table, row, "soil", soils, problems);
        const auto* const of_blocks =
            block_class(table.text(row, "rigid_ground"), table.place(row, "rigid_ground"), problems);
        problems.throw_if_any();
        surface.type.block = *of_blocks;
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
    if (reading.terrain().surface_types.empty()) {
        return reading.attempt([&] {
            refuse_codes(*reading.settings().options);
            return std::vector<rockfall::SurfaceType>{};
        });
    }
    return reading.attempt([&] { return read_type_table(rocks, reading); });
}

std::optional<rockfall::SurfaceType> uniform_ground(const Reading& reading) {
    const std::string& name = reading.terrain().ground;
    if (name.empty()) {
        return std::nullopt;
    }
    const std::vector<ShippedSurface> shipped = shipped_surfaces(*reading.settings().options);
    const auto found = std::find_if(shipped.begin(), shipped.end(),
                                    [&](const ShippedSurface& surface) { return surface.name == name; });
    if (found != shipped.end()) {
        return found->type;
    }
    const std::string nearest = config::nearest_word(name, names_of(shipped));
    config::fail(config::ExitCode::settings, reading.settings().options->place_of("terrain.ground"),
                 "terrain.ground " + config::in_quotes(name),
                 nearest.empty() ? "a name of `bannwald info surfaces`" : config::in_quotes(nearest));
}

}  // namespace coupling
