// A value of the redraw log. The parser behind it is compiled once, in json.cpp.
#pragma once

#include <initializer_list>
#include <iosfwd>
#include <memory>
#include <string>
#include <type_traits>

namespace sphereview::test {

class Json {
public:
    Json(std::nullptr_t = nullptr);
    Json(bool value);
    template <typename Number>
    requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) Json(Number value)
        : Json(from_number(static_cast<double>(value))) {}
    Json(const char* text) : Json(std::string(text)) {}
    Json(const std::string& text);
    Json(std::initializer_list<Json> values);  // a list
    static Json array(std::initializer_list<Json> values = {}) { return values; }
    static Json parse(const std::string& text);

    // A member of an object, or of a list. Throws when there is none.
    Json at(const std::string& name) const;
    Json operator[](std::size_t index) const;
    Json back() const;
    bool contains(const std::string& name) const;
    bool is_null() const { return *this == nullptr; }
    bool empty() const;  // a list or an object without members, or null
    template <typename Value>
    Value get() const {
        if constexpr (std::is_same_v<Value, std::string>) {
            return text();
        } else {
            return static_cast<Value>(number());
        }
    }
    double number() const;
    std::string text() const;
    std::string dump() const;
    friend bool operator==(const Json& a, const Json& b);
    friend std::ostream& operator<<(std::ostream& stream, const Json& json);

private:
    explicit Json(std::shared_ptr<const void> value) : value_(std::move(value)) {}
    static Json from_number(double value);

    std::shared_ptr<const void> value_;  // the parser's
};

}  // namespace sphereview::test
