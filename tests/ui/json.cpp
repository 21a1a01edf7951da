#include "ui/json.hpp"

#include <nlohmann/json.hpp>
#include <ostream>

namespace sphereview::test {

namespace {

using Parsed = nlohmann::json;

std::shared_ptr<const void> owned(Parsed value) { return std::make_shared<const Parsed>(std::move(value)); }
const Parsed& parsed(const std::shared_ptr<const void>& value) { return *static_cast<const Parsed*>(value.get()); }

// Shares the whole value that `member` is a part of.
std::shared_ptr<const void> part(const std::shared_ptr<const void>& whole, const Parsed& member) { return {whole, &member}; }

}  // namespace

Json::Json(std::nullptr_t) : value_(owned(nullptr)) {}
Json::Json(bool value) : value_(owned(value)) {}
Json::Json(const std::string& text) : value_(owned(text)) {}
Json::Json(std::initializer_list<Json> values) {
    Parsed list = Parsed::array();
    for (const Json& value : values) list.push_back(parsed(value.value_));
    value_ = owned(std::move(list));
}
Json Json::from_number(double value) { return Json(owned(value)); }
Json Json::parse(const std::string& text) { return Json(owned(Parsed::parse(text))); }

Json Json::at(const std::string& name) const { return Json(part(value_, parsed(value_).at(name))); }
Json Json::operator[](std::size_t index) const { return Json(part(value_, parsed(value_).at(index))); }
Json Json::back() const { return Json(part(value_, parsed(value_).back())); }
bool Json::contains(const std::string& name) const { return parsed(value_).contains(name); }
bool Json::empty() const { return parsed(value_).empty(); }
double Json::number() const { return parsed(value_).get<double>(); }
std::string Json::text() const { return parsed(value_).get<std::string>(); }
std::string Json::dump() const { return parsed(value_).dump(); }

bool operator==(const Json& a, const Json& b) { return parsed(a.value_) == parsed(b.value_); }
std::ostream& operator<<(std::ostream& stream, const Json& json) { return stream << json.dump(); }

}  // namespace sphereview::test
