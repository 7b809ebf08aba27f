#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "coupling/results/pack/crate.hpp"
#include "coupling/results/pack/manifest.hpp"

namespace coupling::pack {

/// An archive whose content is what its checksums say.
struct VerifiedArchive {
    PackedRun run;
    std::vector<ListedFile> files;  ///< all but the list of checksums
};

/// Reads every entry of an archive and compares it with the list of checksums. Throws config::InputError:
/// (file) for a file that is missing, (data) with every entry that is damaged, missing or not listed.
VerifiedArchive verify_archive(const std::filesystem::path& archive);

/// Writes the inputs of an archive below a new or empty folder. Throws config::InputError (settings, file).
void unpack_inputs(const std::filesystem::path& archive, const VerifiedArchive& verified,
                   const std::filesystem::path& folder);

/// Results of an archive that a repeated run made otherwise or not at all, each with the reason.
std::vector<std::string> differences_from(const VerifiedArchive& verified,
                                          const std::filesystem::path& repeated_run);

}  // namespace coupling::pack
