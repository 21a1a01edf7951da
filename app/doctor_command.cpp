// sphereview doctor: what works on this machine, and why the rest does not.
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/options.hpp"
#include "app/probe.hpp"
#include "app/version.hpp"
#include "base/child_process.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"
#include "platform/gl_context.hpp"

namespace sphereview {

namespace {

using Json = nlohmann::ordered_json;

std::string last_line(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

// Probes in a child process, so that a driver that hangs or crashes ends only the child.
Json probe_apart(const std::string& what, double timeout_seconds) {
    const std::string culprit = what == "cpu" ? "the CPU renderer" : "the driver";
    const auto limit = std::chrono::milliseconds(static_cast<long long>(timeout_seconds * 1000.0));
    const ChildResult child = run_self({"doctor", "--probe", what}, limit);
    const auto failed = [&](const std::string& reason) {
        const std::string said = last_line(child.errors);
        return Json{{"works", false}, {"reason", reason + (said.empty() ? "" : "; it said: " + said)}};
    };
    switch (child.end) {
        case ChildResult::End::not_started: return probe(what);
        case ChildResult::End::timed_out: return failed(culprit + " gave no answer within " + shortest(timeout_seconds) + " s");
        case ChildResult::End::killed_by_signal: return failed(culprit + " crashed (signal " + std::to_string(child.code) + ")");
        case ChildResult::End::exited: break;
    }
    Json result = Json::parse(child.output, nullptr, false);
    if (result.is_object()) return result;
    return failed(culprit + " ended the program (status " + std::to_string(child.code) + ")");
}

// What a person can do about the backend of `row`, which does not work; `earlier` are the rows before it.
std::string advice(const Json& row, const Json& earlier) {
    const std::string backend = row["backend"].get<std::string>();
    const std::string reason = row.value("reason", "");
    const auto says = [&](const char* words) { return reason.find(words) != std::string::npos; };
    if (backend == "cpu") {
        return says("no answer") ? "allow it more time with --timeout" : "report this: the CPU renderer needs nothing but a CPU";
    }
    if (says("libEGL cannot be opened")) return "install libEGL and a driver (Debian: apt install libegl1 libgl1-mesa-dri)";
    if (says("libOSMesa cannot be opened")) {
        return "install OSMesa (Debian 12: apt install libosmesa6; Mesa 25.1 and later have none: EGL serves instead)";
    }
    if (says("no answer") || says("crashed") || says("ended the program")) {
        const std::string patience = says("no answer") ? "; if it is only slow, allow it more time with --timeout" : "";
        return (backend == "egl" ? "update the driver, or choose another with --device N or --backend"
                                 : "update Mesa, or use --backend cpu") +
               patience;
    }
    if (row["name"] == default_display_name) {
        for (const Json& other : earlier) {
            if (other["backend"] == "egl" && other["works"].get<bool>()) {
                return "nothing: without X or Wayland it is seldom there, and " + other["name"].get<std::string>() + " works";
            }
        }
    }
    if (says("eglInitialize") || says("opening the display"))
        return "install a driver for it (Debian: apt install libgl1-mesa-dri)";
    if (says("3.3")) return "it needs OpenGL 3.3: update the driver, or use --backend cpu";
    return "update the driver, or use --backend cpu";
}

Json diagnose(double timeout_seconds) {
    Json rows = Json::array();
    const auto add = [&](const std::string& backend, const std::string& name, const Json& device, const Json& result) {
        Json row = {{"backend", backend}, {"name", name}, {"device", device}};
        row.update(result);
        if (!row["works"].get<bool>()) row["advice"] = advice(row, rows);
        rows.push_back(row);
    };
    const Json egl = probe_apart("egl", timeout_seconds);
    if (!egl.contains("devices")) {
        add("egl", "EGL", nullptr, egl);
    } else {
        for (std::size_t i = 0; i < egl["devices"].size(); ++i) {
            const Json& device = egl["devices"][i];
            add("egl", device["name"].get<std::string>(), device["device"],
                probe_apart("egl " + std::to_string(i), timeout_seconds));
        }
    }
    add("osmesa", "OSMesa", nullptr, probe_apart("osmesa", timeout_seconds));
    add("cpu", "CPU", nullptr, probe_apart("cpu", timeout_seconds));
    return rows;
}

std::string in_words(const Json& rows) {
    std::string text = "sphereview " + std::string(version) + "\n";
    const auto line = [&](const char* label, const std::string& value) { text += "    " + std::string(label) + value + "\n"; };
    for (const Json& row : rows) {
        const bool works = row["works"].get<bool>();
        text += "\n" + row["name"].get<std::string>() + ": " + (works ? "works" : "does not work") + "\n";
        if (!works) {
            line("why:       ", row.value("reason", ""));
            line("try:       ", row.value("advice", ""));
            continue;
        }
        line("renderer:  ", row.value("renderer", ""));
        if (!row.contains("vendor")) continue;
        line("vendor:    ", row.value("vendor", ""));
        line("OpenGL:    ", row.value("version", "") + ", GLSL " + row.value("glsl", ""));
        line("software:  ", row.value("software", false) ? "yes" : "no");
        line("limits:    ", "uniform block " + std::to_string(row.value("largest_uniform_block_bytes", 0)) + " bytes (" +
                                std::to_string(row.value("spheres_in_uniform_block", 0)) + " spheres used), texture side " +
                                std::to_string(row.value("largest_texture_side", 0)));
        const std::string device = row["device"].is_null() ? "" : " --device " + std::to_string(row["device"].get<int>());
        line("use:       ", "--backend " + row["backend"].get<std::string>() + device);
    }
    return text;
}

}  // namespace

ExitCode run_doctor(const DoctorOptions& options) {
    const std::string out(standard_stream);
    if (!options.probe.empty()) {
        end_with_parent();
        write_output(out, probe(options.probe).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
        return ExitCode::done;
    }
    const Json rows = diagnose(options.timeout_seconds);
    bool any = false;
    for (const Json& row : rows) any = any || row["works"].get<bool>();
    const Json report = {{"version", version}, {"backends", rows}};
    write_output(out, options.json ? report.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" : in_words(rows));
    return any ? ExitCode::done : ExitCode::no_renderer;
}

}  // namespace sphereview
