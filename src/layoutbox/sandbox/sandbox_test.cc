// Ways out of the sandbox, each tried by a Python program that says OUT where it got through. What got through is looked for from outside
// as well.
#include "layoutbox/sandbox/sandbox.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "layoutbox/base/descriptor.h"
#include "layoutbox/base/files.h"

namespace layoutbox::sandbox {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kPython = "/usr/bin/python3";
constexpr const char* kSecret = "the-users-own-words";

class Sandbox : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto walls = describe_walls(); !walls) GTEST_SKIP() << walls.error().message;
    if (!fs::exists(kPython)) GTEST_SKIP() << "there is no python3";
  }

  Outcome run_python(const std::string& code, Limits limits = {}) {
    Job job;
    job.command = {kPython, "-c", "import os, sys, ctypes, socket, time, threading\nlibc = ctypes.CDLL(None, use_errno=True)\n" + code};
    job.folder = folder_.path();
    job.readable = {readable_.path()};
    job.limits = limits;
    auto outcome = run(job);
    EXPECT_TRUE(outcome) << (outcome ? "" : outcome.error().message);
    return outcome ? *std::move(outcome) : Outcome{};
  }

  // The attempt as an expression or as statements that set `out`: true where it got through.
  void expect_contained(const std::string& name, const std::string& attempt) {
    const Outcome outcome = run_python(fmt::format(R"(
out = False
try:
    exec({})
    print("OUT" if out else "IN: no effect")
except BaseException as error:
    print("IN:", type(error).__name__, error)
)",
                                                   quoted(attempt)));
    EXPECT_THAT(outcome.process.output, HasSubstr("IN: ")) << name;
    EXPECT_THAT(outcome.process.output, Not(HasSubstr("OUT"))) << name;
    EXPECT_THAT(outcome.process.output, Not(HasSubstr("SyntaxError"))) << name;
    fmt::print("  {}: {}", name, outcome.process.output);
  }

  static std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\n' ? "\\n" : c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return result + "'";
  }

  TemporaryFolder folder_ = TemporaryFolder::make("sandbox-job").value();
  TemporaryFolder readable_ = TemporaryFolder::make("sandbox-readable").value();
};

// A server of the user's on this machine.
class SocketListener {
 public:
  explicit SocketListener(int family) : socket_(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t length = sizeof address;
    EXPECT_EQ(::bind(socket_.get(), reinterpret_cast<sockaddr*>(&address), length), 0);
    EXPECT_EQ(::listen(socket_.get(), 4), 0);
    ::getsockname(socket_.get(), reinterpret_cast<sockaddr*>(&address), &length);
    port_ = ntohs(address.sin_port);
  }
  int port() const { return port_; }

 private:
  Descriptor socket_;
  int port_ = 0;
};

TEST_F(Sandbox, SaysWhatItsWallsAre) {
  const char* path = std::getenv("PATH");
  const bool none_to_find = path != nullptr && std::string(path) == "/nowhere";
  EXPECT_THAT(describe_walls().value(), HasSubstr(none_to_find ? "namespaces" : ""));
}

TEST_F(Sandbox, RunsWhatItIsGiven) {
  const Outcome outcome = run_python("print(os.getcwd(), os.environ['HOME']); open('left', 'w').write('x' * 10); sys.exit(3)");
  EXPECT_EQ(outcome.process.output, "/job /home/nobody\n");
  EXPECT_EQ(outcome.process.exit_status, 3);
  EXPECT_EQ(outcome.ended, "");
  EXPECT_EQ(take_file(folder_.path(), "left", 100).value(), "xxxxxxxxxx");
  EXPECT_EQ(take_file(folder_.path(), "left", 9).error().code, ErrorCode::kTooLarge);
  EXPECT_FALSE(take_file(folder_.path(), "other", 100));
}

TEST_F(Sandbox, TheNetworkIsOutOfReach) {
  const SocketListener listener(AF_INET);
  expect_contained("a server on this machine", fmt::format("socket.create_connection(('127.0.0.1', {}), 2); out = True", listener.port()));
  expect_contained("a server elsewhere", "socket.create_connection(('192.0.2.1', 80), 2); out = True");
  expect_contained("a datagram", "socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b'x', ('192.0.2.1', 53)); out = True");
  expect_contained("IPv6", "socket.socket(socket.AF_INET6, socket.SOCK_STREAM); out = True");
  expect_contained("a name", "socket.getaddrinfo('example.org', 80); out = True");
  expect_contained("netlink", "socket.socket(socket.AF_NETLINK, socket.SOCK_RAW); out = True");
  expect_contained("packets", "socket.socket(socket.AF_PACKET, socket.SOCK_RAW); out = True");
  expect_contained("the host of a virtual machine", "socket.socket(40, socket.SOCK_STREAM); out = True");
}

