#include "coupling/results/text/script_texts.hpp"

#include "config/text/embedded.hpp"
#include "coupling/results/text/catalogue.hpp"
#include "coupling/results/text/writing_language.hpp"

BANNWALD_EMBED(texts_of_scripts, BANNWALD_EMBEDDED_FILE)

namespace coupling::report {

std::vector<std::pair<std::string, std::string>> script_texts() {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const std::vector<std::string>& row : rows_of_all_languages(BANNWALD_EMBEDDED(texts_of_scripts))) {
        texts.emplace_back(row[0], row[1 + static_cast<std::size_t>(language_in_use())]);
    }
    return texts;
}

}  // namespace coupling::report
