// Conditions that people write to find spheres: `charge > 0.5`, `chain = A and not (element = H or b_factor >= 30)`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace sphereview {

enum class ComparedBy { equal, unequal, less, at_most, greater, at_least };

// One comparison, with the columns of name and value in the text, from 1.
struct ValueComparison {
    std::string name;
    ComparedBy by = ComparedBy::equal;
    std::string value;
    std::size_t name_column = 1;
    std::size_t value_column = 1;
};

class Condition {
public:
    // NAME = VALUE, with = == != < <= > >=, joined by and, or, not (also && || !) and brackets. Texts with blanks need quotes.
    // Throws InputError "column 8: found ..., expected ...".
    explicit Condition(std::string_view text);

    // In the order of the text.
    const std::vector<ValueComparison>& comparisons() const { return comparisons_; }

private:
    friend class SphereTest;
    friend class ConditionParser;

    // Steps for a stack of truth values: each takes its operands and pushes its result.
    enum class Step : std::uint8_t { compare, both, either, negate };

    std::vector<ValueComparison> comparisons_{};
    std::vector<Step> steps_{};
};

// Whether a text compares something, so that it is a condition and no name.
bool is_condition(std::string_view text);

// Whether a condition for the scene can use `name`: a property in any letter case, or x, y, z, radius, number or name, which every
// sphere has.
bool can_compare(const Scene& scene, std::string_view name);

// A condition for the spheres of a scene, which must not change meanwhile. A sphere without a value fulfils no comparison.
class SphereTest {
public:
    // Throws InputError if the scene lacks a property, or if a property of numbers is compared with a word.
    SphereTest(const Condition& condition, const Scene& scene);

    bool operator()(std::uint32_t sphere) const;

private:
    enum class Source { property, x, y, z, radius, number, name };

    struct Test {
        Source source = Source::property;
        ComparedBy by = ComparedBy::equal;
        const Property* property = nullptr;
        double number = 0.0;
        std::string word{};
        std::vector<bool> words{};  // of a category: the words that fulfil the comparison
    };

    bool holds(const Test& test, std::uint32_t sphere) const;

    const Scene* scene_;
    std::vector<Condition::Step> steps_;
    std::vector<Test> tests_{};
};

}  // namespace sphereview
