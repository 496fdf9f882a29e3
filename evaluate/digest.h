// Digests: what tells contents apart, wherever they lie and whatever they are called.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

struct evp_md_ctx_st;  // of OpenSSL

namespace headland {

// SHA-256 (FIPS 180-4), cut to its first 128 bits: 32 hexadecimal digits.
struct Digest {
  Digest();
  struct Free {
    void operator()(evp_md_ctx_st* context) const;
  };
  std::unique_ptr<evp_md_ctx_st, Free> context;
};

void add(Digest& digest, std::string_view bytes);
// Ends the digest: nothing can be added any more.
std::string hexadecimal(Digest& digest);

std::string digest_of(std::string_view text);

inline constexpr std::size_t kDigestDigits = 32;

}  // namespace headland
