#include "base/sha256.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/error.hpp"

#if defined(_WIN32)
#include <windows.h>

#include <bcrypt.h>
#elif defined(__APPLE__)
#include <CommonCrypto/CommonDigest.h>
#else
#include <sys/types.h>

#include <sha2.h>
#endif

namespace sphereview {

namespace {

using Sum = std::array<std::uint8_t, 32>;

// Nobody's hash function takes more at once than 32 bits count.
constexpr std::size_t longest_piece = std::size_t{1} << 30;

#if defined(_WIN32)

class Hash {
public:
    Hash() {
        check(BCryptOpenAlgorithmProvider(&algorithm_, BCRYPT_SHA256_ALGORITHM, nullptr, 0));
        check(BCryptCreateHash(algorithm_, &hash_, nullptr, 0, nullptr, 0, 0));
    }
    ~Hash() {
        if (hash_ != nullptr) BCryptDestroyHash(hash_);
        BCryptCloseAlgorithmProvider(algorithm_, 0);
    }
    Hash(const Hash&) = delete;
    Hash& operator=(const Hash&) = delete;

    void add(std::string_view bytes) {
        check(
            BCryptHashData(hash_, reinterpret_cast<PUCHAR>(const_cast<char*>(bytes.data())), static_cast<ULONG>(bytes.size()), 0));
    }
    Sum sum() {
        Sum sum{};
        check(BCryptFinishHash(hash_, sum.data(), static_cast<ULONG>(sum.size()), 0));
        return sum;
    }

private:
    static void check(NTSTATUS status) {
        if (status < 0) throw RenderError("Windows cannot compute a SHA-256");
    }

    BCRYPT_ALG_HANDLE algorithm_ = nullptr;
    BCRYPT_HASH_HANDLE hash_ = nullptr;
};

#elif defined(__APPLE__)

class Hash {
public:
    Hash() { CC_SHA256_Init(&context_); }
    void add(std::string_view bytes) { CC_SHA256_Update(&context_, bytes.data(), static_cast<CC_LONG>(bytes.size())); }
    Sum sum() {
        Sum sum{};
        CC_SHA256_Final(sum.data(), &context_);
        return sum;
    }

private:
    CC_SHA256_CTX context_{};
};

#else

class Hash {
public:
    Hash() { SHA256Init(&context_); }
    void add(std::string_view bytes) { SHA256Update(&context_, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()); }
    Sum sum() {
        Sum sum{};
        SHA256Final(sum.data(), &context_);
        return sum;
    }

private:
    SHA2_CTX context_{};
};

#endif

}  // namespace

std::string sha256(const std::function<std::string_view()>& next) {
    Hash hash;
    for (std::string_view piece = next(); !piece.empty(); piece = next()) {
        while (!piece.empty()) {
            hash.add(piece.substr(0, longest_piece));
            piece.remove_prefix(std::min(piece.size(), longest_piece));
        }
    }
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const std::uint8_t byte : hash.sum()) {
        text += digits[byte >> 4U];
        text += digits[byte & 15U];
    }
    return text;
}

std::string sha256(std::string_view bytes) {
    return sha256([&] { return std::exchange(bytes, {}); });
}

}  // namespace sphereview
