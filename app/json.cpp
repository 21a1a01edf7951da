#include "app/json.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>
#include <variant>

#include "base/error.hpp"
#include "base/nesting.hpp"
#include "base/text.hpp"

namespace sphereview {

// The tree is our own: the library's allocates in its destructor.
struct Json::Tree {
    using List = std::vector<Json>;
    using Members = std::vector<std::pair<std::string, Json>>;

    std::variant<bool, double, std::int64_t, std::string, List, Members> held;

    template <typename Value>
    static Json of(Value value) {
        return Json(std::make_shared<Tree>(Tree{std::move(value)}));
    }
    // Null for one of another type.
    template <typename Value>
    static const Value* in(const Json& json) {
        return json.tree_ == nullptr ? nullptr : std::get_if<Value>(&json.tree_->held);
    }
    template <typename Value>
    static std::optional<Value> copied(const Json& json) {
        const Value* value = in<Value>(json);
        return value != nullptr ? std::optional(*value) : std::nullopt;
    }
    // To be changed; null becomes an empty one, and what is shared is copied before.
    template <typename Value>
    static Value& changed(Json& json) {
        if (json.tree_ == nullptr) {
            json = of(Value());
        } else if (json.tree_.use_count() > 1) {
            json.tree_ = std::make_shared<Tree>(*json.tree_);
        }
        return std::get<Value>(json.tree_->held);
    }

    static Json& member(Members& members, const std::string& key) {
        const auto found = std::ranges::find(members, key, &Members::value_type::first);
        return found != members.end() ? found->second : members.emplace_back(key, Json()).second;
    }

    static void merge_equal_keys(Members& members);

    class Builder;
};

// Of members with one key the last value counts, in the place of the first. Sorted once: to search for each key as it comes would
// take time with the square of their number.
void Json::Tree::merge_equal_keys(Members& members) {
    std::vector<std::size_t> order(members.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t place) -> const std::string& { return members[place].first; });
    std::vector<bool> is_merged(members.size());
    for (std::size_t first = 0, i = 1; i < order.size(); ++i) {
        if (members[order[i]].first == members[order[first]].first) {
            members[order[first]].second = std::move(members[order[i]].second);
            is_merged[order[i]] = true;
        } else {
            first = i;
        }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
        if (is_merged[i]) continue;
        if (kept != i) members[kept] = std::move(members[i]);
        ++kept;
    }
    members.resize(kept);
}

// Makes the tree of what the library's parser finds.
class Json::Tree::Builder : public nlohmann::json_sax<nlohmann::json> {
public:
    Json take() { return std::move(root_); }
    std::size_t fault() const { return fault_; }

    bool null() override { return add(Json()); }
    bool boolean(bool value) override { return add(Json(value)); }
    bool number_integer(std::int64_t value) override { return add(Json(value)); }
    bool number_unsigned(std::uint64_t value) override {
        constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
        return add(value <= most ? Json(static_cast<std::int64_t>(value)) : Json(static_cast<double>(value)));
    }
    bool number_float(double value, const std::string&) override { return add(Json(value)); }
    bool string(std::string& value) override { return add(from_text(value)); }
    bool binary(nlohmann::json::binary_t&) override { return false; }
    bool start_object(std::size_t) override { return begin(object()); }
    bool key(std::string& value) override {
        open_.back().key = value;
        return true;
    }
    bool end_object() override { return end(); }
    bool start_array(std::size_t) override { return begin(array()); }
    bool end_array() override { return end(); }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception&) override {
        fault_ = position;
        return false;
    }

private:
    // A list or object that has not ended.
    struct Open {
        Json json;
        std::string key{};  // of the next member
    };

    bool add(Json value) {
        if (open_.empty()) {
            root_ = std::move(value);
        } else if (auto& [json, key] = open_.back(); json.is_object()) {
            changed<Members>(json).emplace_back(key, std::move(value));
        } else {
            json.push_back(value);
        }
        return true;
    }
    bool begin(Json json) {
        open_.push_back({std::move(json)});
        return true;
    }
    bool end() {
        Json ended = std::move(open_.back().json);
        open_.pop_back();
        if (ended.is_object()) merge_equal_keys(changed<Members>(ended));
        return add(std::move(ended));
    }

    Json root_{};
    std::vector<Open> open_{};
    std::size_t fault_ = 0;
};

