#include "coupling/results/pack/verify.hpp"

#include <algorithm>
#include <map>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/sha256.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/pack/stored_file.hpp"
#include "coupling/results/pack/zip_file.hpp"

namespace coupling::pack {
namespace {

namespace fs = std::filesystem;
using config::ExitCode;
using config::joined;

constexpr std::uint64_t most_text_bytes = 64U << 20U;
constexpr const char* of_results = "results/";
constexpr const char* of_inputs = "inputs/";

}  // namespace

VerifiedArchive verify_archive(const fs::path& archive) {
    const ZipReader zip{archive};
    const std::string file = archive.string();
    if (!zip.has(manifest_name) || !zip.has("run.json")) {
        config::fail(ExitCode::data, {file}, joined("no ", manifest_name, " or no run.json"),
                     "an archive of bannwald pack");
    }
    VerifiedArchive verified{{}, read_manifest(zip.text(manifest_name, most_text_bytes), file)};
    config::Problems problems;
    const auto refuse = [&](const std::string& name, const char* found, const char* expected) {
        problems.add(ExitCode::data, {joined(file, ", ", name)}, found, expected,
                     "get the archive once more");
    };
    std::map<std::string, std::string> listed;
    for (const ListedFile& each : verified.files) {
        listed[each.name] = each.sha256;
        if (!zip.has(each.name)) {
            refuse(each.name, "no such entry", "every file of the list of checksums");
        }
    }
    for (const std::string& name : zip.names()) {
        if (name == manifest_name) {
            continue;
        }
        const auto known = listed.find(name);
        if (known == listed.end()) {
            refuse(name, "an entry without checksum", "the files of the list of checksums alone");
            continue;
        }
        config::Sha256 sum;
        try {
            zip.read(name, [&](std::string_view piece) { sum.add(piece); });
        } catch (const config::InputError&) {
            refuse(name, "a damaged entry", "the bytes of the list of checksums");
            continue;
        }
        if (sum.digits() != known->second) {
            refuse(name, "other bytes", "those of the list of checksums");
        }
    }
    problems.throw_if_any();
    verified.run = read_run_json(zip.text("run.json", most_text_bytes), file);
    if (!listed.contains(verified.run.scenario) || !verified.run.scenario.starts_with(of_inputs)) {
        config::fail(ExitCode::data, {joined(file, ", run.json")},
                     joined("the scenario ", config::in_quotes(verified.run.scenario)),
                     "one of the inputs of the archive");
    }
    return verified;
}

void unpack_inputs(const fs::path& archive, const VerifiedArchive& verified, const fs::path& folder) {
    if (path_exists(folder) && !(is_folder(folder) && is_empty_folder(folder))) {
        config::fail(ExitCode::settings, {folder.string()}, "a folder that is not empty", "a new folder",
                     "name another one by --out");
    }
    const ZipReader zip{archive};
    for (const ListedFile& each : verified.files) {
        if (each.name.starts_with(of_inputs)) {
            const fs::path file = folder / each.name;
            make_folder(file.parent_path());
            OutFile out{file};
            zip.read(each.name, [&](std::string_view piece) {
                out.stream().write(piece.data(), static_cast<std::streamsize>(piece.size()));
            });
            out.close();
        }
    }
}

std::vector<std::string> differences_from(const VerifiedArchive& verified, const fs::path& repeated_run) {
    std::vector<std::string> differences;
    for (const ListedFile& each : verified.files) {
        if (!each.name.starts_with(of_results)) {
            continue;
        }
        const std::string name = each.name.substr(std::string_view{of_results}.size());
        const fs::path file = repeated_run / name;
        if (!is_file(file)) {
            differences.push_back(joined(name, ": not written"));
        } else if (stored_file(file).sha256 != each.sha256) {
            differences.push_back(joined(name, ": other bytes"));
        }
    }
    return differences;
}

}  // namespace coupling::pack
