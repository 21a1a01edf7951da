#include "python/errors.hpp"

#include <pybind11/pybind11.h>

#include <exception>
#include <new>
#include <string>

#include "app/failure.hpp"
#include "base/error.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace py = pybind11;

namespace {

// Python chooses a subclass that tells more, such as FileNotFoundError, by itself.
void set_os_error(const FileFault& fault) {
    const auto file = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeFSDefaultAndSize(fault.file.data(), static_cast<py::ssize_t>(fault.file.size())));
    if (!file) return;  // Python has its own error then
    const py::object error = py::handle(PyExc_OSError)(fault.number, on_one_line(fault.why), file);
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

void translate(std::exception_ptr thrown) {
    if (!thrown) return;
    try {
        std::rethrow_exception(thrown);
    } catch (const ReadError& error) {
        set_os_error(error.fault);
    } catch (const OutputError& error) {
        set_os_error(error.fault);
    } catch (const InputError&) {
        PyErr_SetString(PyExc_ValueError, describe_current_exception().message.c_str());
    } catch (const MemoryError&) {
        PyErr_SetString(PyExc_MemoryError, describe_current_exception().message.c_str());
    } catch (const RenderError&) {
        PyErr_SetString(PyExc_RuntimeError, describe_current_exception().message.c_str());
    }
    // All others, such as std::bad_alloc, are pybind11's.
}

}  // namespace

void wrong_argument(const char* name, const std::string& found, const std::string& expected) {
    throw InputError(std::string(name) + ": " + found_expected(found, expected) + did_you_mean(found, words_listed(expected)));
}

void translate_errors() { py::register_exception_translator(translate); }

}  // namespace sphereview
