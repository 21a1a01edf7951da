#include "gpu/scene_tables.hpp"

#include <algorithm>
#include <cassert>

#include "base/text.hpp"

namespace sphereview {

namespace {

// The buffer has the size that the shader declares, whatever is used: some drivers refuse to draw from less.
void put_into(const Buffer& buffer, const void* data, std::size_t used, std::size_t declared) {
    glBindBuffer(GL_UNIFORM_BUFFER, buffer.name());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(declared), nullptr, GL_DYNAMIC_DRAW);
    glBufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(used), data);
}

void bind_block(const Buffer& buffer, BlockBinding binding) {
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), buffer.name());
}

// Ascending places, with those joined that lie near to each other: an upload costs more than some candidates too many.
std::vector<Places> joined(const std::vector<Places>& places) {
    constexpr std::size_t near = 256;
    std::vector<Places> all;
    for (const Places& each : places) {
        if (all.empty() || each.first > all.back().first + all.back().count + near) {
            all.push_back(each);
        } else {
            all.back().count = std::max(all.back().count, each.first + each.count - all.back().first);
        }
    }
    return all;
}

// Ascending indices, as places.
std::vector<Places> runs(const std::vector<std::uint32_t>& indices) {
    std::vector<Places> all;
    all.reserve(indices.size());
    for (const std::uint32_t index : indices) all.push_back({index, 1});
    return joined(all);
}

float channel(std::uint8_t value) { return static_cast<float>(value) / 255.0F; }

}  // namespace

ShownColor shown_color(const Scene& scene, std::int32_t number, Shading shading) {
    const Color color = shading == Shading::id ? id_color(static_cast<std::uint32_t>(number))
                                               : scene.spheres[static_cast<std::size_t>(number)].color;
    return {color.r, color.g, color.b, 0};
}

std::vector<ShownColor> shown_colors(const Scene& scene, const DrawnSpheres& drawn, Shading shading) {
    std::vector<ShownColor> colors;
    colors.reserve(drawn.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        colors.push_back(shown_color(scene, drawn.number(i), shading));
    }
    return colors;
}

glm::vec4 shown_background(const Background& background) {
    const Color& color = background.color;
    return {channel(color.r), channel(color.g), channel(color.b), background.transparent ? 0.0F : 1.0F};
}

DrawBlock draw_block_of(const CandidateLists& lists, const Camera& camera, PictureSize size, int scale) {
    DrawBlock block;
    const FloatView view = float_view(camera, size, scale, gpu_unit);
    block.forward = glm::vec4(view.rays.forward, view.rays.reach);
    block.right = glm::vec4(view.rays.right, 0.0F);
    block.up = glm::vec4(view.rays.up, 0.0F);
    block.error_scale = view.error_scale;
    block.all_doubtful = view.all_doubtful ? 1 : 0;
    block.picture_size = {size.width, size.height};
    // At least one: of a picture without spheres, a single tile with an empty list.
    block.level_count = std::max(1, static_cast<std::int32_t>(lists.levels.size()));
    block.levels[0] = {30, 0, 0, 0};
    for (std::size_t i = 0; i < lists.levels.size(); ++i) {
        const TileLevel& level = lists.levels[i];
        block.levels[i] = {level.shift, level.across, static_cast<std::int32_t>(level.first), 0};
    }
    return block;
}

void upload_draw_block(const Buffer& buffer, const DrawBlock& block) {
    put_into(buffer, &block, sizeof block, sizeof block);
    bind_block(buffer, BlockBinding::draw);
}

SceneTables::SceneTables(const TextureBounds& bounds, std::size_t spare_spheres) : bounds_(bounds), spare_spheres_(spare_spheres) {
    uniform_capacity_ = std::min(gl_limit(GL_MAX_UNIFORM_BLOCK_SIZE), largest_uniform_block) / static_cast<int>(sizeof(glm::vec4));
    sphere_buffer_ = Buffer::make();
    color_buffer_ = Buffer::make();
}

