#include "panels/file_listing.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <tuple>

#include "base/text.hpp"
#include "base/user_folders.hpp"

namespace sphereview {

namespace fs = std::filesystem;

fs::path typed_path(std::string_view typed, const fs::path& folder) {
    std::string_view text = trimmed(typed);
    fs::path path;
    if (text == "~" || text.starts_with("~/")) {
        text.remove_prefix(text == "~" ? 1 : 2);
        path = home_folder() / path_from(text);
    } else {
        path = path_from(text);
        if (!is_network_name(path)) path = folder / path;  // an absolute path replaces the folder
    }
    path = normal_path(path);
    // "/a/b/" is the folder "/a/b".
    return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

namespace {

bool is_wanted(const FileEntry& entry, const std::vector<std::string>& endings, bool hidden_files) {
    if (!hidden_files && entry.name.starts_with('.')) return false;
    if (entry.is_folder || endings.empty()) return true;
    return std::ranges::any_of(endings, [&](const std::string& ending) { return has_ending(entry.name, ending); });
}

// Size and time are 0 where the file system does not know them: of a link that leads nowhere.
void add_facts(const fs::directory_entry& entry, FileEntry& found) {
    using namespace std::chrono;
    std::error_code error;
    if (!found.is_folder) found.bytes = entry.file_size(error);
    if (error) found.bytes = 0;
    const fs::file_time_type changed = entry.last_write_time(error);
    // Not every library can convert a file's time; both clocks tell the present.
    const auto ago = fs::file_time_type::clock::now() - changed;
    const auto at = system_clock::now() - duration_cast<system_clock::duration>(ago);
    if (!error) found.changed = duration_cast<seconds>(at.time_since_epoch()).count();
}

}  // namespace

void sort_entries(std::vector<FileEntry>& entries, const FileOrder& order) {
    // In lower case once for each, not once for each comparison: a folder may hold many thousands.
    struct Keyed {
        int rank;
        std::string key;
        FileEntry entry;
    };
    std::vector<Keyed> keyed;
    keyed.reserve(entries.size());
    for (FileEntry& entry : entries) {
        const int rank = !entry.is_folder ? 2 : entry.name == ".." ? 0 : 1;
        keyed.push_back({rank, lower_case(entry.name), std::move(entry)});
    }
    std::ranges::sort(keyed, [&](const Keyed& a, const Keyed& b) {
        if (a.rank != b.rank) return a.rank < b.rank;
        const auto& [x, y] = order.descending ? std::tie(b, a) : std::tie(a, b);
        if (order.by == FileColumn::size && x.entry.bytes != y.entry.bytes) return x.entry.bytes < y.entry.bytes;
        if (order.by == FileColumn::date && x.entry.changed != y.entry.changed) return x.entry.changed < y.entry.changed;
        const bool backwards = order.by == FileColumn::name && order.descending;
        return std::tie(a.key, a.entry.name) < std::tie(b.key, b.entry.name) ? !backwards : backwards;
    });
    std::ranges::transform(keyed, entries.begin(), [](Keyed& one) { return std::move(one.entry); });
}

Listing list_folder(const fs::path& folder, const std::vector<std::string>& endings, bool hidden_files) {
    Listing listing;
    if (folder.has_relative_path()) listing.entries.push_back({"..", true});
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        std::error_code unknown;  // a link that leads nowhere is a file
        FileEntry found{text_from(entry->path().filename()), entry->is_directory(unknown)};
        if (!is_wanted(found, endings, hidden_files)) continue;
        add_facts(*entry, found);
        listing.entries.push_back(std::move(found));
    }
    if (error) return {{}, "Cannot read " + text_from(folder) + ": " + error.message()};
    return listing;
}

std::string size_text(std::uint64_t bytes) {
    if (bytes < 1000) return std::to_string(bytes) + " B";
    auto value = static_cast<double>(bytes);
    const char* unit = "";
    for (const char* next : {" kB", " MB", " GB", " TB"}) {
        if (value < 999.5) break;
        value /= 1000.0;
        unit = next;
    }
    return fixed(value, value < 9.95 ? 1 : 0) + unit;
}

std::string date_text(std::int64_t seconds) {
    const auto time = static_cast<std::time_t>(seconds);
    const std::tm* local = std::localtime(&time);
    std::array<char, 32> text{};
    if (local == nullptr) return "";
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", local)};
}

}  // namespace sphereview
