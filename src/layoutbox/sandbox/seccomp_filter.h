// Which calls of the system code in the sandbox may not make, as a program of the kernel's (classic BPF).
#pragma once

#include <string>

namespace layoutbox::sandbox {

// The bytes of the filter, an array of sock_filter as bwrap --seccomp takes it; empty on machines it is not written for.
//
// What is refused (EPERM, so that a program sees an error and goes on): other processes, every socket but local ones, tracing, other
// programs' memory, namespaces and mounts, keys, kernel modules, files without a name (they would be memory that nobody counts), the
// system's clock and swap, terminals' input. Threads, files and memory are not touched.
std::string seccomp_filter();

}  // namespace layoutbox::sandbox
