#include "coupling/assessments/nets/figures/run_terrain.hpp"

#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/systems/transform_layer.hpp"

namespace coupling {

TableOnRun table_on(const RunTerrain& run, const std::filesystem::path& file, const std::string& expected,
                    std::vector<std::string>& remarks) {
    const formats::LayerName wanted = formats::split_layer_name(file.string());
    const FileBytes bytes = open_file(wanted.file, {file.string()}, expected);
    FilesBeside beside{wanted.file};
    formats::ReadLayer read =
        formats::read_layer_file(bytes.text(), wanted.layer, file.string(), beside.bytes());
    if (plausible::compare_systems(run.projection, read.layer.projection) == plausible::Sameness::other) {
        const systems::Transformed done =
            systems::transform_layer(read.layer, run.projection, "the terrain of the run");
        remarks.push_back(done.note);
        if (!done.warning.empty()) {
            remarks.push_back(config::joined("warning: ", file.string(), ": ", done.warning));
        }
    }
    return {std::move(read.layer.table), read.has_shapes_of_its_own};
}

}  // namespace coupling
