#include "scene/pbrt_tokens.h"

namespace capcon {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}
bool ends_word(char c) {
  return is_blank(c) || c == '"' || c == '[' || c == ']' || c == '#';
}

}  // namespace

Tokenizer::Tokenizer(std::string file, std::string_view bytes) : file_(std::move(file)), bytes_(bytes) {
  if (bytes_.starts_with("\xEF\xBB\xBF")) at_ = line_start_ = 3;  // a byte order mark is no text
}

void Tokenizer::skip_blanks() {
  for (; at_ < bytes_.size(); ++at_) {
    if (bytes_[at_] == '#') {
      at_ = std::min(bytes_.find('\n', at_), bytes_.size());
      if (at_ == bytes_.size()) return;
    }
    if (!is_blank(bytes_[at_])) return;
    if (bytes_[at_] == '\n') {
      ++line_;
      line_start_ = at_ + 1;
    }
  }
}

Token Tokenizer::next() {
  if (ahead_) {
    const Token token = *ahead_;
    ahead_.reset();
    return token;
  }
  skip_blanks();
  Token token{TokenKind::end, {}, line_, static_cast<int>(at_ - line_start_) + 1};
  if (at_ == bytes_.size()) return token;
  const char first = bytes_[at_];
  if (first == '"') return quoted(token);
  const std::size_t start = at_++;
  if (first == '[' || first == ']') {
    token.kind = first == '[' ? TokenKind::open : TokenKind::close;
  } else {
    token.kind = TokenKind::word;
    while (at_ < bytes_.size() && !ends_word(bytes_[at_])) ++at_;
  }
  token.text = bytes_.substr(start, at_ - start);
  return token;
}

Token Tokenizer::quoted(Token token) {
  const std::size_t start = ++at_;
  for (; at_ < bytes_.size() && bytes_[at_] != '\n'; ++at_) {
    if (bytes_[at_] == '"') {
      token.kind = TokenKind::string;
      token.text = bytes_.substr(start, at_++ - start);
      return token;
    }
    if (bytes_[at_] == '\\' && at_ + 1 < bytes_.size() && bytes_[at_ + 1] != '\n') ++at_;
  }
  throw InputError(place(token), "this string is not closed on its line; put a \" at its end");
}

const Token& Tokenizer::peek() {
  if (!ahead_) ahead_ = next();
  return *ahead_;
}

std::string unescaped(const Token& token) {
  std::string text;
  text.reserve(token.text.size());
  for (std::size_t i = 0; i < token.text.size(); ++i) {
    char c = token.text[i];
    if (c == '\\' && i + 1 < token.text.size()) {
      switch (c = token.text[++i]) {
        case 'n':
          c = '\n';
          break;
        case 't':
          c = '\t';
          break;
        case 'r':
          c = '\r';
          break;
        case 'b':
          c = '\b';
          break;
        case 'f':
          c = '\f';
          break;
        default:
          break;  // the character itself
      }
    }
    text += c;
  }
  return text;
}

std::string shown(const Token& token) {
  if (token.kind == TokenKind::end) return "the end of the file";
  if (token.kind == TokenKind::open || token.kind == TokenKind::close) return std::string(token.text);
  const bool cut = token.text.size() > 40;
  return '"' + std::string(token.text.substr(0, 40)) + (cut ? "...\"" : "\"");
}

}  // namespace capcon
