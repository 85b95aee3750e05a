; Comments and messages are prose and format strings for the editors that know these.
((comment) @injection.content
  (#set! injection.language "comment"))

(printf
  .
  (string (string_content) @injection.content)
  (#set! injection.language "printf"))
