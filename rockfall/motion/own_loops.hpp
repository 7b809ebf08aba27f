#pragma once

// The event loops of models that have their own: each specialises Fall for its Motion.
#include "rockfall/motion/rigid/fall.hpp"