TEST_F(Sandbox, LocalSocketsOfOthersAreOutOfReach) {
  const TemporaryFolder folder = TemporaryFolder::make("sandbox-socket").value();
  const Outcome outcome = run_python("s = socket.socket(socket.AF_UNIX); s.connect('\\0layoutbox-sandbox-test')");
  EXPECT_NE(outcome.process.exit_status, 0);
  expect_contained("the message bus", "socket.socket(socket.AF_UNIX).connect('/run/dbus/system_bus_socket'); out = True");
  expect_contained("containers", "socket.socket(socket.AF_UNIX).connect('/var/run/docker.sock'); out = True");
}

TEST_F(Sandbox, TheUsersFilesAreOutOfReach) {
  const TemporaryFolder home = TemporaryFolder::make("sandbox-home").value();
  ASSERT_TRUE(write_file(home.path() / "secret", kSecret));
  const std::string secret = (home.path() / "secret").string();
  expect_contained("a file", fmt::format("out = bool(open('{}').read())", secret));
  expect_contained("through the first process", fmt::format("out = bool(open('/proc/1/root{}').read())", secret));
  expect_contained("through its folder", fmt::format("out = bool(open('/proc/1/cwd/../..{}').read())", secret));
  expect_contained("homes", "out = sum((f for _, _, f in os.walk('/home')), []) + sum((f for _, _, f in os.walk('/root')), [])");
  expect_contained("passwords", "out = bool(open('/etc/shadow').read())");
  expect_contained("names of users", "out = bool(open('/etc/passwd').read())");
  expect_contained("the machine's disks",
                   "out = bool([n for n in os.listdir('/dev') if n.startswith(('sd', 'vd', 'nvme', 'mem', 'kmsg'))])");
  expect_contained("a device of one's own", "os.mknod('/job/disk', 0o60600, os.makedev(8, 0)); out = True");
  expect_contained(
      "open descriptors",
      "for n in range(3, 1024):\n  try: os.fstat(n); out = True; print(n, os.readlink('/proc/self/fd/%d' % n))\n  except OSError: pass");
}

TEST_F(Sandbox, KeysAreOutOfReach) {
  ::setenv("OPENAI_API_KEY", kSecret, 1);
  const std::string look = fmt::format("'{}'", kSecret);
  expect_contained("the environment", "out = 'OPENAI_API_KEY' in os.environ or " + look + " in str(os.environ)");
  expect_contained("the first process's", "out = " + look + " in open('/proc/1/environ').read()");
  expect_contained("anybody's", "for p in os.listdir('/proc'):\n  if p.isdigit():\n    out = out or " + look +
                                    " in open('/proc/%s/environ' % p).read()");
  expect_contained("the keyring", "out = libc.syscall(250, 0, -3, 1) >= 0");
  ::unsetenv("OPENAI_API_KEY");
}

TEST_F(Sandbox, OnlyItsFolderCanBeWritten) {
  for (const std::string& file : {std::string("/usr/x"), std::string("/x"), std::string("/dev/x"), std::string("/etc/x"),
                                  std::string("/lib/x"), (readable_.path() / "x").string()}) {
    expect_contained(file, fmt::format("open('{}', 'w'); out = True", file));
  }
  for (const char* file : {"/proc/sys/kernel/core_pattern", "/proc/sysrq-trigger", "/proc/sys/vm/overcommit_memory"}) {
    expect_contained(file, fmt::format("open('{}', 'r+'); out = True", file));
  }
  expect_contained("control groups", "out = os.path.exists('/sys/fs/cgroup')");
  expect_contained("making it writable", "libc.mount(None, b'/usr', None, 32 | 4096, None) == 0 or os.remove('/usr/bin/env'); out = True");
}

TEST_F(Sandbox, OtherProgramsAreOutOfReach) {
  const pid_t victim = ::fork();
  if (victim == 0) {
    ::pause();
    ::_exit(0);
  }
  expect_contained("by number", fmt::format("os.kill({}, 9); out = True", victim));
  expect_contained("its parent", "os.kill(os.getppid(), 9); out = os.getppid() == 0");
  expect_contained("the list of programs", "out = len([p for p in os.listdir('/proc') if p.isdigit()]) > 2");
  expect_contained("tracing", "out = libc.ptrace(16, 1, 0, 0) == 0");
  expect_contained("memory of others", "out = libc.process_vm_readv(1, None, 0, None, 0, 0) >= 0");
  expect_contained("memory of the first", "open('/proc/1/mem', 'rb').seek(4096); out = bool(open('/proc/1/mem', 'rb').read(1))");
  EXPECT_EQ(::waitpid(victim, nullptr, WNOHANG), 0) << "it was killed";
  ::kill(victim, SIGKILL);
  ::waitpid(victim, nullptr, 0);
}

TEST_F(Sandbox, NoMoreRightsCanBeHad) {
  expect_contained("root", "os.setuid(0); out = True");
  expect_contained("a namespace of users", "out = libc.unshare(0x10000000) == 0");
  expect_contained("a mount", "out = libc.mount(b'none', b'/job', b'tmpfs', 0, None) == 0");
  expect_contained("another root", "os.chroot('/job'); out = True");
  expect_contained("programs of the kernel", "out = libc.syscall(321, 0, 0, 0) >= 0");
  expect_contained("its queues", "out = libc.syscall(425, 8, 0) >= 0");
  expect_contained("counters", "out = libc.syscall(298, 0, 0, -1, -1, 0) >= 0");
  expect_contained("typing on the terminal", "import fcntl; fcntl.ioctl(0, 0x5412, b'x'); out = True");
  expect_contained("memory that nobody counts", "os.memfd_create('x'); out = True");
  expect_contained("programs that give rights",
                   "print('IN: it becomes su', flush=True); os.execv('/usr/bin/su', ['su', '-c', 'echo OUT'])");
}

