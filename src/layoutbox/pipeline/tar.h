// A tar archive (POSIX ustar) as bytes: no times, owners or modes of this machine.
#pragma once

#include <string>
#include <string_view>

namespace layoutbox {

// A member with its header, filled up to whole blocks of 512 bytes. REQUIRES: a name of 1…100 bytes.
void add_to_tar(std::string& tar, std::string_view name, std::string_view bytes);

// What ends an archive.
inline constexpr std::size_t kTarEndBytes = 1024;

}  // namespace layoutbox
