// sphereview doctor: what works on this machine, and why the rest does not.
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string_view>

#include "app/failure.hpp"
#include "app/film.hpp"
#include "app/json.hpp"
#include "app/options.hpp"
#include "app/render_picture.hpp"
#include "app/version.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/program.hpp"
#include "base/text.hpp"
#include "base/user_folders.hpp"
#include "formats/lines.hpp"
#include "gpu/live_picture.hpp"
#include "image/compare.hpp"
#include "platform/gl_context.hpp"

namespace sphereview {

namespace {

constexpr PictureSize test_size{64, 48};
constexpr Background test_background{{10, 20, 30}, false};

// A sphere in front of a part of another, one around the eye's side, one behind the eye.
Scene test_scene() {
    Scene scene;
    scene.spheres = {{{0.0, 0.0, 300.0}, 80.0, {255, 0, 0}},
                     {{40.0, 30.0, 150.0}, 20.0, {0, 200, 100}},
                     {{-120.0, -60.0, 260.0}, 50.0, {1, 2, 3}},
                     {{0.0, 0.0, -100.0}, 50.0, {255, 255, 255}}};
    return scene;
}

Image render_test(OpenBackend& backend) {
    Timings timings;
    PictureFacts facts;
    const Scene scene = test_scene();
    return render_picture(backend, scene, drawn_spheres(scene), {scene.camera, test_size, test_background, true}, timings, facts,
                          [](double) {});
}

// As a window shows it.
Image show_test() {
    const auto [width, height] = test_size;
    const Texture colors = Texture::make();
    glBindTexture(GL_TEXTURE_2D, colors.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    const Framebuffer window = Framebuffer::make();
    glBindFramebuffer(GL_FRAMEBUFFER, window.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colors.name(), 0);
    LivePicture live;
    live.update(Document(test_scene()), {test_scene().camera, test_size}, 1);
    live.show({0, 0, width, height}, test_background, {});
    // The bottom row of the window comes first.
    Image picture(width, height, 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int y = 0; y < height; ++y) {
        glReadPixels(0, height - 1 - y, width, 1, GL_RGBA, GL_UNSIGNED_BYTE, picture.at(0, y));
    }
    check_gl("showing");
    return picture;
}

Json describe_context(const GlContext& context, const GpuRenderer& gpu) {
    const GlDescription gl = describe_gl();
    return {{"vendor", gl.vendor},
            {"renderer", gl.renderer},
            {"version", gl.version},
            {"glsl", gl.glsl},
            {"software", context.is_software()},
            {"largest_uniform_block_bytes", gl.largest_uniform_block},
            {"spheres_in_uniform_block", gpu.uniform_capacity()},
            {"largest_texture_side", gl.largest_texture_side},
            {"largest_viewport", gl.largest_viewport}};
}

void check_pixels(const Image& picture, const Image& expected, const std::string& what) {
    const Comparison comparison = compare(picture, expected);
    if (!comparison.equal()) throw RenderError(what + " is wrong: " + describe(comparison));
}

Json probe_gl(Backend backend, const std::function<std::unique_ptr<GlContext>()>& open_context) {
    require_address_space_for_gl();
    OpenBackend cpu;
    const Image expected = render_test(cpu);
    OpenBackend open;
    Timings timings;
    open.context = open_context();
    open.backend = backend;
    open.gpu.emplace(timings);
    Json result = {{"works", true}};
    result.update(describe_context(*open.context, *open.gpu));
    check_pixels(render_test(open), expected, "a test picture");
    check_pixels(show_test(), expected, "the same picture in a window");
    return result;
}

// Each probe renders a small scene, checks every pixel and returns {"works": true, "renderer", ...limits}, or throws RenderError.
Json probe_cpu() {
    OpenBackend cpu;
    const Image picture = render_test(cpu);
    // Where the red sphere, the green one and the background are follows from the scene.
    const auto is = [&](int x, int y, Color c) {
        const std::uint8_t* at = picture.at(x, y);
        return at[0] == c.r && at[1] == c.g && at[2] == c.b;
    };
    if (!is(32, 24, {255, 0, 0}) || !is(44, 14, {0, 200, 100}) || !is(0, 0, test_background.color)) {
        throw RenderError("a test picture came out wrong");
    }
    return {{"works", true}, {"renderer", "the CPU renderer"}};
}

// `index`: into list_egl().
Json probe_egl(std::size_t index) {
    const std::vector<EglDevice> devices = list_egl_devices();
    if (index >= devices.size()) throw RenderError("EGL no longer offers it");
    return probe_gl(Backend::egl, [&] { return open_egl(devices[index]); });
}

// What EGL offers: {"devices": [{"name", "device", "software"}]}.
Json list_egl() {
    Json devices = Json::array();
    for (const EglDevice& device : list_egl_devices()) {
        devices.push_back({{"name", device.name},
                           {"device", device.kind == EglDevice::Kind::device ? Json(device.index) : Json(nullptr)},
                           {"software", device.software}});
    }
    return {{"devices", devices}};
}

bool works(const Json& row) { return row["works"].boolean() == true; }
std::string text_of(const Json& row, const char* key) { return row[key].text().value_or(""); }
std::string number_of(const Json& row, const char* key) { return std::to_string(row[key].whole().value_or(0)); }

// Where the answer of a probe begins among what a driver may have written to standard output.
constexpr std::string_view answer_begin = "\n{";

// The probe with one of the names that diagnose() uses, and its answer as text, which a process hands to another.
std::string probe(const std::string& name) {
    Json result;
    try {
        result = name == "egl"      ? list_egl()
                 : name == "osmesa" ? probe_gl(Backend::osmesa, open_osmesa)
                 : name == "wgl"    ? probe_gl(Backend::wgl, open_wgl)
                 : name == "cpu"    ? probe_cpu()
                                    : probe_egl(std::strtoul(name.c_str(), nullptr, 10));
    } catch (const RenderError& error) {
        result = {{"works", false}, {"reason", error.what()}, {"fault", static_cast<int>(error.fault)}};
    } catch (...) {
        result = {
            {"works", false}, {"reason", describe_current_exception().message}, {"fault", static_cast<int>(RenderFault::other)}};
    }
    return result.dump();
}

std::chrono::milliseconds in_milliseconds(double seconds) {
    return std::chrono::milliseconds(static_cast<long long>(seconds * 1000.0));
}

// Probes in a child process, so that a driver that hangs or crashes ends the child alone. Where no child can be started, probes in
// this process.
Json probe_apart(const std::string& name, double timeout_seconds) {
    const std::string culprit = name == "cpu" ? "the CPU renderer" : "the driver";
    const auto limit = in_milliseconds(timeout_seconds);
    ProgramResult result;
    try {
        result = run_program(text_from(program_file()), {"doctor", "--probe", name}, limit);
    } catch (const OutputError&) {
        result.output = probe(name);
    }
    const auto failed = [&](RenderFault fault, const std::string& reason) {
        const std::string_view said = last_line(trimmed(result.errors));
        const std::string why = culprit + reason + (said.empty() ? "" : "; it said: " + std::string(said));
        return Json{{"works", false}, {"reason", why}, {"fault", static_cast<int>(fault)}};
    };
    using End = ProgramResult::End;
    if (result.end == End::timed_out) {
        return failed(RenderFault::no_answer, " gave no answer within " + shortest(timeout_seconds) + " s");
    }
    if (result.end == End::crashed) return failed(RenderFault::crash, " crashed (signal " + std::to_string(result.code) + ")");
    Json row;
    try {
        row = Json::parse(std::string_view(result.output).substr(result.output.rfind(answer_begin) + 1), "the probe's answer");
    } catch (const InputError&) {
        // A driver ended the process before the answer was whole.
    }
    if (result.end == End::exited || !row.is_object()) {
        return failed(RenderFault::exit, " ended the program (status " + std::to_string(result.code) + ")");
    }
    return row;
}

// What a person can do about the backend of `row`, which does not work; `earlier` are the rows before it.
std::string advice(const Json& row, const Json& earlier) {
    const auto fault = static_cast<RenderFault>(row["fault"].whole().value_or(0));
    const std::string backend = text_of(row, "backend");
    const bool slow = fault == RenderFault::no_answer;
    if (backend == "wgl" && !slow) return "install the driver of the graphics card's maker, or use --backend cpu";
    if (backend == "cpu") {
        return slow ? "allow it more time with --timeout" : "report this: the CPU renderer needs nothing but a CPU";
    }
    if (fault == RenderFault::little_memory) return "raise that limit, or use --backend cpu";
    const bool egl = backend == "egl";
    if (fault == RenderFault::no_library) {
        return egl ? "install libEGL and a driver (Debian: apt install libegl1 libgl1-mesa-dri)"
                   : "install OSMesa (Debian 12: apt install libosmesa6; Mesa 25.1 and later have none: EGL serves instead)";
    }
    if (slow || fault == RenderFault::crash || fault == RenderFault::exit) {
        return std::string(egl ? "update the driver, or choose another with --device N or --backend"
                               : "update Mesa, or use --backend cpu") +
               (slow ? "; if it is only slow, allow it more time with --timeout" : "");
    }
    if (row["name"].text() == default_display_name) {
        for (const Json& other : earlier.list()) {
            if (other["backend"].text() == "egl" && works(other)) {
                return "nothing: without X or Wayland it is seldom there, and " + text_of(other, "name") + " works";
            }
        }
    }
    if (fault == RenderFault::no_driver) return "install a driver for it (Debian: apt install libgl1-mesa-dri)";
    if (fault == RenderFault::old_opengl) return "it needs OpenGL 3.3: update the driver, or use --backend cpu";
    return "update the driver, or use --backend cpu";
}

Json diagnose(double timeout_seconds) {
    Json rows = Json::array();
    const auto add = [&](const std::string& backend, const std::string& name, const Json& device, const Json& probed) {
        Json row = {{"backend", backend}, {"name", name}, {"device", device}};
        row.update(probed);
        if (!works(row)) row.set("advice", advice(row, rows));
        row.erase("fault");
        rows.push_back(row);
    };
#ifdef _WIN32
    add("wgl", "WGL", nullptr, probe_apart("wgl", timeout_seconds));
#else
    const Json egl = probe_apart("egl", timeout_seconds);
    if (egl["devices"].is_null()) {
        add("egl", "EGL", nullptr, egl);
    } else {
        const std::vector<Json> devices = egl["devices"].list();
        for (std::size_t i = 0; i < devices.size(); ++i) {
            add("egl", text_of(devices[i], "name"), devices[i]["device"], probe_apart(std::to_string(i), timeout_seconds));
        }
    }
    add("osmesa", "OSMesa", nullptr, probe_apart("osmesa", timeout_seconds));
#endif
    add("cpu", "CPU", nullptr, probe_apart("cpu", timeout_seconds));
    return rows;
}

std::string in_words(const Json& rows, const FilmEncoder& films) {
    std::string text = "sphereview " + std::string(version) + "\n";
    const auto line = [&](const char* label, const std::string& value) {
        text += "    " + std::string(label) + on_one_line(value) + "\n";
    };
    for (const Json& row : rows.list()) {
        text += "\n" + on_one_line(text_of(row, "name")) + ": " + (works(row) ? "works" : "does not work") + "\n";
        if (!works(row)) {
            line("why:       ", text_of(row, "reason"));
            line("try:       ", text_of(row, "advice"));
            continue;
        }
        line("renderer:  ", text_of(row, "renderer"));
        if (row["vendor"].is_null()) continue;
        line("vendor:    ", text_of(row, "vendor"));
        line("OpenGL:    ", text_of(row, "version") + ", GLSL " + text_of(row, "glsl"));
        line("software:  ", row["software"].boolean() == true ? "yes" : "no");
        line("limits:    ", "uniform block " + number_of(row, "largest_uniform_block_bytes") + " bytes (" +
                                number_of(row, "spheres_in_uniform_block") + " spheres used), texture side " +
                                number_of(row, "largest_texture_side"));
        const std::string device = row["device"].is_null() ? "" : " --device " + number_of(row, "device");
        line("use:       ", "--backend " + text_of(row, "backend") + device);
    }
    text += "\nFilms: " + std::string(films.endings.empty() ? "do not work" : films.lacks.empty() ? "work" : "work in part") + "\n";
    if (films.endings.empty()) {
        line("why:       ", films.fault);
        line("try:       ", "install it (Debian: apt install ffmpeg), or give another encoder what render -o - writes");
    } else {
        line("program:   ", films.program);
        line("makes:     ", joined(films.endings, ", "));
        if (!films.lacks.empty()) line("lacks:     ", joined(films.lacks, ", "));
        line("use:       ", "render --movie");
    }
    return text;
}

}  // namespace

ExitCode run_doctor(const DoctorOptions& options) {
    const std::string out(standard_stream);
    if (options.probe) {
        end_with_input();
        write_output(out, "\n" + probe(*options.probe));
        return ExitCode::done;
    }
    const Json rows = diagnose(options.timeout_seconds);
    bool any = false;
    for (const Json& row : rows.list()) any = any || works(row);
    const FilmEncoder films = ask_film_encoder(in_milliseconds(options.timeout_seconds));
    const Json report = {{"version", version},
                         {"backends", rows},
                         {"film_encoder", films.endings.empty() ? Json(nullptr) : Json(films.program)},
                         {"film_endings", films.endings}};
    write_output(out, options.json ? report.dump() + "\n" : in_words(rows, films));
    return any ? ExitCode::done : ExitCode::no_renderer;
}

}  // namespace sphereview
