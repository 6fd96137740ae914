#pragma once

#include <gtest/gtest.h>
#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace fretval {

/// Bytes of a base64 text.
inline std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned buffer = 0;
  int n_bits = 0;
  for (const char c : text) {
    const auto digit = digits.find(c);
    if (digit == std::string::npos) break;  // the padding
    buffer = buffer << 6U | static_cast<unsigned>(digit);
    n_bits += 6;
    if (n_bits < 8) continue;
    n_bits -= 8;
    bytes += static_cast<char>(buffer >> static_cast<unsigned>(n_bits) & 0xFFU);
  }
  return bytes;
}

/// The numbers of a data array of a VTU file, compressed as deal.II writes it; name: of a field, or empty for the
/// points, which have three coordinates each.
inline std::vector<float> vtu_data(const std::string& file, const std::string& name) {
  const std::string head = name.empty() ? "<Points>" : "Name=\"" + name + "\"";
  const auto at = file.find("format=\"binary\">\n", file.find(head));
  EXPECT_NE(file.find(head), std::string::npos) << name;
  if (at == std::string::npos) return {};
  const auto start = file.find('\n', at) + 1;
  const std::string text = file.substr(start, file.find('<', start) - start);
  constexpr std::size_t header_size = 24;  // four numbers in base64
  std::array<std::uint32_t, 4> header{};   // blocks, their size, that of the last one, that of what follows
  std::memcpy(header.data(), from_base64(text.substr(0, header_size)).data(), sizeof(header));
  const std::string compressed = from_base64(text.substr(header_size));
  std::vector<float> values(header[1] / sizeof(float));
  uLongf size = header[1];
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(values.data()), &size,
                       reinterpret_cast<const Bytef*>(compressed.data()), header[3]),
            Z_OK)
      << name;
  return values;
}

}  // namespace fretval
