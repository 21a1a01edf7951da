#include "edit/condition.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "scene/property_names.hpp"

namespace sphereview {

namespace {

constexpr std::string_view between_words = " \t\r\n";
constexpr std::string_view ends_word = " \t\r\n()<>=!&|";
constexpr std::size_t most_nested_brackets = 32;
constexpr std::size_t most_comparisons = 1000;
// Truths that wait for others: two a bracket.
constexpr std::size_t most_stacked = 2 * (most_nested_brackets + 1) + 1;

constexpr auto every_sphere_has = std::to_array<std::string_view>({"x", "y", "z", "radius", "number", "name"});

struct Operator {
    std::string_view text;
    ComparedBy by;
};
constexpr auto operators = std::to_array<Operator>({{"==", ComparedBy::equal},
                                                    {"!=", ComparedBy::unequal},
                                                    {"<=", ComparedBy::at_most},
                                                    {">=", ComparedBy::at_least},
                                                    {"=", ComparedBy::equal},
                                                    {"<", ComparedBy::less},
                                                    {">", ComparedBy::greater}});

[[noreturn]] void fail(std::string_view text, std::size_t offset, const std::string& message) {
    throw InputError("column " + std::to_string(position_at(text, offset).column) + ": " + message);
}

bool fulfils(double value, ComparedBy by, double wanted) {
    switch (by) {
        case ComparedBy::equal: return value == wanted;
        case ComparedBy::unequal: return value < wanted || value > wanted;  // not where there is none
        case ComparedBy::less: return value < wanted;
        case ComparedBy::at_most: return value <= wanted;
        case ComparedBy::greater: return value > wanted;
        default: return value >= wanted;
    }
}

std::optional<double> as_number(std::string_view text) {
    double value = 0.0;
    return parse_any_double(text, value) == NumberFault::none ? std::optional(value) : std::nullopt;
}

bool is_of_words(ComparedBy by) { return by == ComparedBy::equal || by == ComparedBy::unequal; }

bool has_every_sphere(std::string_view name) {
    return std::ranges::find(every_sphere_has, lower_case(name)) != every_sphere_has.end();
}

const Property* property_called(const Scene& scene, std::string_view name) {
    return property_meant(scene.properties, name, has_every_sphere(name) ? Likeness::but_for_case : Likeness::without_unit);
}

// "expected charge, chain, x, y, z, radius, number or name": what there is, as far as a line holds it.
std::string names_of(const Scene& scene) {
    constexpr std::size_t most_listed = 12;
    std::vector<std::string> names;
    for (const Property& property : scene.properties) names.push_back(property.name);
    names = first_of(std::move(names), most_listed);
    for (const std::string_view own : every_sphere_has) {
        if (find_property(scene.properties, own) == nullptr) names.emplace_back(own);
    }
    return "the name of a property: " + listed(names, "or");
}

// Which of a category's words fulfil a comparison: those that are the same, else those that differ in letter case alone, else the
// same numbers.
std::vector<bool> words_that_fulfil(const Labels& labels, ComparedBy by, const std::string& wanted) {
    const std::size_t count = labels.words.size();
    std::vector<bool> equal(count);
    const std::optional<double> number = as_number(wanted);
    const auto mark = [&](const auto& is) {
        bool any = false;
        for (std::size_t i = 0; i < count; ++i) {
            equal[i] = is(labels.words[i]);
            any = any || equal[i];
        }
        return any;
    };
    const auto is_number = [&](const std::string& word, ComparedBy how) {
        const std::optional<double> value = as_number(word);
        return value && number && fulfils(*value, how, *number);
    };
    if (!is_of_words(by)) {
        mark([&](const std::string& word) { return is_number(word, by); });
        return equal;
    }
    if (!mark([&](const std::string& word) { return word == wanted; }) &&
        !mark([&](const std::string& word) { return lower_case(word) == lower_case(wanted); })) {
        mark([&](const std::string& word) { return is_number(word, ComparedBy::equal); });
    }
    if (by == ComparedBy::unequal) {
        for (std::size_t i = 0; i < count; ++i) equal[i] = !equal[i] && !labels.words[i].empty();
    }
    return equal;
}

}  // namespace

class ConditionParser {
public:
    ConditionParser(std::string_view text, Condition& condition) : text_(text), condition_(condition) {}

