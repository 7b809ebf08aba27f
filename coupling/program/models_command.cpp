#include <algorithm>

#include "config/text/joined.hpp"
#include "coupling/program/actions/listing.hpp"
#include "coupling/program/actions/run_models.hpp"
#include "coupling/program/commands.hpp"
#include "coupling/program/line/arguments.hpp"
#include "coupling/results/figures/model_verdicts.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr const char* models_help = R"(bannwald models [NAME]

Which motion model for what: what its rocks do, what its energies count, and how many criteria of the field cases
it meets with the settings that it has by default. Criteria that anything was fitted to do not count.
A scenario chooses one with rockfall.motion = NAME; its settings stand in the section [NAME].
)";

void describe(const rockfall::ModelDescription& model, std::ostream& out) {
    say(out, std::string{model.name}, joined(model.title, " (", model.source, ")"));
    say(out, "  rocks", joined(model.rocks, "; ", model.law));
    say(out, "  energy", joined("counts ", model.energy));
    say(out, "  field cases", joined("meets of ", verdicts_in_words(model.name)));
    if (!model.caution.empty()) {
        say(out, "  caution", std::string{model.caution});
    }
}

int describe_models(const Arguments& arguments, const Call& call) {
    const std::vector<std::string> names = model_names();
    const std::string wanted = arguments.words().empty() ? "" : arguments.only_word();
    const std::string nearest = config::nearest_word(wanted, names);
    if (!wanted.empty() && std::find(names.begin(), names.end(), wanted) == names.end()) {
        refuse_usage(joined("a motion model ", config::in_quotes(wanted)),
                     nearest.empty() ? "a name that `bannwald models` lists" : joined("'", nearest, "'"));
    }
    for (const rockfall::MotionModel model : rockfall::all_models()) {
        if (wanted.empty() || wanted == rockfall::description_of(model).name) {
            describe(rockfall::description_of(model), call.out);
        }
    }
    return static_cast<int>(config::ExitCode::done);
}

}  // namespace

Command models_command() {
    return {
        .name = "models",
        .overview =
            R"(  bannwald models [NAME]               which motion model for what, and what each is judged by
)",
        .help = models_help,
        .argument = "a motion model",
        .options = {},
        .completion = {.words = model_names},
        .run = describe_models};
}

}  // namespace coupling
