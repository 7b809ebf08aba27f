#include "coupling/assessments/stopping/stopping_recipe.hpp"

#include <algorithm>
#include <cctype>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace coupling {

struct RecipeRow : rockfall::BlockKind {
    std::string name;
    std::optional<int> code;
};

namespace {

using config::joined;

bool is_name(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80 || std::isalnum(byte) != 0 || c == '_' || c == '-';
    });
}

void check_code(const config::Read<RecipeRow>& row, const std::vector<SurfaceRecipe>& before, bool has_codes,
                config::RowProblems& wrong) {
    if (has_codes && !row.code) {
        wrong.refuse(row.row, "code", "no code", "a code in each row, or none at all");
    }
    for (const SurfaceRecipe& surface : before) {
        const bool is_same = surface.name == row.name;
        if (row.code && surface.code && is_same != (surface.code == row.code)) {
            wrong.refuse(row.row, "code",
                         joined("code ", std::to_string(*row.code), is_same ? " for " : " of ", surface.name),
                         is_same ? joined("code ", std::to_string(*surface.code), " as before")
                                 : std::string{"another code"});
        }
    }
}

void check_sizes(const config::Table& table, const config::Read<RecipeRow>& row, config::RowProblems& wrong) {
    if (!row.observed_m.empty()) {
        return;
    }
    if (!has_value(table, row.row, "block_low_m") || !has_value(table, row.row, "block_high_m")) {
        wrong.refuse(row.row, "block_sizes_m", "no block sizes", "diameters separated by blanks");
    } else if (row.high_m < row.low_m) {
        wrong.refuse(row.row, "block_high_m", joined("block_high_m ", config::to_text(row.high_m)),
                     joined("at least block_low_m, ", config::to_text(row.low_m)));
    }
}

void check_cover(const SurfaceRecipe& surface, std::size_t row, config::RowProblems& wrong) {
    double cover = 0.0;
    for (const rockfall::BlockKind& kind : surface.kinds) {
        cover += kind.cover;
    }
    if (cover > rockfall::largest_cover) {
        wrong.refuse(row, "cover",
                     joined("a cover of ", config::to_text(cover), " by all rows of ", surface.name),
                     joined("at most ", config::to_text(rockfall::largest_cover)));
    }
}

}  // namespace

const config::Schema<RecipeRow>& recipe_columns() {
    using R = RecipeRow;
    using config::above;
    // The patch has 24 m; a block that covers more of it than 5 m is terrain.
    // clang-format off
    static const config::Schema<R> columns{
        {.setting = "stopping-table", .row = "kind of blocks", .no_rows = "at least one row"},
        {{"name", &R::name, "of the surface: letters, digits, _ and -; its rows are laid in their order"},
         {"code", &R::code, "in the map of ground types, the same in all rows of a name", {.range = {0.0, 1e6}}},
         {"block_low_m", &R::low_m, "smallest diameter", {.range = {0.0, 5.0, above}, .optional = true}},
         {"block_high_m", &R::high_m, "largest diameter", {.range = {0.0, 5.0, above}, .optional = true}},
         {"block_sizes_m", &R::observed_m, "instead: observed diameters", {.range = {0.0, 5.0, above}, .optional = true}},
         {"cover", &R::cover, "share of the ground under these blocks", {.unit = "-", .range = {0.0, rockfall::largest_cover}}},
         {"burial", &R::burial, "share of the diameter below the ground", {.unit = "-", .range = {0.0, 0.5}}},
         {"gathering", &R::gathering, "probability that a block lies at another one", {.unit = "-", .range = {0.0, 1.0}}}}};
    // clang-format on
    return columns;
}

std::vector<SurfaceRecipe> read_recipe(const config::Table& table) {
    config::RowProblems wrong{table};
    if (!table.has("block_sizes_m")) {
        table.require({"block_low_m", "block_high_m"}, wrong);
        wrong.throw_first();
    }
    std::vector<SurfaceRecipe> surfaces;
    for (const config::Read<RecipeRow>& row : recipe_columns().rows(table, wrong)) {
        if (!is_name(row.name)) {
            wrong.refuse(row.row, "name", config::in_quotes(row.name), "letters, digits, _ and -");
        }
        check_code(row, surfaces, table.has("code"), wrong);
        check_sizes(table, row, wrong);
        auto surface = std::find_if(surfaces.begin(), surfaces.end(),
                                    [&](const SurfaceRecipe& each) { return each.name == row.name; });
        if (surface == surfaces.end()) {
            surface = surfaces.insert(surface, {row.name, row.code, {}});
        }
        surface->kinds.push_back(row);
        check_cover(*surface, row.row, wrong);
    }
    wrong.throw_first();
    return surfaces;
}

}  // namespace coupling
