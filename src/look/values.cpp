#include "look/values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/logarithm.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "formats/elements.hpp"
#include "scene/property_names.hpp"

namespace sphereview {

namespace {

Property own_values(const Scene& scene, std::size_t which) {
    std::vector<double> values(scene.spheres.size());
    std::ranges::transform(scene.spheres, values.begin(), [which](const Sphere& sphere) {
        return which == 3 ? sphere.radius : sphere.center[static_cast<int>(which)];
    });
    return {std::string(own_value_names[which]), std::move(values)};
}

// "1.50e+06" as "1.5e6", and "2.500" as "2.5".
std::string without_idle_zeros(const std::string& text) {
    const std::size_t exponent = std::min(text.find('e'), text.size());
    std::string mantissa = text.substr(0, exponent);
    if (mantissa.find('.') != std::string::npos) {
        mantissa.erase(mantissa.find_last_not_of('0') + 1);
        if (mantissa.ends_with('.')) mantissa.pop_back();
    }
    if (exponent == text.size()) return mantissa;
    const std::size_t digits = text.find_first_not_of("+-0", exponent + 1);
    if (digits == std::string::npos) return mantissa;
    return mantissa + (text[exponent + 1] == '-' ? "e-" : "e") + text.substr(digits);
}

// The number that is written so: no power of ten is inexact there.
double number_of(const std::string& text) {
    double value = 0.0;
    return parse_double(text, value) == NumberFault::none ? value : 0.0;
}

// 1, 2 or 5 times a power of ten, and the next larger one.
struct RoundStep {
    int digit = 1;
    int exponent = 0;

