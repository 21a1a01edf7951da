#include "app/json.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/nesting.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

using Value = nlohmann::ordered_json;

std::shared_ptr<void> owned(Value value) { return std::make_shared<Value>(std::move(value)); }
const Value& shown(const std::shared_ptr<void>& value) { return *static_cast<const Value*>(value.get()); }
Value& changed(std::shared_ptr<void>& value) {
    if (value.use_count() > 1) value = owned(shown(value));
    return *static_cast<Value*>(value.get());
}

}  // namespace

Json::Json(std::nullptr_t) : value_(owned(nullptr)) {}
Json::Json(bool value) : value_(owned(value)) {}
Json::Json(double value) : value_(owned(value)) {}
Json::Json(std::int64_t value) : value_(owned(value)) {}
Json::Json(std::initializer_list<Json> values) {
    const bool members = std::ranges::all_of(values, [](const Json& value) {
        const Value& pair = shown(value.value_);
        return pair.is_array() && pair.size() == 2 && pair[0].is_string();
    });
    Value whole = members ? Value::object() : Value::array();
    for (const Json& value : values) {
        const Value& part = shown(value.value_);
        if (members) {
            whole[part[0].get<std::string>()] = part[1];
        } else {
            whole.push_back(part);
        }
    }
    value_ = owned(std::move(whole));
}
Json Json::from_text(std::string_view text) { return Json(owned(text)); }
Json Json::array() { return Json(owned(Value::array())); }
Json Json::object() { return Json(owned(Value::object())); }
Json Json::parse(std::string_view text, const std::string& name) {
    const auto fail = [&](std::size_t offset, const std::string& what) {
        throw InputError(place_in(name, position_at(text, offset)) + what);
    };
    if (const auto deep = find_too_deep(text)) fail(deep->offset, "found values nested deeper than " + std::to_string(most_nested));
    try {
        return Json(owned(Value::parse(text)));
    } catch (const Value::parse_error& error) {
        fail(error.byte == 0 ? 0 : error.byte - 1, "this is not JSON");
    }
    return {};
}

bool Json::is_null() const { return shown(value_).is_null(); }
bool Json::is_object() const { return shown(value_).is_object(); }
std::optional<bool> Json::boolean() const {
    const Value& value = shown(value_);
    return value.is_boolean() ? std::optional(value.get<bool>()) : std::nullopt;
}
std::optional<double> Json::number() const {
    const Value& value = shown(value_);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}
std::optional<std::int64_t> Json::whole() const {
    const Value& value = shown(value_);
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    if (!value.is_number_integer() || (value.is_number_unsigned() && value.get<std::uint64_t>() > most)) return {};
    return value.get<std::int64_t>();
}
std::optional<std::string> Json::text() const {
    const Value& value = shown(value_);
    return value.is_string() ? std::optional(value.get<std::string>()) : std::nullopt;
}
std::vector<Json> Json::list() const {
    std::vector<Json> values;
    if (!shown(value_).is_array()) return values;
    for (const Value& value : shown(value_)) values.push_back(Json(owned(value)));
    return values;
}
Json Json::operator[](std::string_view key) const {
    const auto member = shown(value_).find(std::string(key));
    return member == shown(value_).end() ? Json() : Json(owned(*member));
}

void Json::set(std::string_view key, const Json& value) { changed(value_)[std::string(key)] = shown(value.value_); }
void Json::update(const Json& members) { changed(value_).update(shown(members.value_)); }
void Json::erase(std::string_view key) { changed(value_).erase(std::string(key)); }
void Json::push_back(const Json& value) { changed(value_).push_back(shown(value.value_)); }

std::string Json::dump(int indent) const { return shown(value_).dump(indent, ' ', true, Value::error_handler_t::replace); }

bool is_utf8(std::string_view text) {
    try {
        static_cast<void>(Value(text).dump());
        return true;
    } catch (const Value::exception&) {
        return false;
    }
}

}  // namespace sphereview
