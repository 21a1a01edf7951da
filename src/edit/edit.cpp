#include "edit/edit.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "scene/numbered.hpp"

namespace sphereview {

namespace {

using Names = std::map<std::uint32_t, std::string>;
using Numbers = std::vector<std::uint32_t>;

// How sphere numbers change where spheres come in. Asked for ascending numbers, as all of these.
class AfterInsert {
public:
    explicit AfterInsert(const Numbers& inserted) : inserted_(inserted) {}
    std::uint32_t operator()(std::uint32_t number) {
        while (before_ < inserted_.size() && inserted_[before_] <= number + before_) ++before_;
        return number + static_cast<std::uint32_t>(before_);
    }

private:
    const Numbers& inserted_;
    std::size_t before_ = 0;  // how many come in before the number asked for
};

// How the numbers of those that stay change where spheres go out.
class AfterRemove {
public:
    explicit AfterRemove(const Numbers& removed) : removed_(removed) {}
    bool stays(std::uint32_t number) {
        while (before_ < removed_.size() && removed_[before_] < number) ++before_;
        return before_ == removed_.size() || removed_[before_] != number;
    }
    std::uint32_t operator()(std::uint32_t number) {
        stays(number);
        return number - static_cast<std::uint32_t>(before_);
    }

private:
    const Numbers& removed_;
    std::size_t before_ = 0;
};

std::uint32_t after_reorder(const ReorderSphere& edit, std::uint32_t number) {
    if (number == edit.from) return edit.to;
    if (edit.from < number && number <= edit.to) return number - 1;
    if (edit.to <= number && number < edit.from) return number + 1;
    return number;
}

// Gives the names of [first, last) other numbers, which ascend as the old ones do and stay between the neighbours'.
template <typename NewNumber>
void renumber(Names& names, Names::iterator first, Names::iterator last, NewNumber new_number) {
    std::vector<Names::node_type> nodes;
    while (first != last) nodes.push_back(names.extract(first++));
    for (Names::node_type& node : nodes) {
        node.key() = new_number(node.key());
        names.insert(last, std::move(node));
    }
}

[[maybe_unused]] bool ascend_below(const Numbers& numbers, std::size_t count) {
    return std::ranges::adjacent_find(numbers, std::ranges::greater_equal{}) == numbers.end() &&
           (numbers.empty() || numbers.back() < count);
}

// Each applies one kind of edit. What needs memory comes first, so that a lack of it leaves the scene whole.
struct Apply {
    Scene& scene;

    Edit operator()(ChangeSpheres& edit) const {
        assert(ascend_below(edit.numbers, scene.spheres.size()) && edit.numbers.size() == edit.spheres.size());
        for (std::size_t i = 0; i < edit.numbers.size(); ++i) std::swap(scene.spheres[edit.numbers[i]], edit.spheres[i]);
        return std::move(edit);
    }

    Edit operator()(InsertSpheres& edit) const {
        const std::size_t old_count = scene.spheres.size();
        assert(ascend_below(edit.numbers, old_count + edit.numbers.size()) && edit.numbers.size() == edit.spheres.size());
        if (edit.numbers.empty()) return RemoveSpheres{};
        Names new_names;
        for (std::size_t i = 0; i < edit.numbers.size(); ++i) {
            std::string& name = edit.spheres[i].name;
            if (!name.empty()) new_names.emplace_hint(new_names.end(), edit.numbers[i], std::move(name));
        }
        for (Property& property : scene.properties) reserve_values(property, old_count + edit.numbers.size());
        scene.spheres.reserve(old_count + edit.numbers.size());
        RemoveSpheres inverse;
        for (Property& property : scene.properties) {
            const auto* const labels = std::get_if<Labels>(&property.values);
            const std::size_t words = labels != nullptr ? labels->words.size() : 0;
            insert_values(property, edit.numbers, find_property(edit.properties, property.name));
            if (labels != nullptr && labels->words.size() > words) inverse.words.push_back({property.name, words});
        }
        renumber(scene.names, scene.names.lower_bound(edit.numbers.front()), scene.names.end(), AfterInsert(edit.numbers));
        scene.names.merge(new_names);
        make_room(scene.spheres, edit.numbers);
        for (std::size_t i = 0; i < edit.numbers.size(); ++i) scene.spheres[edit.numbers[i]] = edit.spheres[i].sphere;
        inverse.numbers = std::move(edit.numbers);
        return inverse;
    }

    Edit operator()(RemoveSpheres& edit) const {
        assert(ascend_below(edit.numbers, scene.spheres.size()));
        if (edit.numbers.empty()) return InsertSpheres{};
        std::vector<NamedSphere> removed(edit.numbers.size());
        std::vector<Property> values;
        values.reserve(scene.properties.size());
        for (const Property& property : scene.properties) values.push_back(values_of(property, edit.numbers));
        auto name = scene.names.lower_bound(edit.numbers.front());
        for (std::size_t i = 0; i < edit.numbers.size(); ++i) {
            removed[i].sphere = scene.spheres[edit.numbers[i]];
            while (name != scene.names.end() && name->first < edit.numbers[i]) ++name;
            if (name == scene.names.end() || name->first != edit.numbers[i]) continue;
            removed[i].name = std::move(name->second);
            name = scene.names.erase(name);
        }
        renumber(scene.names, scene.names.lower_bound(edit.numbers.front()), scene.names.end(), AfterRemove(edit.numbers));
        take_out(scene.spheres, edit.numbers);
        for (Property& property : scene.properties) remove_values(property, edit.numbers);
        for (const WordCount& count : edit.words) {
            const auto property = std::ranges::find(scene.properties, count.property, &Property::name);
            if (property != scene.properties.end()) std::get<Labels>(property->values).words.resize(count.words);
        }
        return InsertSpheres{std::move(edit.numbers), std::move(removed), std::move(values)};
    }

