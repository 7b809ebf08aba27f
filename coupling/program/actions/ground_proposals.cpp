#include "coupling/program/actions/ground_proposals.hpp"

#include "config/data/shipped_tables.hpp"
#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/plain_letters.hpp"

namespace coupling {

using config::joined;

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

ProposedTypes proposed_types(const std::set<long long>& codes, const std::vector<std::string>& names,
                             const std::string& usual) {
    const GroundProposals proposals;
    ProposedTypes types{
        .table =
            "# GUESS: what each code or name of the map is like. Replace the names in `like` by those of\n"
            "# bannwald info surfaces, or give r_n, r_t and p_stop of your own.\ncode,label,like\n",
        .codes = {},
        .names = {}};
    for (const long long code : codes) {
        types.table += joined(std::to_string(code), ",code ", std::to_string(code), ",", usual, "\n");
        types.codes += joined(types.codes.empty() ? "" : ", ", std::to_string(code));
    }
    long long free = codes.empty() ? 1 : *codes.rbegin() + 1;
    for (const std::string& name : names) {
        const std::string proposal = proposals.of(name);
        const std::string like = proposal.empty() ? usual : proposal;
        types.table += joined(std::to_string(free++), ",", config::csv_field(name), ",", like, "\n");
        types.names += joined(types.names.empty() ? "" : ", ", config::in_quotes(name), " like ", like,
                              proposal.empty() ? " (no word known)" : "");
    }
    return types;
}

}  // namespace coupling