namespace {

// A number or a text, as the library writes it.
template <typename Value>
std::string in_json(const Value& value) {
    return nlohmann::json(value).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

}  // namespace

Json::Json(std::nullptr_t) {}
Json::Json(bool value) : Json(Tree::of(value)) {}
Json::Json(double value) : Json(Tree::of(value)) {}
Json::Json(std::int64_t value) : Json(Tree::of(value)) {}
Json::Json(std::initializer_list<Json> values) {
    const auto is_member = [](const Json& value) {
        const auto* pair = Tree::in<Tree::List>(value);
        return pair != nullptr && pair->size() == 2 && Tree::in<std::string>(pair->front()) != nullptr;
    };
    const bool members = std::ranges::all_of(values, is_member);
    *this = members ? object() : array();
    for (const Json& value : values) {
        if (members) {
            const Tree::List& pair = *Tree::in<Tree::List>(value);
            set(*Tree::in<std::string>(pair[0]), pair[1]);
        } else {
            push_back(value);
        }
    }
}
Json Json::from_text(std::string_view text) { return Tree::of(std::string(text)); }
Json Json::array() { return Tree::of(Tree::List()); }
Json Json::object() { return Tree::of(Tree::Members()); }
Json Json::parse(std::string_view text, const std::string& name, TextPosition origin) {
    const auto fail = [&](std::size_t offset, const std::string& what) {
        throw InputError(place_in(name, position_at(text, offset, origin)) + what);
    };
    if (const auto deep = find_too_deep(text)) fail(deep->offset, "found values nested deeper than " + std::to_string(most_nested));
    Tree::Builder builder;
    if (!nlohmann::json::sax_parse(text, &builder)) fail(std::max<std::size_t>(builder.fault(), 1) - 1, "this is not JSON");
    return builder.take();
}

bool Json::is_null() const { return tree_ == nullptr; }
bool Json::is_object() const { return Tree::in<Tree::Members>(*this) != nullptr; }
std::optional<bool> Json::boolean() const { return Tree::copied<bool>(*this); }
std::optional<double> Json::number() const {
    if (const auto integer = whole()) return static_cast<double>(*integer);
    return Tree::copied<double>(*this);
}
std::optional<std::int64_t> Json::whole() const { return Tree::copied<std::int64_t>(*this); }
std::optional<std::string> Json::text() const { return Tree::copied<std::string>(*this); }
std::vector<Json> Json::list() const { return Tree::copied<Tree::List>(*this).value_or(Tree::List()); }
Json Json::operator[](std::string_view key) const {
    const auto* members = Tree::in<Tree::Members>(*this);
    if (members == nullptr) return {};
    const auto found = std::ranges::find(*members, key, &Tree::Members::value_type::first);
    return found == members->end() ? Json() : found->second;
}

void Json::set(std::string_view key, const Json& value) {
    Tree::member(Tree::changed<Tree::Members>(*this), std::string(key)) = value;
}
void Json::update(const Json& members) {
    if (const auto* others = Tree::in<Tree::Members>(members)) {
        for (const auto& [key, value] : *others) set(key, value);
    }
}
void Json::erase(std::string_view key) {
    std::erase_if(Tree::changed<Tree::Members>(*this), [&](const auto& member) { return member.first == key; });
}
void Json::push_back(const Json& value) { Tree::changed<Tree::List>(*this).push_back(value); }

std::string Json::dump(int indent) const {
    std::string text;
    dump_to(text, indent, 0);
    return text;
}

void Json::dump_to(std::string& text, int indent, int depth) const {
    // The parts between brackets, each on a line of its own where there is an indent.
    const auto parts = [&](char open, char close, const auto& all, const auto& dump_one) {
        const auto line = [&](int columns) {
            text += indent < 0 ? "" : '\n' + std::string(static_cast<std::size_t>(columns), ' ');
        };
        text += open;
        for (const auto& part : all) {
            if (&part != &all.front()) text += ',';
            line(indent * (depth + 1));
            dump_one(part);
        }
        if (!all.empty()) line(indent * depth);
        text += close;
    };
    if (const auto* list = Tree::in<Tree::List>(*this)) {
        parts('[', ']', *list, [&](const Json& part) { part.dump_to(text, indent, depth + 1); });
    } else if (const auto* members = Tree::in<Tree::Members>(*this)) {
        parts('{', '}', *members, [&](const auto& member) {
            text += in_json(member.first) + (indent < 0 ? ":" : ": ");
            member.second.dump_to(text, indent, depth + 1);
        });
    } else if (const auto* words = Tree::in<std::string>(*this)) {
        text += in_json(*words);
    } else if (const auto* real = Tree::in<double>(*this)) {
        text += in_json(*real);
    } else if (const auto value = boolean()) {
        text += *value ? "true" : "false";
    } else if (const auto integer = whole()) {
        text += std::to_string(*integer);
    } else {
        text += "null";
    }
}

bool is_utf8(std::string_view text) {
    try {
        static_cast<void>(nlohmann::json(text).dump());
        return true;
    } catch (const nlohmann::json::exception&) {
        return false;
    }
}

}  // namespace sphereview
