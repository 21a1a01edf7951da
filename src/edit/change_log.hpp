// A record of the changes between revisions of a scene, for code that keeps results made from an earlier revision.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "edit/edit.hpp"

namespace sphereview {

// The difference between the scenes of two revisions, to the bit. But spheres that came and went again, or changed places and back,
// count as `order`, and after a change of very many spheres all count as changed. Names are left out: no picture shows them.
struct ChangesSince {
    bool order = false;  // spheres came, went or changed places: old numbers do not hold
    // With `order`, if a single edit that added or removed few spheres is all that happened: the new numbers of the added and the
    // old numbers of the removed spheres, ascending. The others kept their values and order.
    std::vector<std::uint32_t> came;
    std::vector<std::uint32_t> went;
    std::vector<std::uint32_t> spheres;  // unless `order`: the changed spheres, ascending
    bool geometry = false;               // a centre, a radius or `hidden` has changed, not only colours; true with `order`
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
    // Too many spheres changed to keep the old values; and whether a centre, a radius or `hidden` changed.
    bool many = false;
    bool many_geometry = false;
    std::optional<Camera> camera;
    std::optional<Background> background;
    std::optional<Light> light;
};

// The change by the edit that led to `scene` and whose inverse is `inverse`.
LoggedChange change_undone_by(const Edit& inverse, const Scene& scene);

class ChangeLog {
public:
    // The most changes, and old values of spheres, that are remembered.
    static constexpr std::size_t most_changes = 1024;
    static constexpr std::size_t most_spheres = 65536;

    // The change led from that revision to the next one. Revisions ascend.
    void add(std::uint64_t revision, LoggedChange change);

    // How the present `scene` differs from an earlier revision's. Everything, if that revision is unknown or too old.
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