    Edit operator()(const ReorderSphere& edit) const {
        const auto [low, high] = std::minmax(edit.from, edit.to);
        assert(high < scene.spheres.size());
        move_one(scene.spheres, edit.from, edit.to);
        for (Property& property : scene.properties) move_value(property, edit.from, edit.to);
        Names::node_type moved = scene.names.extract(edit.from);
        renumber(scene.names, scene.names.lower_bound(low), scene.names.upper_bound(high),
                 [&](std::uint32_t number) { return after_reorder(edit, number); });
        if (!moved.empty()) {
            moved.key() = edit.to;
            scene.names.insert(std::move(moved));
        }
        return ReorderSphere{edit.to, edit.from};
    }

    Edit operator()(RenameSphere& edit) const {
        assert(edit.number < scene.spheres.size());
        const auto old = scene.names.find(edit.number);
        if (old == scene.names.end()) {
            if (!edit.name.empty()) scene.names.emplace(edit.number, std::move(edit.name));
            return RenameSphere{edit.number, ""};
        }
        std::swap(old->second, edit.name);
        if (old->second.empty()) scene.names.erase(old);
        return std::move(edit);
    }

    Edit operator()(ChangeCamera& edit) const { return std::swap(scene.camera, edit.camera), edit; }
    Edit operator()(ChangeBackground& edit) const { return std::swap(scene.background, edit.background), edit; }
    Edit operator()(ChangeLight& edit) const { return std::swap(scene.light, edit.light), edit; }
    Edit operator()(ChangeViews& edit) const { return std::swap(scene.views, edit.views), std::move(edit); }
    Edit operator()(ReplaceScene& edit) const { return std::swap(scene, edit.scene), std::move(edit); }
};

struct ChangesNothing {
    const Scene& scene;

    static bool same_views(const std::vector<SavedView>& a, const std::vector<SavedView>& b) {
        return std::ranges::equal(a, b, [](const SavedView& one, const SavedView& other) { return same_bits(one, other); });
    }

    bool operator()(const ChangeSpheres& edit) const {
        for (std::size_t i = 0; i < edit.numbers.size(); ++i) {
            if (!same_bits(scene.spheres[edit.numbers[i]], edit.spheres[i])) return false;
        }
        return true;
    }
    bool operator()(const InsertSpheres& edit) const { return edit.numbers.empty(); }
    bool operator()(const RemoveSpheres& edit) const { return edit.numbers.empty(); }
    bool operator()(const ReorderSphere& edit) const { return edit.from == edit.to; }
    bool operator()(const RenameSphere& edit) const {
        const auto old = scene.names.find(edit.number);
        return old == scene.names.end() ? edit.name.empty() : edit.name == old->second;
    }
    bool operator()(const ChangeCamera& edit) const { return same_bits(edit.camera, scene.camera); }
    bool operator()(const ChangeBackground& edit) const { return edit.background == scene.background; }
    bool operator()(const ChangeLight& edit) const { return same_bits(edit.light, scene.light); }
    bool operator()(const ChangeViews& edit) const { return same_views(edit.views, scene.views); }
    bool operator()(const ReplaceScene& edit) const {
        const auto same = [](const Sphere& a, const Sphere& b) { return same_bits(a, b); };
        return std::ranges::equal(edit.scene.spheres, scene.spheres, same) && edit.scene.names == scene.names &&
               edit.scene.background == scene.background && same_bits(edit.scene.camera, scene.camera) &&
               same_bits(edit.scene.light, scene.light) && same_views(edit.scene.views, scene.views) &&
               edit.scene.properties == scene.properties;
    }
};

}  // namespace

Edit apply(Edit edit, Scene& scene) { return std::visit(Apply{scene}, edit); }

bool changes_nothing(const Edit& edit, const Scene& scene) { return std::visit(ChangesNothing{scene}, edit); }

std::vector<std::uint32_t> numbers_concerned(const Edit& edit) {
    if (const auto* change = std::get_if<ChangeSpheres>(&edit)) return change->numbers;
    if (const auto* insert = std::get_if<InsertSpheres>(&edit)) return insert->numbers;
    if (const auto* reorder = std::get_if<ReorderSphere>(&edit)) return {reorder->to};
    if (const auto* rename = std::get_if<RenameSphere>(&edit)) return {rename->number};
    return {};
}

std::vector<std::uint32_t> numbers_after(const Edit& edit, std::vector<std::uint32_t> numbers) {
    if (const auto* insert = std::get_if<InsertSpheres>(&edit)) {
        std::ranges::transform(numbers, numbers.begin(), AfterInsert(insert->numbers));
    } else if (const auto* remove = std::get_if<RemoveSpheres>(&edit)) {
        AfterRemove after(remove->numbers);
        std::erase_if(numbers, [&](std::uint32_t number) { return !after.stays(number); });
        std::ranges::transform(numbers, numbers.begin(), AfterRemove(remove->numbers));
    } else if (const auto* reorder = std::get_if<ReorderSphere>(&edit)) {
        for (std::uint32_t& number : numbers) number = after_reorder(*reorder, number);
        std::ranges::sort(numbers);
    } else if (const auto* replace = std::get_if<ReplaceScene>(&edit)) {
        std::erase_if(numbers, [&](std::uint32_t number) { return number >= replace->scene.spheres.size(); });
    }
    return numbers;
}

}  // namespace sphereview
