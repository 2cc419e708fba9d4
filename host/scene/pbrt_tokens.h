#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace capcon {

enum class TokenKind { end, word, string, open, close };

/// A piece of pbrt text. `text` points into the file's bytes; of a string it is what stands between the
/// quotes, as written.
struct Token {
  TokenKind kind = TokenKind::end;
  std::string_view text;
  int line = 0;
  int column = 0;
};

/// Cuts pbrt text into words (directives and numbers), quoted strings and brackets; `#` starts a comment to
/// the end of its line. The bytes must outlive it.
class Tokenizer {
 public:
  Tokenizer(std::string file, std::string_view bytes);

  /// The next token, of kind `end` after the last. InputError for a string that its line does not close.
  Token next();
  /// The token that next() will return.
  const Token& peek();
  SourcePlace place(const Token& token) const { return {file_, token.line, token.column}; }
  const std::string& file() const { return file_; }

 private:
  void skip_blanks();
  Token quoted(Token token);

  std::string file_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
  std::optional<Token> ahead_;
};

/// The text of a string token with its escapes (\n \t \r \b \f \\ \" ) replaced.
std::string unescaped(const Token& token);
/// How an error message shows a token: `"word"`, `[`, `the end of the file`.
std::string shown(const Token& token);

}  // namespace capcon
