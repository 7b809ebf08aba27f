#include "coupling/program/actions/ground_proposals.hpp"

#include "config/data/shipped_tables.hpp"
#include "config/text/plain_letters.hpp"

namespace coupling {

GroundProposals::GroundProposals() : words_{config::read_shipped_table("ground_words.csv")} {}

std::string GroundProposals::of(const std::string& name) const {
    const std::string plain = config::plain_letters(name);
    std::string type;
    std::size_t longest = 0;
    for (std::size_t row = 0; row < words_.rows(); ++row) {
        const std::string& word = words_.text(row, "word");
        if (word.size() > longest && plain.find(word) != std::string::npos) {
            longest = word.size();
            type = words_.text(row, "surface");
        }
    }
    return type;
}

}  // namespace coupling
