// A record of what changed under which revision of a scene, for code that keeps something made from an earlier one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "edit/edit.hpp"

namespace sphereview {

// What differs between the scenes of two revisions, to the bit, except that spheres that came and went again, or changed places
// and changed back, are `order` all the same, and that after a change of very many spheres all count as changed. Names are left
// out: no picture shows them.
struct ChangesSince {
    bool order = false;  // spheres came, went or changed places: nothing of the old numbers holds
    // With `order`, where one edit that let few come or go is all that happened to the spheres: the numbers that those have that
    // came, or had that went, ascending. The others kept their values, and their order.
    std::vector<std::uint32_t> came;
    std::vector<std::uint32_t> went;
    std::vector<std::uint32_t> spheres;  // unless `order`: those that got other values, ascending
    bool geometry = false;  // of `spheres`: a centre, a radius or whether it is hidden; else only colours. With `order` true
    bool camera = false;
    bool background = false;
    bool light = false;

    bool none() const { return !order && spheres.empty() && !camera && !background && !light; }
};

// What one edit changed: the old values.
struct LoggedChange {
    bool order = false;
    std::vector<std::uint32_t> came;  // as in ChangesSince
    std::vector<std::uint32_t> went;
    ChangeSpheres spheres;  // unless `order`
    // So many spheres that their old values are not kept, which a million of them would be in memory a second time; and whether
    // a centre, a radius or what is hidden changed.
    bool many = false;
    bool many_geometry = false;
    std::optional<Camera> camera;
    std::optional<Background> background;
    std::optional<Light> light;
};

// Of the edit that led to `scene` and that `inverse` takes back.
LoggedChange change_undone_by(const Edit& inverse, const Scene& scene);

class ChangeLog {
public:
    // How many changes are remembered, and how many old values of spheres in all.
    static constexpr std::size_t most_changes = 1024;
    static constexpr std::size_t most_spheres = 65536;

    // The change led from that revision to the next one. Revisions ascend.
    void add(std::uint64_t revision, LoggedChange change);

    // How `scene`, the present one, differs from that earlier revision's. Everything, where that is not, or no longer, known.
    ChangesSince since(std::uint64_t revision, const Scene& scene) const;

private:
    struct Entry {
        std::uint64_t revision;  // of the scene before the change
        LoggedChange change;
    };

    std::deque<Entry> entries_;
    static std::size_t weight(const LoggedChange& change);

    std::size_t sphere_count_ = 0;  // in all entries
};

}  // namespace sphereview
