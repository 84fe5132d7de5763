#include "layoutbox/sandbox/seccomp_filter.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace layoutbox::sandbox {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t kMachine = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t kMachine = 0;
#endif

constexpr std::uint32_t kX32 = 0x40000000;  // calls of x86-64's other interface, under other numbers
constexpr std::uint32_t kNewNamespaces =
    CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

// By what they would be used for. Not all machines have all of them.
constexpr std::uint32_t kRefused[] = {
// other processes
#ifdef __NR_fork
    __NR_fork,
    __NR_vfork,
#endif
    // other programs' memory and doings
    __NR_ptrace,
    __NR_process_vm_readv,
    __NR_process_vm_writev,
    __NR_kcmp,
    __NR_perf_event_open,
    __NR_bpf,
    __NR_userfaultfd,
#ifdef __NR_pidfd_getfd
    __NR_pidfd_getfd,
    __NR_process_madvise,
#endif
    // namespaces and mounts
    __NR_unshare,
    __NR_setns,
    __NR_mount,
    __NR_umount2,
    __NR_pivot_root,
    __NR_chroot,
#ifdef __NR_open_tree
    __NR_open_tree,
    __NR_move_mount,
    __NR_fsopen,
    __NR_fsconfig,
    __NR_fsmount,
    __NR_fspick,
#endif
#ifdef __NR_mount_setattr
    __NR_mount_setattr,
#endif
    __NR_name_to_handle_at,
    __NR_open_by_handle_at,
    __NR_fanotify_init,
    // keys, modules, the machine
    __NR_keyctl,
    __NR_add_key,
    __NR_request_key,
    __NR_init_module,
    __NR_finit_module,
    __NR_delete_module,
    __NR_kexec_load,
    __NR_reboot,
    __NR_swapon,
    __NR_swapoff,
    __NR_acct,
    __NR_quotactl,
    __NR_syslog,
    __NR_sethostname,
    __NR_setdomainname,
    __NR_settimeofday,
    __NR_clock_settime,
    __NR_adjtimex,
    __NR_clock_adjtime,
    __NR_personality,
#ifdef __NR_kexec_file_load
    __NR_kexec_file_load,
#endif
#ifdef __NR_iopl
    __NR_iopl,
    __NR_ioperm,
    __NR_modify_ldt,
#endif
    // queues into the kernel that pass by this filter
    __NR_io_setup,
    __NR_io_submit,
#ifdef __NR_io_uring_setup
    __NR_io_uring_setup,
    __NR_io_uring_enter,
    __NR_io_uring_register,
#endif
    // memory and queues that belong to no process
    __NR_memfd_create,
    __NR_shmget,
    __NR_semget,
    __NR_msgget,
    __NR_mq_open,
#ifdef __NR_memfd_secret
    __NR_memfd_secret,
#endif
    // devices
    __NR_mknodat,
#ifdef __NR_mknod
    __NR_mknod,
#endif
};

class Filter {
 public:
  std::string build() {
    load(offsetof(seccomp_data, arch));
    unless_equal(kMachine, SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
#ifdef __x86_64__
    when(BPF_JGE, kX32, refuse(EPERM));
#endif
    for (const std::uint32_t number : kRefused) when(BPF_JEQ, number, refuse(EPERM));
#ifdef __NR_clone3
    // Its flags are out of reach here; libraries fall back to clone.
    when(BPF_JEQ, __NR_clone3, refuse(ENOSYS));
#endif
    // Sockets of this machine only: network, Bluetooth and the host of a virtual machine are families of their own.
    argument_of(__NR_socket, 0, [&] { unless_equal(AF_UNIX, refuse(EPERM)); });
    argument_of(__NR_ioctl, 1, [&] {
      when(BPF_JEQ, TIOCSTI, refuse(EPERM));
      when(BPF_JEQ, kTioclinux, refuse(EPERM));
    });
    argument_of(__NR_clone, 0, [&] {
      when(BPF_JSET, kNewNamespaces, refuse(EPERM));
      unless_set(CLONE_THREAD, refuse(EPERM));
    });
    ret(SECCOMP_RET_ALLOW);
    return {reinterpret_cast<const char*>(program_.data()), program_.size() * sizeof(sock_filter)};
  }

 private:
  static constexpr std::uint32_t kTioclinux = 0x541C;
  static constexpr std::uint32_t refuse(int error) { return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error); }

  void add(int code, std::uint32_t value, std::uint8_t yes = 0, std::uint8_t no = 0) {
    program_.push_back({static_cast<std::uint16_t>(code), yes, no, value});
  }
  void load(std::size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)); }
  void ret(std::uint32_t what) { add(BPF_RET | BPF_K, what); }
  void when(int test, std::uint32_t value, std::uint32_t answer) {
    add(BPF_JMP | test | BPF_K, value, 0, 1);
    ret(answer);
  }
  void unless(int test, std::uint32_t value, std::uint32_t answer) {
    add(BPF_JMP | test | BPF_K, value, 1, 0);
    ret(answer);
  }
  void unless_equal(std::uint32_t value, std::uint32_t answer) { unless(BPF_JEQ, value, answer); }
  void unless_set(std::uint32_t bits, std::uint32_t answer) { unless(BPF_JSET, bits, answer); }

  // Of one call: looks at the lower half of an argument (both machines begin with it).
  template <class Look>
  void argument_of(std::uint32_t number, std::size_t argument, const Look& look) {
    add(BPF_JMP | BPF_JEQ | BPF_K, number, 0, 0);
    const std::size_t jump = program_.size() - 1;
    load(offsetof(seccomp_data, args) + argument * sizeof(std::uint64_t));
    look();
    ret(SECCOMP_RET_ALLOW);
    program_[jump].jf = static_cast<std::uint8_t>(program_.size() - jump - 1);
  }

  std::vector<sock_filter> program_;
};

}  // namespace

std::string seccomp_filter() { return kMachine == 0 ? std::string() : Filter().build(); }

}  // namespace layoutbox::sandbox
