#include "coupling/assessments/stopping/stopping_table.hpp"

#include <algorithm>
#include <iostream>
#include <sstream>
#include <system_error>

#include "config/data/shipped_tables.hpp"
#include "coupling/assessments/stopping/pictures.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/run/interrupt.hpp"
#include "coupling/run/progress.hpp"

namespace coupling {

namespace {

namespace fs = std::filesystem;

constexpr const char* shipped_recipe = "stopping_recipe.csv";

/// A recipe and the hash of its version.
struct Recipe {
    std::string name;
    std::string hash;
    std::vector<SurfaceRecipe> surfaces;
};

Recipe recipe_from(const std::string& text, const std::string& name) {
    std::istringstream in{text};
    return {fs::path{name}.filename().string(), hash_text(text), read_recipe(config::Table::read(in, name))};
}

Recipe open_recipe(const fs::path& path) {
    if (path.empty()) {
        return recipe_from(std::string{config::shipped_table(shipped_recipe)}, shipped_recipe);
    }
    return recipe_from(std::string{open_file(path, {}, "a recipe (CSV)").text()}, path.string());
}

/// Keeps the surfaces that were named. Throws for a name that the recipe lacks.
void keep_named(Recipe& recipe, const std::vector<std::string>& names) {
    if (names.empty()) {
        return;
    }
    std::vector<std::string> known;
    for (const SurfaceRecipe& surface : recipe.surfaces) {
        known.push_back(surface.name);
    }
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            const std::string nearest = config::nearest_word(name, known);
            config::fail(config::ExitCode::settings, {}, "--surface " + config::in_quotes(name),
                         nearest.empty() ? "a name of " + recipe.name : config::in_quotes(nearest));
        }
    }
    std::erase_if(recipe.surfaces, [&](const SurfaceRecipe& surface) {
        return std::find(names.begin(), names.end(), surface.name) == names.end();
    });
}

/// Files that come to their places together, when all of them are whole.
class Drafts {
public:
    Drafts(fs::path folder, bool overwrite) : folder_{std::move(folder)}, overwrite_{overwrite} {}
    Drafts(const Drafts&) = delete;
    Drafts& operator=(const Drafts&) = delete;
    ~Drafts() {
        std::error_code ignored;
        for (const fs::path& file : drafts_) {
            fs::remove(draft_of(file), ignored);
        }
    }

    /// Throws where the file is there already and must stay.
    void expect(const fs::path& name) const {
        if (!overwrite_ && path_exists(folder_ / name)) {
            config::fail(config::ExitCode::settings, {(folder_ / name).string()}, "the file is there already",
                         "another folder by --out, or --overwrite to replace it");
        }
    }
    void write(const fs::path& name, const std::string& text) {
        const fs::path file = folder_ / name;
        make_folder(file.parent_path());
        drafts_.push_back(file);
        OutFile out{draft_of(file)};
        out.stream() << text;
        out.close();
    }
    void publish() {
        for (const fs::path& file : drafts_) {
            std::error_code error;
            fs::rename(draft_of(file), file, error);
            if (error) {
                config::fail(config::ExitCode::file, {file.string()},
                             "cannot be moved to its place: " + error.message());
            }
        }
        drafts_.clear();
    }

private:
    static fs::path draft_of(fs::path file) { return file += ".part"; }

    fs::path folder_;
    bool overwrite_;
    std::vector<fs::path> drafts_;
};

fs::path picture_name(const SurfaceRecipe& surface, const char* ending) {
    return fs::path{"pictures"} / (surface.name + ending);
}

/// What stands above the table: enough to make it again.
std::string made_by(const Recipe& recipe, const ThrowPlan& plan) {
    std::ostringstream text;
    text
        << "# Stopping probabilities of virtual surfaces (rockfall/virtual_surface), by `bannwald "
           "stopping-table`:\n"
        << "# recipe " << recipe.name << " (" << recipe.hash << "), seed " << plan.seed << ", "
        << plan.surfaces << " surfaces of each type,\n# " << plan.throws
        << " throws of each diameter at each surface. p_stop: chance that one ground impact stops the rock.\n"
        << "# rolling_stops_per_m: rate at which a rolling rock is caught. Standard errors are over surfaces "
           "and throws.\n";
    return text.str();
}

