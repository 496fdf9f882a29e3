#include "evaluate/digest.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>

namespace headland {
namespace {

// OpenSSL fails here only without memory or without its algorithms.
void require(int done) {
  if (done != 1) throw std::runtime_error("OpenSSL does not compute SHA-256");
}

}  // namespace

void Digest::Free::operator()(evp_md_ctx_st* freed) const { EVP_MD_CTX_free(freed); }

Digest::Digest() : context(EVP_MD_CTX_new()) {
  require(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr));
}

void add(Digest& digest, std::string_view bytes) {
  require(EVP_DigestUpdate(digest.context.get(), bytes.data(), bytes.size()));
}

std::string hexadecimal(Digest& digest) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> bytes{};
  require(EVP_DigestFinal_ex(digest.context.get(), bytes.data(), nullptr));
  std::string text;
  for (std::size_t i = 0; i < kDigestDigits / 2; ++i) text += fmt::format("{:02x}", bytes[i]);
  return text;
}

std::string digest_of(std::string_view text) {
  Digest digest;
  add(digest, text);
  return hexadecimal(digest);
}

}  // namespace headland