    void parse() {
        any_of(0);
        skip_white();
        if (at_ < text_.size()) fail_here("and, or, or the end");
    }

private:
    using Step = Condition::Step;

    void any_of(std::size_t depth) {
        all_of(depth);
        while (takes("or") || takes("||")) {
            all_of(depth);
            condition_.steps_.push_back(Step::either);
        }
    }

    void all_of(std::size_t depth) {
        one(depth);
        while (takes("and") || takes("&&")) {
            one(depth);
            condition_.steps_.push_back(Step::both);
        }
    }

    void one(std::size_t depth) {
        bool negated = false;
        while (takes("not") || takes("!")) negated = !negated;
        skip_white();
        const std::size_t begin = at_;
        if (takes("(")) {
            if (depth == most_nested_brackets) {
                fail(text_, begin, "found brackets in brackets, expected at most " + std::to_string(most_nested_brackets));
            }
            any_of(depth + 1);
            if (!takes(")")) fail_here("and, or, or a closing bracket");
        } else {
            comparison();
        }
        if (negated) condition_.steps_.push_back(Step::negate);
    }

    void comparison() {
        ValueComparison found;
        skip_white();
        const std::size_t begin = at_;
        found.name_column = position_at(text_, at_).column;
        found.name = word("the name of a property");
        skip_white();
        const auto is_next = [&](const Operator& one) { return text_.substr(at_).starts_with(one.text); };
        const auto by = std::ranges::find_if(operators, is_next);
        if (by == operators.end()) fail_here("=, !=, <, <=, > or >=");
        found.by = by->by;
        at_ += by->text.size();
        skip_white();
        found.value_column = position_at(text_, at_).column;
        found.value = word("a number or a word");
        if (condition_.comparisons_.size() == most_comparisons) {
            fail(text_, begin, "found more comparisons, expected at most " + std::to_string(most_comparisons));
        }
        condition_.comparisons_.push_back(std::move(found));
        condition_.steps_.push_back(Step::compare);
    }

    // In quotes, or up to a blank, bracket or operator.
    std::string word(const char* expected) {
        if (at_ == text_.size()) fail_here(expected);
        const char quote = text_[at_];
        if (quote == '"' || quote == '\'') {
            const std::size_t end = text_.find(quote, at_ + 1);
            if (end == std::string_view::npos)
                fail(text_, at_, "found a quote that nothing closes, expected another one behind it");
            const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
            at_ = end + 1;
            return std::string(inside);
        }
        const std::size_t end = std::min(text_.find_first_of(ends_word, at_), text_.size());
        if (end == at_) fail_here(expected);
        const std::string_view found = text_.substr(at_, end - at_);
        at_ = end;
        return std::string(found);
    }

    bool takes(std::string_view wanted) {
        skip_white();
        const std::string_view rest = text_.substr(at_);
        if (lower_case(rest.substr(0, wanted.size())) != wanted) return false;
        const bool is_word = wanted[0] >= 'a' && wanted[0] <= 'z';
        if (is_word) {
            // A property may be called "or": an operator behind it tells.
            const std::string_view behind = rest.substr(wanted.size());
            if (!behind.empty() && ends_word.find(behind[0]) == std::string_view::npos) return false;
            const std::string_view next = trimmed(behind, between_words);
            if (!next.empty() && std::string_view("<>=").find(next[0]) != std::string_view::npos) return false;
        }
        if (wanted == "!" && rest.starts_with("!=")) return false;
        at_ += wanted.size();
        return true;
    }

    void skip_white() { at_ = std::min(text_.find_first_not_of(between_words, at_), text_.size()); }