/// "cover 30.1 % by 612 blocks of 0.40-0.80 m, burial 0.38": the surface that is drawn, in words.
std::string description_of(const SurfaceRecipe& recipe, const rockfall::BlockCover& cover) {
    const auto diameters = std::minmax_element(
        cover.blocks().begin(), cover.blocks().end(),
        [](const rockfall::Block& a, const rockfall::Block& b) { return a.radius_m < b.radius_m; });
    std::string text = "cover " + report::fixed(100.0 * cover.cover(), 2) + " %";
    if (!cover.blocks().empty()) {
        text += " by " + std::to_string(cover.blocks().size()) + " blocks of " +
                report::fixed(2.0 * diameters.first->radius_m, 2) + "-" +
                report::fixed(2.0 * diameters.second->radius_m, 2) + " m";
    }
    text += ", burial";
    for (const rockfall::BlockKind& kind : recipe.kinds) {
        text += ' ' + config::to_text(kind.burial);
    }
    return text + ", on " + report::fixed(cover.side_m(), 0) + " m x " + report::fixed(cover.side_m(), 0) +
           " m";
}

void draw(const SurfaceRecipe& recipe, std::uint64_t seed, Drafts& drafts) {
    const rockfall::BlockCover cover =
        rockfall::lay_blocks(recipe.kinds, rockfall::patch_side_m(recipe.kinds), {seed, 0});
    std::ostringstream svg;
    write_surface_svg(cover, recipe.name, description_of(recipe, cover), svg);
    drafts.write(picture_name(recipe, ".svg"), svg.str());
    std::ostringstream ply;
    write_surface_ply(cover, ply);
    drafts.write(picture_name(recipe, ".ply"), ply.str());
}

/// Tells which surfaces could not be laid as densely as they should.
void warn_of_thin_covers(std::span<const SurfaceFigures> surfaces) {
    for (const SurfaceFigures& surface : surfaces) {
        double wanted = 0.0;
        for (const rockfall::BlockKind& kind : surface.recipe.kinds) {
            wanted += kind.cover;
        }
        if (surface.mean_cover < 0.98 * wanted && wanted > 0.1) {
            std::cerr << "bannwald: warning: " << surface.recipe.name << " has a cover of "
                      << report::fixed(surface.mean_cover, 3) << " instead of " << config::to_text(wanted)
                      << ": no place is left for more blocks\n";
        }
    }
}

}  // namespace

int make_stopping_table(const StoppingTableRequest& request, std::ostream& out) {
    Recipe recipe = open_recipe(request.recipe);
    keep_named(recipe, request.names);
    Drafts drafts{request.out, request.overwrite};
    drafts.expect("stopping.csv");
    for (const SurfaceRecipe& surface : recipe.surfaces) {
        if (request.pictures) {
            drafts.expect(picture_name(surface, ".svg"));
            drafts.expect(picture_name(surface, ".ply"));
        }
    }

    const InterruptGuard guard;
    Progress progress{"surfaces", recipe.surfaces.size() * request.plan.surfaces, 0, request.quiet};
    const std::vector<SurfaceFigures> figures = throw_at_surfaces(recipe.surfaces, request.plan, [&] {
        progress.add(1);
        return !InterruptGuard::requested();
    });
    progress.finish();
    if (figures.empty()) {
        std::cerr << "bannwald: interrupted; nothing was written\n";
        return static_cast<int>(config::ExitCode::interrupted);
    }

    std::ostringstream table;
    write_stopping_table(figures, made_by(recipe, request.plan), table);
    drafts.write("stopping.csv", table.str());
    for (const SurfaceRecipe& surface : recipe.surfaces) {
        if (request.pictures) {
            draw(surface, request.plan.seed, drafts);
        }
    }
    drafts.publish();
    warn_of_thin_covers(figures);
    if (!request.quiet) {
        write_overview(figures, out);
    }
    out << (request.out / "stopping.csv").string() << '\n';
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace coupling
