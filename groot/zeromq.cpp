#include "groot/zeromq.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <dlfcn.h>
#include <poll.h>

namespace proskill::groot {

namespace {

// What is used of libzmq's interface, which is stable since its version 4.0.
constexpr auto kName = "libzmq.so.5";
constexpr int kPub = 1;
constexpr int kRep = 4;
constexpr int kRcvMore = 13;
constexpr int kLinger = 17;
constexpr int kMaxMsgSize = 22;
constexpr int kLastEndpoint = 32;
constexpr int kDontWait = 1;
constexpr int kSndMore = 2;
constexpr short kPollIn = 1;
struct PollItem {
  void* socket;
  int descriptor;
  short events;
  short revents;
};
extern "C" {
using NewContext = void*();
using OfPointer = int(void*);
using NewSocket = void*(void*, int);
using Bind = int(void*, const char*);
using SetOption = int(void*, int, const void*, std::size_t);
using GetOption = int(void*, int, void*, std::size_t*);
using Receive = int(void*, void*, std::size_t, int);
using Send = int(void*, const void*, std::size_t, int);
using Poll = int(PollItem*, int, long);
}

/// A viewer whose requests are longer is disconnected.
constexpr std::size_t kLargest = std::size_t{64} << 10;
/// One more than a request may have; the rest is dropped.
constexpr std::size_t kMostParts = 3;
/// Number of pairs of ports that are tried where any will do.
constexpr int kTries = 50;

class Library {
public:
  /// \return whether all functions are there
  bool load() {
    handle.reset(::dlopen(kName, RTLD_NOW | RTLD_LOCAL));
    return handle && find(newContext, "zmq_ctx_new") && find(endContext, "zmq_ctx_term") &&
           find(newSocket, "zmq_socket") && find(close, "zmq_close") && find(bind, "zmq_bind") &&
           find(setOption, "zmq_setsockopt") && find(getOption, "zmq_getsockopt") &&
           find(receive, "zmq_recv") && find(send, "zmq_send") && find(poll, "zmq_poll");
  }

  NewContext* newContext = nullptr;
  OfPointer* endContext = nullptr;
  NewSocket* newSocket = nullptr;
  OfPointer* close = nullptr;
  Bind* bind = nullptr;
  SetOption* setOption = nullptr;
  GetOption* getOption = nullptr;
  Receive* receive = nullptr;
  Send* send = nullptr;
  Poll* poll = nullptr;

private:
  template <class Function> bool find(Function*& function, const char* name) {
    function = reinterpret_cast<Function*>(::dlsym(handle.get(), name));
    return function != nullptr;
  }

  struct Unload {
    void operator()(void* library) const { ::dlclose(library); }
  };
  std::unique_ptr<void, Unload> handle;
};

class LoadedSockets final : public Sockets {
public:
  ~LoadedSockets() override {
    closeSockets();
    if (context) zmq.endContext(context);
  }

  /// \return why it is not possible; empty: done
  std::string open(std::uint16_t port) {
    if (!zmq.load())
      return fmt::format("ZeroMQ is not installed (apt-get install libzmq5): {}", ::dlerror());
    context = zmq.newContext();
    for (int tries = port == 0 ? kTries : 1; tries > 0; --tries) {
      closeSockets();
      if (bindBoth(port)) return "";
    }
    return fmt::format("ports {} and {} must be free: {}", port, port + 1,
                       std::system_category().message(errno));
  }

  [[nodiscard]] std::uint16_t port() const override { return number; }

  void wait(int descriptor, long milliseconds) override {
    std::array<PollItem, 2> watched{{{server, 0, kPollIn, 0}, {nullptr, descriptor, kPollIn, 0}}};
    zmq.poll(watched.data(), static_cast<int>(watched.size()), milliseconds);
  }

  [[nodiscard]] std::optional<std::vector<std::string>> receive() override {
    std::vector<std::string> parts;
    for (int more = 1; more != 0;) {
      const int size = zmq.receive(server, buffer.data(), buffer.size(), kDontWait);
      if (size < 0) return std::nullopt;
      const auto whole = std::min(static_cast<std::size_t>(size), buffer.size());
      if (parts.size() < kMostParts) parts.emplace_back(buffer.data(), whole);
      std::size_t length = sizeof more;
      zmq.getOption(server, kRcvMore, &more, &length);
    }
    return parts;
  }

  void reply(const std::vector<std::string>& parts) override { sendAll(server, parts); }
  void publish(const std::vector<std::string>& parts) override { sendAll(publisher, parts); }

private:
  void sendAll(void* to, const std::vector<std::string>& parts) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      zmq.send(to, parts[i].data(), parts[i].size(),
               kDontWait | (i + 1 < parts.size() ? kSndMore : 0));
  }

  bool bindBoth(std::uint16_t port) {
    server = socket(kRep);
    publisher = socket(kPub);
    const auto any = port == 0 ? std::string("*") : std::to_string(port);
    if (zmq.bind(server, ("tcp://127.0.0.1:" + any).c_str()) != 0) return false;
    number = boundPort();
    if (number == UINT16_MAX) return false;
    return zmq.bind(publisher, fmt::format("tcp://127.0.0.1:{}", number + 1).c_str()) == 0;
  }

  void* socket(int kind) {
    void* made = zmq.newSocket(context, kind);
    const int linger = 0;
    const std::int64_t largest = kLargest;
    zmq.setOption(made, kLinger, &linger, sizeof linger);
    zmq.setOption(made, kMaxMsgSize, &largest, sizeof largest);
    return made;
  }

  [[nodiscard]] std::uint16_t boundPort() const {
    std::array<char, 64> address{};
    std::size_t size = address.size();
    zmq.getOption(server, kLastEndpoint, address.data(), &size);
    const std::string text(address.data());
    return static_cast<std::uint16_t>(std::stoi(text.substr(text.rfind(':') + 1)));
  }

  void closeSockets() {
    for (void** socket : {&server, &publisher}) {
      if (*socket) zmq.close(*socket);
      *socket = nullptr;
    }
  }

  Library zmq; ///< the first member: it is used to the end
  void* context = nullptr;
  void* server = nullptr;
  void* publisher = nullptr;
  std::uint16_t number = 0;
  std::vector<char> buffer = std::vector<char>(kLargest);
};

} // namespace

std::expected<std::unique_ptr<Sockets>, std::string> Sockets::open(std::uint16_t port) {
  auto made = std::make_unique<LoadedSockets>();
  if (auto wrong = made->open(port); !wrong.empty()) return std::unexpected(std::move(wrong));
  return made;
}

} // namespace proskill::groot
