/// Somebody else's program: uses the part of the installed Talus that knows files.

#include <cstdio>

#include "core/io/hash.hpp"

int main() {
  auto const digest = talus::io::sha256("abc");
  std::printf("%s\n", digest.c_str());
  // FIPS 180-4, its example of one block
  return digest == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad" ? 0 : 1;
}