TEST_F(Sandbox, NothingIsStarted) {
  expect_contained("a process", "os.fork(); out = True");
  expect_contained("a program", "import subprocess; subprocess.run(['/usr/bin/id']); out = True");
  expect_contained("a shell", "out = os.system('true') == 0");
  expect_contained("many processes",
                   "import multiprocessing as m\nfor i in range(1000): m.Process(target=time.sleep, args=(60,)).start()\nout = True");
}

TEST_F(Sandbox, TimeEnds) {
  Limits limits;
  limits.time_s = 0.5;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run_python("while True: pass", limits).ended, "it took more than 0.5 s");
  const Outcome stubborn = run_python("import signal\nfor n in (1, 2, 3, 15): signal.signal(n, signal.SIG_IGN)\ntime.sleep(100)", limits);
  EXPECT_EQ(stubborn.ended, "it took more than 0.5 s");
  const Outcome late = run_python("import atexit; atexit.register(time.sleep, 100)", limits);
  EXPECT_EQ(late.ended, "it took more than 0.5 s");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(15));
}

TEST_F(Sandbox, MemoryEnds) {
  Limits limits;
  limits.memory_mb = 200;
  EXPECT_EQ(run_python("keep = []\nwhile True: keep.append(bytearray(b'x') * (1 << 20)); time.sleep(0.0005)", limits).ended,
            "it used more than 200 MB of memory");
  const Outcome at_once = run_python("x = bytearray(1 << 40)", limits);
  EXPECT_THAT(at_once.process.output, HasSubstr("MemoryError"));
}

TEST_F(Sandbox, ThreadsEnd) {
  Limits limits;
  limits.tasks = 50;
  EXPECT_EQ(run_python("for i in range(400): threading.Thread(target=time.sleep, args=(30,)).start()", limits).ended,
            "it ran more than 50 processes and threads");
}

TEST_F(Sandbox, TheDiskIsNotFilled) {
  Limits limits;
  limits.file_mb = 4, limits.folder_mb = 8, limits.files = 50;
  const Outcome one = run_python("open('big', 'wb').write(b'x' * (64 << 20))", limits);
  EXPECT_NE(one.process.exit_status, 0);
  EXPECT_LE(fs::file_size(folder_.path() / "big"), 4u << 20);
  EXPECT_EQ(run_python("for i in range(9999): open('a%d' % i, 'wb').write(b'x' * (1 << 20)); time.sleep(0.01)", limits).ended,
            "it wrote more than 8 MB");
}

TEST_F(Sandbox, FilesAreCounted) {
  Limits limits;
  limits.files = 50;
  EXPECT_EQ(run_python("for i in range(99999): open('b%d' % i, 'w'); time.sleep(0.001)", limits).ended, "it made more than 50 files");
  expect_contained("temporary files", "open('/tmp/x', 'wb').write(b'x' * (300 << 20)); out = True");
  expect_contained("shared memory", "open('/dev/shm/x', 'wb').write(b'x' * (300 << 20)); out = True");
}

TEST_F(Sandbox, WhatIsLeftLeadsNowhere) {
  const TemporaryFolder home = TemporaryFolder::make("sandbox-home").value();
  ASSERT_TRUE(write_file(home.path() / "secret", kSecret));
  run_python(fmt::format(R"(
os.symlink('{}', 'room.json')
os.mkfifo('pipe')
os.mkdir('folder'); open('folder/x', 'w'); os.chmod('folder', 0)
open('one', 'w').write('x'); os.link('one', 'two')
socket.socket(socket.AF_UNIX).bind('socket')
)",
                         (home.path() / "secret").string()));
  for (const char* name : {"room.json", "pipe", "folder", "one", "socket", "../secret", ".."}) {
    EXPECT_FALSE(take_file(folder_.path(), name, 1000)) << name;
  }
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_.path())) fs::remove_all(entry.path(), error);
  EXPECT_FALSE(error) << error.message();
  EXPECT_TRUE(fs::exists(home.path() / "secret"));
}

TEST_F(Sandbox, WhatItSaysIsCutShort) {
  Limits limits;
  limits.time_s = 20;
  const Outcome outcome = run_python("for i in range(20000): print('x' * 1000)", limits);
  EXPECT_LE(outcome.process.output.size(), 64u << 10);
}

TEST(SandboxWithoutWalls, NothingRunsWhereThereAreNone) {
  if (describe_walls()) GTEST_SKIP() << "there are walls here";
  Job job;
  job.command = {"/usr/bin/true"};
  EXPECT_EQ(run(job).error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace layoutbox::sandbox
