#include "python/property_arrays.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "formats/property_columns.hpp"

namespace sphereview {

namespace py = pybind11;

namespace {

template <typename Number>
py::array array_of(std::vector<Number>&& values) {
    auto owner = std::make_unique<std::vector<Number>>(std::move(values));
    const auto count = static_cast<py::ssize_t>(owner->size());
    Number* const numbers = owner->data();
    const py::capsule keeper(owner.get(), [](void* kept) { delete static_cast<std::vector<Number>*>(kept); });
    owner.release();
    return py::array_t<Number>(count, numbers, keeper);
}

// An array of references to a few strings: one whose elements have the longest word's length could take any amount of memory.
py::array array_of(const Labels& labels) {
    std::vector<py::str> words;
    for (const std::string& word : labels.words) words.emplace_back(word);
    py::array array(py::dtype("O"), static_cast<py::ssize_t>(labels.numbers.size()));
    auto** elements = static_cast<PyObject**>(array.mutable_data());
    for (std::size_t i = 0; i < labels.numbers.size(); ++i) {
        PyObject* const before = elements[i];
        elements[i] = words[labels.numbers[i]].inc_ref().ptr();
        Py_XDECREF(before);
    }
    return array;
}

py::array array_of(Property&& property) {
    if (is_category(property)) return array_of(std::get<Labels>(property.values));
    if (auto* const floats = std::get_if<std::vector<float>>(&property.values)) return array_of(std::move(*floats));
    if (auto* const doubles = std::get_if<std::vector<double>>(&property.values)) return array_of(std::move(*doubles));
    auto& wholes = std::get<std::vector<std::int32_t>>(property.values);
    if (std::ranges::find(wholes, no_whole_number) == wholes.end()) return array_of(std::move(wholes));
    std::vector<double> numbers;
    numbers.reserve(wholes.size());
    for (std::size_t i = 0; i < wholes.size(); ++i) numbers.push_back(number_at(property, i));
    return array_of(std::move(numbers));
}

}  // namespace

py::dict values_of(std::vector<Property>&& properties, const DataOptions& asked) {
    py::dict values;
    for (Property& property : properties) {
        // The native format keeps its own whether they are asked for or not.
        if (!is_wanted(asked, property.name, size_of(property))) continue;
        const py::str name(property.name);
        values[name] = array_of(std::move(property));
    }
    return values;
}

}  // namespace sphereview
