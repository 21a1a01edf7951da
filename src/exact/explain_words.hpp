// What an explanation of a pixel says in words, for whoever shows it.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "exact/explain.hpp"

namespace sphereview {

// A number whose sign (-1, 0, 1) is known exactly, also where a double has become 0 or infinite: what is shown must not
// contradict what was decided.
std::string number_in_words(double value, int sign);

std::string vector_in_words(const glm::dvec3& v);

// Which root counts, and why.
const char* why(const ExplainedHit& hit);

// What it took to decide a pixel.
const char* level_in_words(DecisionLevel level);

// The numbers of a hit.
struct HitInWords {
    std::string a;
    std::string b;
    std::string c;
    std::string discriminant;
    std::string roots;  // how many, by the discriminant: "> 0: two roots"
    std::string t1;
    std::string t2;
    std::string t;
    std::string point;
    std::string normal;
};
HitInWords in_words(const ExplainedHit& hit);

}  // namespace sphereview
