// sphereview doctor: what works on this machine, and why the rest does not.
#include <chrono>
#include <functional>
#include <string_view>

#include "app/failure.hpp"
#include "app/json.hpp"
#include "app/options.hpp"
#include "app/probe.hpp"
#include "app/version.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/isolated_call.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"
#include "platform/gl_context.hpp"

namespace sphereview {

namespace {

// What became of a probe: the row's facts, or the reason why it does not work, with its kind.
struct Probed {
    Json row;
    RenderFault fault = RenderFault::other;
};

bool works(const Json& row) { return row["works"].boolean() == true; }
std::string text_of(const Json& row, const char* key) { return row[key].text().value_or(""); }
std::string number_of(const Json& row, const char* key) { return std::to_string(row[key].whole().value_or(0)); }

// The same as text, which a process hands to another.
std::string probe(const std::function<Json()>& call) {
    Json result;
    try {
        result = call();
    } catch (const RenderError& error) {
        result = {{"works", false}, {"reason", error.what()}, {"fault", static_cast<int>(error.fault)}};
    } catch (...) {
        result = {
            {"works", false}, {"reason", describe_current_exception().message}, {"fault", static_cast<int>(RenderFault::other)}};
    }
    return result.dump();
}

// Probes in a copy of the process, so that a driver that hangs or crashes ends only the copy.
Probed probe_apart(const std::string& culprit, double timeout_seconds, const std::function<Json()>& call) {
    const auto limit = std::chrono::milliseconds(static_cast<long long>(timeout_seconds * 1000.0));
    const IsolatedResult result = call_isolated([&] { return probe(call); }, limit);
    const auto failed = [&](RenderFault fault, const std::string& reason) {
        std::string_view said = trimmed(result.errors);
        said = said.substr(said.find_last_of("\r\n") + 1);
        const std::string why = culprit + reason + (said.empty() ? "" : "; it said: " + std::string(said));
        return Probed{{{"works", false}, {"reason", why}}, fault};
    };
    using End = IsolatedResult::End;
    if (result.end == End::timed_out) {
        return failed(RenderFault::no_answer, " gave no answer within " + shortest(timeout_seconds) + " s");
    }
    if (result.end == End::crashed) return failed(RenderFault::crash, " crashed (signal " + std::to_string(result.code) + ")");
    Probed probed;
    try {
        probed.row = Json::parse(result.value, "the probe's answer");
    } catch (const InputError&) {
        // A driver ended the process before the answer was whole.
    }
    if (result.end == End::exited || !probed.row.is_object()) {
        return failed(RenderFault::exit, " ended the program (status " + std::to_string(result.code) + ")");
    }
    if (const auto fault = probed.row["fault"].whole()) probed.fault = static_cast<RenderFault>(*fault);
    probed.row.erase("fault");
    return probed;
}

// What a person can do about the backend of `row`, which does not work; `earlier` are the rows before it.
std::string advice(const Json& row, RenderFault fault, const Json& earlier) {
    const std::string backend = text_of(row, "backend");
    const bool slow = fault == RenderFault::no_answer;
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
    const auto add = [&](const std::string& backend, const std::string& name, const Json& device, const Probed& probed) {
        Json row = {{"backend", backend}, {"name", name}, {"device", device}};
        row.update(probed.row);
        if (!works(row)) row.set("advice", advice(row, probed.fault, rows));
        rows.push_back(row);
    };
    const std::string driver = "the driver";
    const Probed egl = probe_apart(driver, timeout_seconds, list_egl);
    if (egl.row["devices"].is_null()) {
        add("egl", "EGL", nullptr, egl);
    } else {
        const std::vector<Json> devices = egl.row["devices"].list();
        for (std::size_t i = 0; i < devices.size(); ++i) {
            add("egl", text_of(devices[i], "name"), devices[i]["device"],
                probe_apart(driver, timeout_seconds, [i] { return probe_egl(i); }));
        }
    }
    add("osmesa", "OSMesa", nullptr, probe_apart(driver, timeout_seconds, probe_osmesa));
    add("cpu", "CPU", nullptr, probe_apart("the CPU renderer", timeout_seconds, probe_cpu));
    return rows;
}

std::string in_words(const Json& rows) {
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
    return text;
}

}  // namespace

ExitCode run_doctor(const DoctorOptions& options) {
    const std::string out(standard_stream);
    const Json rows = diagnose(options.timeout_seconds);
    bool any = false;
    for (const Json& row : rows.list()) any = any || works(row);
    const Json report = {{"version", version}, {"backends", rows}};
    write_output(out, options.json ? report.dump() + "\n" : in_words(rows));
    return any ? ExitCode::done : ExitCode::no_renderer;
}

}  // namespace sphereview
