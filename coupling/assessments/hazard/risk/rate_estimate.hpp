#pragma once

namespace coupling::hazard::risk {

/// A rate with its 95 % interval by the chance of the simulated rocks.
struct Estimate {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;
};

/// What rocks add to a rate, each with a weight of its own: what it does, by what it stands for in a year.
struct RateSum {
    double sum = 0.0;
    double squares = 0.0;  ///< of the weights
    double largest = 0.0;  ///< that a rock could have, seen or not

    void could_add(double weight) { largest = weight > largest ? weight : largest; }
    void add(double weight) {
        sum += weight;
        squares += weight * weight;
        could_add(weight);
    }
};

/// Interval of Fay & Feuer (1997, Stat. Med. 16:791) for weighted sums of Poisson counts, by gamma
/// distributions; of equal weights it is the exact one of Garwood. Without any rock it is 0 to what 3.7 rocks
/// of the largest weight add. Rocks that hit are a part of all, so that the true interval is a little
/// narrower.
Estimate estimate(const RateSum& rate);

/// `more` - `less` of two independent sums, such as what the forest stops and what it makes worse: rocks that
/// do the same on both slopes are in neither. By MOVER (Zou & Donner 2008, Stat. Med. 27:1693) from the
/// intervals of the two.
Estimate difference(const RateSum& more, const RateSum& less);

}  // namespace coupling::hazard::risk
