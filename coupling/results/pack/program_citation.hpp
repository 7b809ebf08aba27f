#pragma once

#include <string>
#include <vector>

namespace coupling::pack {

/// What CITATION.cff says of the program, so that an archive names its source, authors and licence.
struct ProgramCitation {
    std::string title;
    std::string version;
    std::string licence;               ///< SPDX identifier
    std::vector<std::string> authors;  ///< as they stand there: names, or "family, given"
    std::string repository;            ///< URL of the source; empty where the file names none
};

/// Reads the keys above from the text of a CITATION.cff; the rest of the file is passed over.
ProgramCitation read_citation(const std::string& text);

/// That of this program, built in.
const ProgramCitation& program_citation();

}  // namespace coupling::pack