    double value() const { return number_of(std::to_string(digit) + "e" + std::to_string(exponent)); }
    RoundStep next() const {
        if (digit == 5) return {1, exponent + 1};
        return {digit == 1 ? 2 : 5, exponent};
    }
};

std::string tick_text(double value, const RoundStep& step, double largest) {
    if (step.exponent >= -4 && largest < 1e6) return fixed(value, std::max(-step.exponent, 0));
    if (value == 0.0) return "0";
    const int digits = std::clamp(decimal_exponent(value) - step.exponent, 0, 16);
    return without_idle_zeros(decimal(value, std::chars_format::scientific, digits));
}

// Multiples of a round step.
std::vector<Tick> linear_ticks(const ValueRange& range, bool log, int most) {
    const double low = std::min(range.low, range.high);
    const double high = std::max(range.low, range.high);
    const double span = high - low;
    if (!std::isfinite(span)) return {};
    for (RoundStep step{1, decimal_exponent(span) - 3};; step = step.next()) {
        const double size = step.value();
        if (!(size > 0.0)) return {};
        // What rounding has moved out of the range by a trifle is still in it.
        constexpr double trifle = 1e-9;
        const double first = std::ceil(low / size - trifle);
        const double last = std::floor(high / size + trifle);
        if (last - first + 1.0 > most) continue;
        std::vector<Tick> ticks;
        for (double i = first; i <= last; i += 1.0) {
            const double value = i * size + 0.0;  // -0 becomes 0
            ticks.push_back({std::clamp(part_of(value, range, log), 0.0, 1.0),
                             tick_text(value, step, std::max(std::abs(low), std::abs(high)))});
        }
        return ticks;
    }
}

// Powers of ten, or also 2 and 5 times these where there are few.
std::vector<Tick> logarithmic_ticks(const ValueRange& range, int most) {
    const double low = std::min(range.low, range.high);
    const double high = std::max(range.low, range.high);
    const int first = decimal_exponent(low);
    const int last = decimal_exponent(high);
    const auto collect = [&](const std::vector<int>& digits, int every) {
        std::vector<Tick> ticks;
        for (int exponent = first; exponent <= last; ++exponent) {
            if (exponent % every != 0) continue;
            for (const int digit : digits) {
                const double value = RoundStep{digit, exponent}.value();
                if (!(value >= low && value <= high)) continue;
                ticks.push_back({std::clamp(part_of(value, range, true), 0.0, 1.0), in_few_digits(value, 3)});
            }
        }
        return ticks;
    };
    std::vector<Tick> ticks = collect({1, 2, 5}, 1);
    if (static_cast<int>(ticks.size()) <= most && ticks.size() >= 2) return ticks;
    for (const int every : {1, 2, 3, 5, 10, 15, 20, 30, 50, 100, 150, 200, 300}) {
        ticks = collect({1}, every);
        if (static_cast<int>(ticks.size()) <= most) break;
    }
    return ticks;
}

}  // namespace

const Property* find_values(const Scene& scene, std::string_view name, Property& own) {
    if (const Property* found = property_meant(scene.properties, name, Likeness::but_for_case)) return found;
    const auto of_every = std::ranges::find(own_value_names, lower_case(name));
    if (of_every == own_value_names.end()) return property_meant(scene.properties, name, Likeness::without_unit);
    own = own_values(scene, static_cast<std::size_t>(of_every - own_value_names.begin()));
    return &own;
}

bool holds_elements(const Property& values) {
    const auto* labels = std::get_if<Labels>(&values.values);
    if (labels == nullptr || std::ranges::find(element_property_names, lower_case(values.name)) == element_property_names.end())
        return false;
    return std::ranges::any_of(labels->words, [](const std::string& word) { return !element_of_species(word).symbol.empty(); });
}

const Property* find_elements(const Scene& scene) {
    const auto found = std::ranges::find_if(scene.properties, holds_elements);
    return found == scene.properties.end() ? nullptr : &*found;
}

std::optional<ValueRange> range_of(const Property& values, bool log, const std::vector<std::uint32_t>* spheres) {
    if (is_category(values)) return std::nullopt;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const auto take = [&](std::size_t sphere) {
        const double value = number_at(values, sphere);
        if (!std::isfinite(value) || (log && !(value > 0.0))) return;
        low = std::min(low, value);
        high = std::max(high, value);
    };
    if (spheres != nullptr) {
        for (const std::uint32_t sphere : *spheres) take(sphere);
    } else {
        for (std::size_t sphere = 0; sphere < size_of(values); ++sphere) take(sphere);
    }
    return low <= high ? std::optional(ValueRange{low + 0.0, high + 0.0}) : std::nullopt;
}

double part_of(double value, const ValueRange& range, bool log) {
    if (std::isnan(value)) return value;
    if (range.low == range.high) return 0.5;
    if (std::isinf(value)) return (value > 0.0) == (range.high > range.low) ? 1.0 : 0.0;
    if (log) {
        const bool up = range.high > range.low;
        if (!(value > 0.0)) return up ? 0.0 : 1.0;
        const double low = binary_logarithm(range.low);
        const double span = binary_logarithm(range.high) - low;
        return span == 0.0 ? 0.5 : (binary_logarithm(value) - low) / span;
    }
    // Halves: the span of the doubles is none.
    const double part = (0.5 * value - 0.5 * range.low) / (0.5 * range.high - 0.5 * range.low);
    return std::isfinite(part) ? part : 0.5;
}

double value_at(double part, const ValueRange& range, bool log) {
    if (part == 0.0) return range.low;
    if (part == 1.0) return range.high;
    if (log) return range.low * std::pow(range.high / range.low, part);
    return (1.0 - part) * range.low + part * range.high;
}

std::vector<Tick> ticks_of(const ValueRange& range, bool log, int most) {
    if (range.low == range.high) return {{0.5, in_few_digits(range.low, 4)}};
    std::vector<Tick> ticks = log ? logarithmic_ticks(range, most) : linear_ticks(range, log, most);
    if (ticks.size() < 2 && log) ticks = linear_ticks(range, log, most);
    if (ticks.size() < 2) ticks = {{0.0, in_few_digits(range.low, 4)}, {1.0, in_few_digits(range.high, 4)}};
    std::ranges::sort(ticks, {}, &Tick::part);
    return ticks;
}

std::string in_few_digits(double value, int digits) {
    if (value == 0.0) return "0";
    const int exponent = decimal_exponent(value);
    if (exponent < -4 || exponent >= 6) return without_idle_zeros(decimal(value, std::chars_format::scientific, digits - 1));
    return without_idle_zeros(fixed(value, std::clamp(digits - 1 - exponent, 0, 9)));
}

}  // namespace sphereview
