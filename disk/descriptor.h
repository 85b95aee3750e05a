#pragma once

#include <array>
#include <cerrno>
#include <streambuf>
#include <unistd.h>
#include <utility>

namespace proskill::disk {

/// A stream buffer that writes to a file descriptor and closes it in its destructor.
class Descriptor : public std::streambuf {
public:
  explicit Descriptor(int opened) : descriptor(opened), failed(opened < 0 ? errno : 0) { rewind(); }
  ~Descriptor() override { (void)finish(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  /// The errno of the first error, 0 if there was none.
  [[nodiscard]] int error() const { return failed; }
  /// Closes the descriptor, since some errors appear only then. \return error()
  [[nodiscard]] int finish() {
    if (descriptor < 0) return failed;
    sync();
    if (close(std::exchange(descriptor, -1)) != 0 && failed == 0) failed = errno;
    return failed;
  }
  /// The system's number of the descriptor.
  [[nodiscard]] int number() const { return descriptor; }

protected:
  int_type overflow(int_type byte) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(byte, traits_type::eof())) sputc(traits_type::to_char_type(byte));
    return traits_type::not_eof(byte);
  }

  int sync() override {
    const char* from = pbase();
    while (failed == 0 && from < pptr()) {
      const auto count = ::write(descriptor, from, static_cast<std::size_t>(pptr() - from));
      if (count >= 0)
        from += count;
      else if (errno != EINTR)
        failed = errno;
    }
    rewind();
    return failed == 0 ? 0 : -1;
  }

private:
  void rewind() { setp(buffer.data(), buffer.data() + buffer.size()); }

  std::array<char, std::size_t{1} << 16> buffer;
  int descriptor;
  int failed;
};

} // namespace proskill::disk
