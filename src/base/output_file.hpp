// Whole-or-nothing output: a file that appears under its name is complete.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace sphereview {

// Whether a file counts as written once the disk has it and its name, which takes some milliseconds, or already when the system
// has them: then a power cut may lose the file, or leave it empty.
enum class Durability { on_disk, in_system };

// What happens where the folder of an output is not there.
enum class MissingFolder { refused, made };

// Puts `bytes` into `path`, or onto standard output for "-", which is waited for where it is non-blocking. A regular file is
// written beside under a hidden name and renamed, keeping the mode of the file it replaces and following symbolic links; devices
// and FIFOs are written directly. Of a file with several names (hard links) only this one gets the bytes: the others keep the old
// ones. Throws OutputError.
void write_output(const std::string& path, std::string_view bytes, Durability durability = Durability::on_disk,
                  MissingFolder missing = MissingFolder::refused);

// The same for what must become a regular file, such as the program's own: throws OutputError where anything else stands. A device
// would swallow the bytes, and a FIFO that nobody reads would be waited for.
void write_regular_file(const std::string& path, std::string_view bytes, Durability durability = Durability::on_disk);

// Appends to a file that nothing else is written to, and waits for it by `durability`; false, with errno set, if that fails. In a
// pipe, or where there is no such thing, nothing is waited for.
bool append(std::FILE* file, std::string_view bytes, Durability durability);

// Where another program writes an output, which appears whole or not at all as well.
class OutputPlace {
public:
    // Makes an empty file under a hidden name beside `path`. Throws OutputError, also where something other than a regular file
    // stands there.
    explicit OutputPlace(const std::string& path);
    // Removes the file, unless it was taken.
    ~OutputPlace();
    OutputPlace(const OutputPlace&) = delete;
    OutputPlace& operator=(const OutputPlace&) = delete;

    // The file to write into.
    std::string temporary() const;
    // Gives it the name of the output. Once, and nobody writes into it any more. Throws OutputError.
    void take(Durability durability);

private:
    std::string path_;
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    bool taken_ = false;
};

// Throws OutputError when `path` plainly cannot become an output: a folder, below no folder, or not to be written to.
// For saying so before long work, and makes nothing; write_output checks again.
void check_output(const std::string& path, MissingFolder missing = MissingFolder::refused);

// Whether the system takes the name for a device in any folder, as Windows does NUL.
bool is_device_name(const std::filesystem::path& path);

enum class FileUse { input, output };

// What tells whether two paths lead to one file: the absolute path with links followed, existing or yet to be made. Empty
// for devices, FIFOs and "-": nothing in them is lost when two things use them. Hard links differ: a rename parts them. Throws
// OutputError when the system does not say what the current folder is, or where the links of an output lead.
std::string file_identity(const std::string& path, FileUse use);

}  // namespace sphereview
