#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/errors/warnings.hpp"
#include "config/grid/raster.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/grids/tiles.hpp"
#include "coupling/inputs/reading/input_file.hpp"
#include "coupling/inputs/scenario/scenario_file.hpp"
#include "coupling/inputs/tables/prepare.hpp"
#include "coupling/inputs/tables/words.hpp"

namespace rockfall {
struct Parameters;
}

namespace coupling {

struct ForestSettings;
struct HazardSettings;
struct NetSettings;
struct WorkSettings;
struct ObservedSettings;
struct OutputSettings;
struct ProfileSettings;
struct ReleaseSettings;
struct RunSettings;
struct Scenario;
struct TargetSettings;
struct TerrainSettings;
struct TreeSettings;

/// What the readers of a site share: the scenario, what is wrong, what is doubtful, which files were opened.
class Reading {
public:
    Reading(const Scenario& scenario, config::Warnings& warnings);

    /// Sections of the scenario: a reader includes those that it uses.
    [[nodiscard]] const RunSettings& run() const;
    [[nodiscard]] const TerrainSettings& terrain() const;
    [[nodiscard]] const ProfileSettings& profile() const;
    [[nodiscard]] const TreeSettings& trees() const;
    [[nodiscard]] const ReleaseSettings& release() const;
    [[nodiscard]] const TargetSettings& targets() const;
    [[nodiscard]] const ObservedSettings& observed() const;
    [[nodiscard]] const NetSettings& nets() const;
    [[nodiscard]] const WorkSettings& works() const;
    [[nodiscard]] const HazardSettings& hazard() const;
    [[nodiscard]] const OutputSettings& output() const;
    [[nodiscard]] const ForestSettings& forest() const;
    [[nodiscard]] const rockfall::Parameters& rockfall() const;
    /// Lines, places and file names of the settings.
    [[nodiscard]] const ScenarioFile& settings() const { return settings_; }
    /// All of it, for what looks at several sections.
    [[nodiscard]] const Scenario& scenario() const { return scenario_; }
    [[nodiscard]] config::Problems& problems() { return problems_; }
    [[nodiscard]] const std::vector<InputFile>& inputs() const { return inputs_; }

    /// When everything was read: notes the columns of tables that were read under another name and those that
    /// nobody read, and throws all problems.
    void finish();

    void refuse(config::Place place, std::string found, std::string expected = "", std::string advice = "") {
        problems_.add(config::ExitCode::data, std::move(place), std::move(found), std::move(expected),
                      std::move(advice));
    }
    /// Suspicious input: a warning, or an error with run.strict_inputs.
    void warn(config::Place place, std::string found, std::string expected, std::string advice = "",
              config::Effect effect = config::Effect::part);
    /// A limit of the run and no fault of a file: a warning, never an error.
    void warn(std::string sentence, config::Effect effect = config::Effect::part) {
        warnings_.add(std::move(sentence), effect);
    }
    /// What a room below found, each sentence behind `opening`.
    void take(const config::Warnings& found, const std::string& opening = "");
    /// Worth knowing, never an error.
    void note(std::string sentence) { warnings_.add_note(std::move(sentence)); }

    /// Notes the settings that were written with an earlier name, and those without effect.
    void note_settings();

    /// Runs a step; what it throws joins the other problems, and nothing comes back.
    template <class Step>
    auto attempt(Step step) -> std::optional<decltype(step())> {
        try {
            return step();
        } catch (const config::InputError& error) {
            problems_.add(error);
            return std::nullopt;
        }
    }

    /// Name of a file in results and messages, wherever the program was called: see InputNames. Errors are
    /// shown with paths, by Scenario::with_paths around all that reads.
    [[nodiscard]] std::string shown(const std::string& name) const { return settings_.shown(name); }

    /// Whether a file was opened in a role.
    [[nodiscard]] bool has_input(const std::string& role) const;
    /// Opens a file that the setting `key` names and records it under its role.
    FileBytes open(const std::string& key, const std::string& role, const std::string& name,
                   std::string_view expected);
    /// The same of a file that is named elsewhere, such as in a row of a table: at `place`.
    FileBytes open_at(const config::Place& place, const std::string& role, const std::string& name,
                      std::string_view expected);
    /// A table or layer in any format (`formats/`), with our names of columns. Shapes in another coordinate
    /// system than the terrain are transformed, which is noted. Rows without an id are called by their
    /// numbers, with `id_opening` before them where a setting names several files.
    config::Table table(const std::string& key, const std::string& role, const std::string& name,
                        const std::string& id_opening = "");
    /// The same of a file that is named elsewhere, such as in a row of a table: at `place`.
    config::Table table_at(const config::Place& place, const std::string& role, const std::string& name,
                           const std::string& id_opening = "");
    /// A grid in any format, or tiles of it; heights, grounds and sources cut to terrain.extent_m.
    config::Raster<double> grid(const std::string& key, const std::string& role, const std::string& name);
    /// The coordinate system that the file of a grid or layer names: well-known text, "" without any.
    [[nodiscard]] std::string system_of(const std::string& role) const;
    /// The system in which the file `name` of a layer is written, also where the layer was transformed.
    [[nodiscard]] std::string given_system_of(const std::string& role, const std::string& name) const;
    /// That of the heights; "" where they name none.
    [[nodiscard]] std::string system_of_terrain() const;
    /// Notes what the file `name` says of the coordinates of a grid, a layer or points.
    void take_system(const std::string& role, const std::string& name, std::string text,
                     std::string given = "");
    /// Refuses grids, and layers that could not be transformed, in another coordinate system than the
    /// terrain, naming both; of those that were not looked at before. Grids are never resampled. True where
    /// all may lie in one system.
    bool check_systems();
    /// Names the part of a recorded file that the run uses and the hash of that part: what else stands in
    /// the file may change without making the run another one.
    void use_part_of(const std::string& role, const std::string& part, const std::string& hash);
    /// The name of the file beside a file, as `path_beside` finds it.
    [[nodiscard]] std::string name_beside(const std::string& file, const std::string& ending) const;
    /// A file that may be missing: its text, or "".
    std::string text_beside(const std::string& role, const std::string& name);

private:
    const Scenario& scenario_;
    const ScenarioFile& settings_;
    config::Warnings& warnings_;

    /// Brings shapes into the system of what was read first, where both systems are known.
    void transform(formats::Layer& layer);
    formats::BytesBeside beside(const std::string& role, const std::string& file);
    /// How the files of a grid are opened and recorded.
    grids::GridFiles grid_files(const std::string& role);
    void take_findings(const tables::Findings& findings);
    /// Refuses settings that name a file which is not there, whether this run reads it or not.
    void check_files_of_settings();

    /// What a grid or layer says of its coordinates.
    struct NamedSystem {
        std::string role;
        std::string file;   ///< as shown
        std::string text;   ///< well-known text
        std::string given;  ///< that of the file before the layer was transformed
    };
    [[nodiscard]] static bool is_of_terrain(const NamedSystem& system);

    config::Problems problems_;
    std::vector<InputFile> inputs_;
    std::vector<std::shared_ptr<const config::ColumnUse>> uses_;  ///< of each table
    std::vector<NamedSystem> systems_;
    std::size_t systems_checked_ = 0;
    std::deque<FileBytes> open_;  ///< parts of Shapefiles while they are read
};

}  // namespace coupling