    [[noreturn]] void fail_here(const std::string& expected) const {
        if (at_ == text_.size()) fail(text_, at_, "the text ends, expected " + expected);
        const std::string_view rest = text_.substr(at_);
        const std::size_t length = std::max<std::size_t>(1, std::min(rest.find_first_of(ends_word), rest.size()));
        fail(text_, at_, found_expected(rest.substr(0, length), expected));
    }

    std::string_view text_;
    std::size_t at_ = 0;
    Condition& condition_;
};

Condition::Condition(std::string_view text) { ConditionParser(text, *this).parse(); }

bool is_condition(std::string_view text) { return text.find_first_of("<>=") != std::string_view::npos; }

bool can_compare(const Scene& scene, std::string_view name) {
    return property_called(scene, name) != nullptr || has_every_sphere(name);
}

SphereTest::SphereTest(const Condition& condition, const Scene& scene) : scene_(&scene), steps_(condition.steps_) {
    for (const ValueComparison& comparison : condition.comparisons_) {
        Test test;
        test.by = comparison.by;
        test.word = comparison.value;
        test.property = property_called(scene, comparison.name);
        const auto own = std::ranges::find(every_sphere_has, lower_case(comparison.name));
        const auto fail_with = [](std::size_t column, const std::string& message) {
            throw InputError("column " + std::to_string(column) + ": " + message);
        };
        if (test.property == nullptr && own == every_sphere_has.end()) {
            std::vector<std::string> names(every_sphere_has.begin(), every_sphere_has.end());
            for (const Property& property : scene.properties) names.push_back(property.name);
            fail_with(comparison.name_column,
                      found_expected(comparison.name, names_of(scene)) + did_you_mean(comparison.name, names));
        }
        if (test.property == nullptr) test.source = static_cast<Source>(1 + (own - every_sphere_has.begin()));
        const bool words = test.source == Source::name || (test.property != nullptr && is_category(*test.property));
        const std::optional<double> number = as_number(comparison.value);
        if (!number && (!words || !is_of_words(comparison.by))) {
            fail_with(comparison.value_column, found_expected(comparison.value, "a number"));
        }
        test.number = number.value_or(0.0);
        if (test.property != nullptr && words) {
            test.words = words_that_fulfil(std::get<Labels>(test.property->values), comparison.by, comparison.value);
        }
        tests_.push_back(std::move(test));
    }
}

bool SphereTest::holds(const Test& test, std::uint32_t sphere) const {
    const Sphere& own = scene_->spheres[sphere];
    switch (test.source) {
        case Source::x: return fulfils(own.center.x, test.by, test.number);
        case Source::y: return fulfils(own.center.y, test.by, test.number);
        case Source::z: return fulfils(own.center.z, test.by, test.number);
        case Source::radius: return fulfils(own.radius, test.by, test.number);
        case Source::number: return fulfils(sphere, test.by, test.number);
        case Source::name: {
            const auto name = scene_->names.find(sphere);
            return name != scene_->names.end() && (name->second == test.word) == (test.by == ComparedBy::equal);
        }
        default: break;
    }
    if (const auto* const labels = std::get_if<Labels>(&test.property->values)) return test.words[labels->numbers[sphere]];
    return fulfils(number_at(*test.property, sphere), test.by, test.number);
}

bool SphereTest::operator()(std::uint32_t sphere) const {
    std::array<bool, most_stacked> truths{};
    std::size_t count = 0;
    std::size_t next = 0;
    for (const Condition::Step step : steps_) {
        switch (step) {
            case Condition::Step::compare: truths[count++] = holds(tests_[next++], sphere); break;
            case Condition::Step::both:
                --count;
                truths[count - 1] = truths[count - 1] && truths[count];
                break;
            case Condition::Step::either:
                --count;
                truths[count - 1] = truths[count - 1] || truths[count];
                break;
            case Condition::Step::negate: truths[count - 1] = !truths[count - 1]; break;
        }
    }
    return truths[0];
}

}  // namespace sphereview
