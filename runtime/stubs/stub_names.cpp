#include "runtime/stubs/stub_names.h"

#include "runtime/stubs/platform_header.h"

#include <algorithm>
#include <ranges>

namespace proskill::runtime {

namespace {

/// The keywords of both languages, and what the generated text uses itself.
constexpr std::string_view kWordsOfC =
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
    "char32_t char8_t class co_await co_return co_yield compl concept const const_cast "
    "consteval constexpr constinit continue decltype default delete do double dynamic_cast "
    "else enum explicit export extern false float for friend goto if inline int long mutable "
    "namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
    "register reinterpret_cast requires restrict return short signed sizeof static "
    "static_assert static_cast struct switch template this thread_local throw true try "
    "typedef typeid typename typeof union unsigned using virtual void volatile wchar_t while "
    "xor xor_eq "
    "run report interrupt Actions Event Skill actions suits log Robot std proskill makeActions "
    "report_event interrupt_skill ACTIONS_H int64_t size_t";

/// Macros and types of the headers of C, as far as a name of a program may become one.
constexpr std::string_view kHeadersOfC =
    "linux unix i386 errno assert offsetof alloca stdin stdout stderr EOF NULL BUFSIZ "
    "CSIGNAL NFDBITS WEOF NAN INFINITY htobe16 htobe32 htobe64 htole16 htole32 htole64 be16toh "
    "be32toh be64toh le16toh le32toh le64toh pthread_cleanup_push pthread_cleanup_pop "
    "sched_priority P_tmpdir "
    "INT8_C INT16_C INT32_C INT64_C INTMAX_C UINT8_C UINT16_C UINT32_C UINT64_C UINTMAX_C "
    "INT8_MIN INT16_MIN INT32_MIN INT64_MIN INTMAX_MIN INTPTR_MIN INT8_MAX INT16_MAX INT32_MAX "
    "INT64_MAX INTMAX_MAX INTPTR_MAX UINT8_MAX UINT16_MAX UINT32_MAX UINT64_MAX UINTMAX_MAX "
    "UINTPTR_MAX INT_FAST8_MIN INT_FAST16_MIN INT_FAST32_MIN INT_FAST64_MIN INT_FAST8_MAX "
    "INT_FAST16_MAX INT_FAST32_MAX INT_FAST64_MAX UINT_FAST8_MAX UINT_FAST16_MAX UINT_FAST32_MAX "
    "UINT_FAST64_MAX INT_LEAST8_MIN INT_LEAST16_MIN INT_LEAST32_MIN INT_LEAST64_MIN "
    "INT_LEAST8_MAX INT_LEAST16_MAX INT_LEAST32_MAX INT_LEAST64_MAX UINT_LEAST8_MAX "
    "UINT_LEAST16_MAX UINT_LEAST32_MAX UINT_LEAST64_MAX PTRDIFF_MIN PTRDIFF_MAX SIG_ATOMIC_MIN "
    "SIG_ATOMIC_MAX SIZE_MAX WCHAR_MIN WCHAR_MAX WINT_MIN WINT_MAX "
    "WCONTINUED WEXITED WEXITSTATUS WIFCONTINUED WIFEXITED WIFSIGNALED WIFSTOPPED WNOHANG WNOWAIT "
    "WSTOPPED WSTOPSIG WTERMSIG WUNTRACED "
    "E2BIG EACCES EADDRINUSE EADDRNOTAVAIL EADV EAFNOSUPPORT EAGAIN EALREADY EBADE EBADF EBADFD "
    "EBADMSG EBADR EBADRQC EBADSLT EBFONT EBUSY ECANCELED ECHILD ECHRNG ECOMM ECONNABORTED "
    "ECONNREFUSED ECONNRESET EDEADLK EDEADLOCK EDESTADDRREQ EDOM EDOTDOT EDQUOT EEXIST EFAULT "
    "EFBIG "
    "EHOSTDOWN EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS EINTR EINVAL EIO EISCONN EISDIR "
    "EISNAM EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC EL3HLT EL3RST ELIBACC ELIBBAD "
    "ELIBEXEC ELIBMAX ELIBSCN ELNRNG ELOOP EMEDIUMTYPE EMFILE EMLINK EMSGSIZE EMULTIHOP "
    "ENAMETOOLONG ENAVAIL ENETDOWN ENETRESET ENETUNREACH ENFILE ENOANO ENOBUFS ENOCSI ENODATA "
    "ENODEV ENOENT ENOEXEC ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET ENOPKG ENOPROTOOPT "
    "ENOSPC ENOSR ENOSTR ENOSYS ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM ENOTRECOVERABLE "
    "ENOTSOCK "
    "ENOTSUP ENOTTY ENOTUNIQ ENXIO EOPNOTSUPP EOVERFLOW EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROTO "
    "EPROTONOSUPPORT EPROTOTYPE ERANGE EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN "
    "ESOCKTNOSUPPORT ESPIPE ESRCH ESRMNT ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY "
    "EUCLEAN EUNATCH EUSERS EWOULDBLOCK EXDEV EXFULL";

/// Python's keywords, and names that the generated text uses itself.
constexpr std::string_view kWordsOfPython =
    "False None True and as assert async await break class continue def del elif else except "
    "finally for from global if import in is lambda nonlocal not or pass raise return try while "
    "with yield self stop abc enum bool float int str Actions Event Stop Platform Skill "
    "platform_of Robot NotImplementedError actions made mro name value";

constexpr bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isLower(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool isOfName(char c) { return isUpper(c) || isLower(c) || isDigit(c) || c == '_'; }
constexpr char upper(char c) { return isLower(c) ? static_cast<char>(c - 'a' + 'A') : c; }

void takeWords(StubNames& names, std::string_view words) {
  for (const auto word : std::views::split(words, ' '))
    names.take(std::string(word.begin(), word.end()));
}

/// Takes all names of a header that begin with this.
void takePrefixed(StubNames& names, std::string_view header, std::string_view prefix) {
  for (auto at = header.find(prefix); at != header.npos; at = header.find(prefix, at + 1)) {
    const auto rest = header.substr(at);
    names.take(std::string(rest.begin(), std::ranges::find_if_not(rest, isOfName)));
  }
}

} // namespace

StubNames StubNames::ofC() {
  StubNames names;
  takeWords(names, kWordsOfC);
  takeWords(names, kHeadersOfC);
  takePrefixed(names, header::platformH, "proskill_");
  takePrefixed(names, header::platformH, "PROSKILL_");
  return names;
}

StubNames StubNames::ofPython() {
  StubNames names;
  takeWords(names, kWordsOfPython);
  return names;
}

std::string StubNames::unique(std::string name) {
  while (!taken.insert(name).second) name += '_';
  return name;
}

std::string upperCamel(std::string_view name) {
  std::string made;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') made += begins ? upper(c) : c;
    begins = c == '_';
  }
  return made.empty() || isDigit(made.front()) ? "Value" + made : made;
}

std::string upperSnake(std::string_view name) {
  std::string made;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (i > 0 && isUpper(name[i]) && (isLower(name[i - 1]) || isDigit(name[i - 1]))) made += '_';
    made += upper(name[i]);
  }
  return made;
}

std::string plainName(std::string name) { return name.starts_with('_') ? "name" + name : name; }

std::string functionName(std::string name) {
  const bool looksLikeMacro = name.contains('_') && std::ranges::none_of(name, isLower);
  return plainName(std::move(name)) + (looksLikeMacro ? "_" : "");
}

} // namespace proskill::runtime
