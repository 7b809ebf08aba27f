#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "config/errors/input_error.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling {

/// The files that a GIS wrote (files/make.sh): the sample project as GeoTIFF, GeoPackage, Shapefile, GeoJSON.
inline std::string given_file(const std::string& name) {
    std::ifstream in{BANNWALD_SOURCE_DIR "/tests/coupling/inputs/formats/files/" + name, std::ios::binary};
    if (!in) {
        throw std::runtime_error{"no file " + name};
    }
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// All of them beside the files of a sample project.
inline void take_given_files(const SampleProject& project) {
    for (const auto& entry :
         std::filesystem::directory_iterator{BANNWALD_SOURCE_DIR "/tests/coupling/inputs/formats/files"}) {
        const std::string name = entry.path().filename().string();
        project.write(name, given_file(name));
    }
}

/// Files of a Shapefile by their endings, for readers that ask for what lies beside.
using FileParts = std::map<std::string, std::string>;

inline FileParts given_shapefile(const std::string& stem) {
    FileParts parts;
    for (const char* ending : {".shp", ".shx", ".dbf", ".prj"}) {
        parts[ending] = given_file(stem + ending);
    }
    return parts;
}

inline formats::BytesBeside beside(const FileParts& parts) {
    return [&parts](const std::string& ending) -> std::string_view {
        const auto found = parts.find(ending);
        return found == parts.end() ? std::string_view{} : std::string_view{found->second};
    };
}

inline formats::BytesBeside nothing_beside() {
    return [](const std::string&) { return std::string_view{}; };
}

/// The message of what a call refuses; "" where it accepts.
template <class Call>
std::string refusal_of(Call call) {
    try {
        call();
    } catch (const config::InputError& error) {
        return error.what();
    }
    return {};
}

}  // namespace coupling
