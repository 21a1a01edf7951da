#include "scene/property.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "base/number.hpp"

namespace sphereview {

namespace {

template <typename Number>
bool same_bytes(const std::vector<Number>& a, const std::vector<Number>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Number)) == 0);
}

bool same_bytes(const Labels& a, const Labels& b) { return a == b; }

template <typename Number>
std::size_t size_of_values(const std::vector<Number>& values) {
    return values.size();
}

std::size_t size_of_values(const Labels& labels) { return labels.numbers.size(); }

template <typename Number>
double number_in(const std::vector<Number>& values, std::size_t sphere) {
    return values[sphere];
}

double number_in(const Labels&, std::size_t) { return std::numeric_limits<double>::quiet_NaN(); }

template <typename Number>
std::string text_in(const std::vector<Number>& values, std::size_t sphere) {
    return std::isnan(values[sphere]) ? "" : shortest(values[sphere]);
}

std::string text_in(const std::vector<std::int32_t>& values, std::size_t sphere) { return std::to_string(values[sphere]); }

std::string text_in(const Labels& labels, std::size_t sphere) { return labels.words[labels.numbers[sphere]]; }

}  // namespace

std::size_t size_of(const Property& property) {
    return std::visit([](const auto& values) { return size_of_values(values); }, property.values);
}

double number_at(const Property& property, std::size_t sphere) {
    return std::visit([sphere](const auto& values) { return number_in(values, sphere); }, property.values);
}

std::string text_at(const Property& property, std::size_t sphere) {
    return std::visit([sphere](const auto& values) { return text_in(values, sphere); }, property.values);
}

bool operator==(const Property& a, const Property& b) {
    if (a.name != b.name || a.values.index() != b.values.index()) return false;
    return std::visit([&b](const auto& values) { return same_bytes(values, std::get<std::decay_t<decltype(values)>>(b.values)); },
                      a.values);
}

}  // namespace sphereview
