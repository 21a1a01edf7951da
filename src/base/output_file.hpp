// Whole-or-nothing output: a file that appears is complete.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace sphereview {

// When a file counts as written: once the disk has it and its name, which takes some milliseconds, or once the system has them, so
// that a power cut may lose the file or leave it empty.
enum class Durability { on_disk, in_system };

// What happens if an output's folder is missing.
enum class MissingFolder { refused, made };

// Writes `bytes` to `path`, or to standard output for "-", also if that is non-blocking. A regular file is written under a hidden
// name beside and renamed; it keeps the mode of the file that it replaces, and symbolic links are followed. Devices and FIFOs are
// written directly. Other hard links of a file keep the old bytes. Throws OutputError.
void write_output(const std::string& path, std::string_view bytes, Durability durability = Durability::on_disk,
                  MissingFolder missing = MissingFolder::refused);

// The same for files that must be regular, such as the program's own: throws OutputError if something else is there. A device would
// swallow the bytes, and a FIFO without a reader would block.
void write_regular_file(const std::string& path, std::string_view bytes, Durability durability = Durability::on_disk);

// Appends to a file that nobody else writes, and syncs by `durability`, which does nothing for a pipe. False, with errno set, on
// failure.
bool append(std::FILE* file, std::string_view bytes, Durability durability);

// The place of an output that another program writes, and that appears whole or not at all as well.
class OutputPlace {
public:
    // Makes an empty file under a hidden name beside `path`. Throws OutputError, also if `path` is something other than a regular
    // file.
    explicit OutputPlace(const std::string& path);
    // Removes the file, unless it was taken.
    ~OutputPlace();
    OutputPlace(const OutputPlace&) = delete;
    OutputPlace& operator=(const OutputPlace&) = delete;

    // The file to write into.
    std::string temporary() const;
    // Renames the file to `path`. Call once, when nobody writes any more. Throws OutputError.
    void take(Durability durability);

private:
    std::string path_;
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    bool taken_ = false;
};

// Throws OutputError if `path` plainly cannot be an output: it is a folder, has no folder, or cannot be written to. For early
// messages before long work; makes nothing, and write_output checks again.
void check_output(const std::string& path, MissingFolder missing = MissingFolder::refused);

// Whether the name means a device in any folder, as NUL does on Windows.
bool is_device_name(const std::filesystem::path& path);

enum class FileUse { input, output };

// Equal for two paths to one file: the absolute path with links followed, of a file that exists or not. Empty for devices, FIFOs
// and "-", which two users can share. Differs for hard links, which a rename separates. Throws OutputError when the system does not
// tell the current folder, or where the links of an output lead.
std::string file_identity(const std::string& path, FileUse use);

}  // namespace sphereview