SceneTables::Storage SceneTables::storage_for(const DrawnSpheres& spheres, const CandidateLists& lists) const {
    Storage storage;
    storage.in_block = fits_in_block(spheres);
    const std::size_t longest =
        std::max({storage.in_block ? 1 : spheres.size() + spare_spheres_, lists.candidates.size(), lists.begins.size()}) + 1;
    storage.tables = table_limits(longest, bounds_);
    if (longest > storage.tables.most_texels) {
        throw TooLarge("its textures hold tables of " + in_groups(storage.tables.most_texels) + " elements, the scene's " +
                       in_groups(spheres.size()) + " spheres need " + in_groups(longest));
    }
    return storage;
}

std::vector<std::string> SceneTables::defines_for(const DrawnSpheres& spheres, const CandidateLists& lists) const {
    const Storage storage = storage_for(spheres, lists);
    std::vector<std::string> defines = table_defines(storage.tables);
    if (storage.in_block) defines.push_back("SPHERE_CAPACITY " + std::to_string(uniform_capacity_));
    if (spheres.orthographic) defines.emplace_back("ORTHOGRAPHIC 1");
    return defines;
}

std::string SceneTables::storage() const {
    if (storage_.in_block) return "uniform buffer";
    return storage_.tables.shift ? "2D textures" : "buffer textures";
}

void SceneTables::upload(const DrawnSpheres& spheres, const CandidateLists& lists) {
    storage_ = storage_for(spheres, lists);
    if (storage_.in_block) {
        put_into(sphere_buffer_, spheres.center_radius.data(), spheres.size() * sizeof(glm::vec4),
                 static_cast<std::size_t>(uniform_capacity_) * sizeof(glm::vec4));
    } else {
        sphere_table_.upload(spheres.center_radius.data(), spheres.size(), TexelKind::vec4, TextureUnit::sphere_table,
                             storage_.tables, spare_spheres_);
    }
    candidate_table_.upload(lists.candidates.data(), lists.candidates.size(), TexelKind::uint_pair, TextureUnit::candidate_table,
                            storage_.tables);
    list_begin_table_.upload(lists.begins.data(), lists.begins.size(), TexelKind::uint, TextureUnit::list_begin_table,
                             storage_.tables);
    check_gl("uploading the spheres");
}

void SceneTables::upload_colors(std::span<const ShownColor> colors) {
    if (storage_.in_block) {
        std::vector<glm::vec4> floats;
        floats.reserve(colors.size());
        for (const ShownColor& c : colors) floats.emplace_back(channel(c[0]), channel(c[1]), channel(c[2]), channel(c[3]));
        put_into(color_buffer_, floats.data(), floats.size() * sizeof(glm::vec4),
                 static_cast<std::size_t>(uniform_capacity_) * sizeof(glm::vec4));
    } else {
        // The spheres' spare room, less those that came meanwhile, would do.
        color_table_.upload(colors.data(), colors.size(), TexelKind::rgba8, TextureUnit::color_table, storage_.tables,
                            spare_spheres_);
    }
    check_gl("uploading the colours");
}

void SceneTables::update(const DrawnSpheres& spheres, const CandidateLists& lists, const LiveLists::Changed& changed) {
    // In the uniform buffer no list takes edits; only what no list holds, such as the twin of a drawn sphere, can come or go.
    assert(!storage_.in_block || (changed.spheres.empty() && changed.candidates.empty()));
    for (const auto& [first, count] : runs(changed.spheres)) sphere_table_.update(&spheres.center_radius[first], first, count);
    for (const auto& [first, count] : joined(changed.candidates)) candidate_table_.update(&lists.candidates[first], first, count);
    check_gl("uploading an edit");
}

void SceneTables::update_colors(std::span<const ShownColor> colors, std::span<const std::uint32_t> indices) {
    if (storage_.in_block) {
        upload_colors(colors);
        return;
    }
    for (const std::uint32_t index : indices) color_table_.update(&colors[index], index, 1);
    check_gl("uploading colours");
}

void SceneTables::bind() const {
    if (storage_.in_block) {
        bind_block(sphere_buffer_, BlockBinding::spheres);
        bind_block(color_buffer_, BlockBinding::colors);
    } else {
        sphere_table_.bind(TextureUnit::sphere_table);
        color_table_.bind(TextureUnit::color_table);
    }
    candidate_table_.bind(TextureUnit::candidate_table);
    list_begin_table_.bind(TextureUnit::list_begin_table);
    glActiveTexture(GL_TEXTURE0);
}

}  // namespace sphereview
