#include "python/errors.hpp"

#include <pybind11/pybind11.h>

#include <exception>
#include <new>
#include <string>

#include "app/failure.hpp"
#include "base/error.hpp"

namespace sphereview {

namespace py = pybind11;

namespace {

// A subclass that tells more, such as FileNotFoundError, where the number is known: Python chooses that by itself.
void set_os_error(const std::string& message, int number) {
    const py::object error = number == 0 ? py::handle(PyExc_OSError)(message) : py::handle(PyExc_OSError)(number, message);
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

void translate(std::exception_ptr thrown) {
    if (!thrown) return;
    try {
        std::rethrow_exception(thrown);
    } catch (const ReadError& error) {
        set_os_error(describe_current_exception().message, error.number);
    } catch (const OutputError&) {
        set_os_error(describe_current_exception().message, 0);
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

void translate_errors() { py::register_exception_translator(translate); }

}  // namespace sphereview
