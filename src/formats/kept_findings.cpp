// The file: a line that names it, a line with the SHA-256 of what follows, and then the stamp, the question and the answer.
#include "formats/kept_findings.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/path.hpp"
#include "base/sha256.hpp"
#include "base/user_folders.hpp"

namespace sphereview {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view head = "sphereview frames 2\n";
constexpr std::size_t sum_size = 64;
constexpr std::size_t sampled_bytes = std::size_t{1} << 12;  // at each end of a file
constexpr std::chrono::seconds moment{2};                    // more than any file system rounds its times to

fs::path findings_folder() {
    const fs::path folder = state_folder();
    return folder.empty() ? fs::path() : folder / "frames";
}

// Empty where the user has no folder.
fs::path finding_file(const FindingKind& kind, const FileStamp& stamp, const std::string& question) {
    const fs::path folder = findings_folder();
    const std::string subject = question.empty() ? stamp.file : stamp.file + "\n" + question;
    return folder.empty() ? fs::path() : folder / (sha256(subject).substr(0, sum_size / 2) + std::string(kind.ending));
}

void write(KeptWriter& to, const FileStamp& stamp) {
    to.text(stamp.file);
    to.text(stamp.format);
    to.number(stamp.size);
    to.number(static_cast<std::uint64_t>(stamp.time));
    to.text(stamp.sum);
}

FileStamp read_stamp(KeptReader& from) {
    FileStamp stamp;
    stamp.file = from.text();
    stamp.format = from.text();
    stamp.size = from.number();
    stamp.time = static_cast<std::int64_t>(from.number());
    stamp.sum = from.text();
    return stamp;
}

// Leaves room in the folder: who was used last stays.
void remove_oldest(const FindingKind& kind) {
    struct Kept {
        fs::path file;
        fs::file_time_type time;
        std::uint64_t size;
    };
    std::vector<Kept> all;
    std::error_code error;
    for (fs::directory_iterator entry(findings_folder(), error), end; !error && entry != end; entry.increment(error)) {
        if (entry->path().extension() != kind.ending) continue;
        std::error_code ignored;
        all.push_back({entry->path(), entry->last_write_time(ignored), entry->file_size(ignored)});
    }
    std::ranges::sort(all, std::ranges::greater(), &Kept::time);
    std::uint64_t bytes = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        bytes += all[i].size;
        if (i >= kind.most || bytes > kind.most_bytes) fs::remove(all[i].file, error);
    }
}

}  // namespace

std::optional<FileStamp> stamp_of(const std::string& path, std::string_view format) {
    try {
        FileStamp stamp;
        stamp.file = file_identity(path, FileUse::input);
        stamp.format = format;
        stamp.size = fs::file_size(path_from(path));
        stamp.time = static_cast<std::int64_t>(fs::last_write_time(path_from(path)).time_since_epoch().count());
        InputStream stream(path, Content::binary);
        if (!stream.is_regular() || !stream.size() || stamp.file.empty()) return std::nullopt;
        stream.fill(sampled_bytes);
        std::string sample(stream.bytes().substr(0, sampled_bytes));
        stream.go_to(stamp.size - std::min<std::uint64_t>(stamp.size, sampled_bytes));
        stream.fill(sampled_bytes);
        stamp.sum = sha256(sample += stream.bytes());
        return stamp;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

std::optional<std::string> read_finding(const FindingKind& kind, const FileStamp& stamp, const std::string& question) {
    try {
        const fs::path file = finding_file(kind, stamp, question);
        std::error_code error;
        if (file.empty() || !fs::is_regular_file(file, error) || fs::file_size(file) > kind.longest) return std::nullopt;
        const InputFile kept(text_from(file), Content::binary);
        std::string_view bytes = kept.bytes();
        if (!bytes.starts_with(head) || bytes.size() < head.size() + sum_size) return std::nullopt;
        const std::string_view sum = bytes.substr(head.size(), sum_size);
        bytes.remove_prefix(head.size() + sum_size);
        if (sha256(bytes) != sum) return std::nullopt;
        KeptReader reader(bytes);
        if (read_stamp(reader) != stamp || reader.text() != question) return std::nullopt;
        std::string answer = reader.text();
        fs::last_write_time(file, fs::file_time_type::clock::now(), error);
        return answer;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

void keep_finding(const FindingKind& kind, const FileStamp& stamp, const std::string& question, std::string_view answer) noexcept {
    try {
        const fs::path file = finding_file(kind, stamp, question);
        const auto age = fs::file_time_type::clock::now() - fs::last_write_time(path_from(stamp.file));
        if (file.empty() || age < moment) return;
        KeptWriter to;
        write(to, stamp);
        to.text(question);
        to.text(answer);
        const std::string& bytes = to.bytes();
        if (bytes.size() > kind.longest - head.size() - sum_size || !make_user_folder(findings_folder())) return;
        write_regular_file(text_from(file), std::string(head) + sha256(bytes) + bytes, Durability::in_system);
        remove_oldest(kind);
    } catch (const std::exception&) {
        // Not kept: the next run searches again.
    }
}

void forget_finding(const FindingKind& kind, const FileStamp& stamp, const std::string& question) noexcept {
    try {
        std::error_code ignored;
        fs::remove(finding_file(kind, stamp, question), ignored);
    } catch (const std::exception&) {
        // A damaged finding that stays is not used.
    }
}

}  // namespace sphereview
