#include "coupling/assessments/stopping/stopping_recipe.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

namespace coupling {

namespace {

/// The patch has 24 m; a block that covers more of it than this is terrain.
constexpr config::NumberRange block_range{.low = 0.0, .high = 5.0, .low_excluded = true};
constexpr config::NumberRange code_range{.low = 0.0, .high = 1e6};

bool is_name(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80 || std::isalnum(byte) != 0 || c == '_' || c == '-';
    });
}

/// Reads a recipe row by row and collects what is wrong.
class RecipeReader {
public:
    explicit RecipeReader(const config::Table& table) : table_{table} {}

    std::vector<SurfaceRecipe> read() {
        table_.require({"name", "cover", "burial", "gathering"}, problems_);
        if (!table_.has("block_sizes_m")) {
            table_.require({"block_low_m", "block_high_m"}, problems_);
        }
        problems_.throw_if_any();
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            read_row(row);
        }
        if (recipes_.empty()) {
            problems_.add(config::ExitCode::data, {table_.file()}, "no surface", "at least one row");
        }
        problems_.throw_if_any();
        return std::move(recipes_);
    }

private:
    void read_row(std::size_t row) {
        const std::string& name = table_.text(row, "name");
        if (!is_name(name)) {
            refuse(row, "name", config::in_quotes(name), "letters, digits, _ and -");
            return;
        }
        const auto same = std::find_if(recipes_.begin(), recipes_.end(),
                                       [&](const SurfaceRecipe& recipe) { return recipe.name == name; });
        const bool is_new = same == recipes_.end();
        SurfaceRecipe& recipe = is_new ? recipes_.emplace_back(SurfaceRecipe{name, {}, {}}) : *same;
        read_code(row, recipe, is_new);
        recipe.kinds.push_back(kind_of(row));
        double cover = 0.0;
        for (const rockfall::BlockKind& kind : recipe.kinds) {
            cover += kind.cover;
        }
        if (recipe.kinds.size() > 1 && cover > rockfall::largest_cover) {
            refuse(row, "cover", "a cover of " + config::to_text(cover) + " by all rows of " + name,
                   "at most " + config::to_text(rockfall::largest_cover));
        }
    }

    void read_code(std::size_t row, SurfaceRecipe& recipe, bool is_new) {
        if (!table_.has("code")) {
            return;
        }
        const auto found = table_.whole(row, "code", code_range, problems_);
        if (!found) {
            return;
        }
        const int code = static_cast<int>(*found);
        if (!is_new && recipe.code && recipe.code != code) {
            refuse(row, "code", "code " + std::to_string(code) + " for " + recipe.name,
                   "code " + std::to_string(*recipe.code) + " as before");
        }
        for (const SurfaceRecipe& other : recipes_) {
            if (&other != &recipe && other.code == code) {
                refuse(row, "code", "code " + std::to_string(code) + " of " + other.name, "another code");
            }
        }
        recipe.code = code;
    }

    rockfall::BlockKind kind_of(std::size_t row) {
        rockfall::BlockKind kind;
        if (table_.has("block_sizes_m") && !table_.text(row, "block_sizes_m").empty()) {
            kind.observed_m = sizes_of(row);
        } else if (table_.has("block_low_m") && table_.has("block_high_m")) {
            kind.low_m = number(row, "block_low_m", block_range);
            kind.high_m = number(row, "block_high_m", block_range);
            if (kind.high_m < kind.low_m) {
                refuse(row, "block_high_m", "block_high_m " + table_.text(row, "block_high_m"),
                       "at least block_low_m, " + table_.text(row, "block_low_m"));
            }
        } else {
            refuse(row, "block_sizes_m", "no block sizes", "diameters separated by blanks");
        }
        kind.cover = number(row, "cover", {.low = 0.0, .high = rockfall::largest_cover});
        kind.burial = number(row, "burial", {.low = 0.0, .high = 0.5});
        kind.gathering = number(row, "gathering", {.low = 0.0, .high = 1.0});
        return kind;
    }

    std::vector<double> sizes_of(std::size_t row) {
        std::istringstream words{table_.text(row, "block_sizes_m")};
        std::vector<double> sizes_m;
        for (std::string word; words >> word;) {
            const auto size_m = config::parse_number(word);
            if (size_m && block_range.contains(*size_m)) {
                sizes_m.push_back(*size_m);
            } else {
                refuse(row, "block_sizes_m", "block size " + config::in_quotes(word),
                       config::describe("a number", block_range));
            }
        }
        return sizes_m;
    }

    double number(std::size_t row, const std::string& column, const config::NumberRange& range) {
        return table_.number(row, column, range, problems_).value_or(0.0);
    }
    void refuse(std::size_t row, const std::string& column, std::string found, std::string expected) {
        problems_.add(config::ExitCode::data, table_.place(row, column), std::move(found),
                      std::move(expected));
    }

    const config::Table& table_;
    config::Problems problems_;
    std::vector<SurfaceRecipe> recipes_;
};

}  // namespace

std::vector<SurfaceRecipe> read_recipe(const config::Table& table) {
    return RecipeReader{table}.read();
}

}  // namespace coupling
