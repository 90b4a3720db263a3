#include "editor/exchange/capsule_text.h"

#include "core/base/hash.h"
#include "editor/exchange/codes.h"

#include <QByteArray>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>

namespace spacetow {

namespace {

constexpr std::string_view capsuleBegin = "BEGIN SPACETOW BUG CAPSULE";
constexpr std::string_view capsuleEnd = "END SPACETOW BUG CAPSULE";
constexpr std::string_view capsuleDashes = "-----";
constexpr std::size_t lineLength = 76;
// Each piece is compressed by itself: deflate makes at most 1032 times as many bytes of some, so that what claims to be
// a piece is known to be small before it is unpacked.
constexpr std::size_t pieceBytes = 128u << 10;
constexpr std::size_t packedLimit = pieceBytes + pieceBytes / 8 + 64;
constexpr int lengthBytes = 4; // before each piece, the highest first

void appendLength(QByteArray& to, qsizetype length) {
    for (int shift = 24; shift >= 0; shift -= 8) {
        to.append(static_cast<char>((length >> shift) & 0xff));
    }
}

std::size_t lengthAt(const QByteArray& bytes, qsizetype at) {
    std::size_t length = 0;
    for (int i = 0; i < lengthBytes; ++i) {
        length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return length;
}

QByteArray packed(std::string_view json) {
    constexpr int best = 9;
    QByteArray all;
    for (std::size_t at = 0; at < json.size(); at += pieceBytes) {
        const std::string_view piece = json.substr(at, pieceBytes);
        const QByteArray compressed =
            qCompress(reinterpret_cast<const uchar*>(piece.data()), qsizetype(piece.size()), best);
        appendLength(all, compressed.size());
        all.append(compressed);
    }
    return all;
}

/// Nothing when it is damaged.
std::optional<std::string> unpacked(const QByteArray& bytes) {
    std::string json;
    for (qsizetype at = 0; at < bytes.size();) {
        if (bytes.size() - at < lengthBytes) {
            return {};
        }
        const std::size_t length = lengthAt(bytes, at);
        at += lengthBytes;
        if (length > packedLimit || qsizetype(length) > bytes.size() - at || length < lengthBytes ||
            lengthAt(bytes, at) > pieceBytes) { // qUncompress makes room for what is written there
            return {};
        }
        const QByteArray piece = qUncompress(reinterpret_cast<const uchar*>(bytes.constData()) + at, qsizetype(length));
        at += qsizetype(length);
        if (piece.isEmpty() || std::size_t(piece.size()) > pieceBytes || json.size() + pieceBytes > maxCapsuleBytes) {
            return {};
        }
        json.append(piece.constData(), std::size_t(piece.size()));
    }
    return json;
}

bool isOfBase64(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' || c == '/' ||
           c == '=';
}

/// So that no change of any letter goes unnoticed.
std::string checksum(std::string_view base64) {
    StateHash hash;
    std::ranges::for_each(base64, [&hash](char c) { hash.add(std::uint64_t{static_cast<unsigned char>(c)}); });
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.value()));
    return text;
}

struct CapsuleBody {
    std::string base64;
    std::string checksum; // as the last line says
};

/// What is between the first and the last line; none when the last is missing.
std::optional<CapsuleBody> bodyOf(std::string_view text) {
    const std::size_t begin = text.find(capsuleBegin);
    const std::size_t from = text.find('\n', begin);
    const std::size_t end = text.find(capsuleEnd, begin);
    if (from == std::string_view::npos || end == std::string_view::npos || end < from) {
        return {};
    }
    CapsuleBody body;
    std::ranges::copy_if(text.substr(from, end - from), std::back_inserter(body.base64), isOfBase64);
    const std::string_view last = text.substr(end + capsuleEnd.size());
    std::ranges::copy_if(last.substr(0, last.find('-')), std::back_inserter(body.checksum), isOfBase64);
    return body;
}

/// One line; whatever else might be in a name.
std::string inOneLine(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return text;
}

} // namespace

Result<std::string> capsuleText(const Capsule& capsule) {
    const Result<std::string> written = capsuleJson(capsule);
    if (!written) {
        return written.error();
    }
    const std::string& json = written.value();
    const QByteArray base64 = json.size() + pieceBytes > maxCapsuleBytes ? QByteArray() : packed(json).toBase64();
    if (base64.isEmpty() || std::size_t(base64.size()) > maxCapsuleText / 2) {
        return Error{ExchangeCode("capsule-too-large"), {std::to_string(maxCapsuleBytes)}};
    }
    std::string text = inOneLine(capsule.program + ", " + capsule.platform) + '\n' +
                       inOneLine(capsule.run.level + ", update " + std::to_string(capsule.run.updates())) + '\n';
    text += std::string(capsuleDashes) + std::string(capsuleBegin) + std::string(capsuleDashes) + '\n';
    const std::string_view all(base64.constData(), std::size_t(base64.size()));
    for (std::size_t at = 0; at < all.size(); at += lineLength) {
        text += all.substr(at, lineLength);
        text += '\n';
    }
    return text + std::string(capsuleDashes) + std::string(capsuleEnd) + ' ' + checksum(all) +
           std::string(capsuleDashes) + '\n';
}

bool holdsCapsule(std::string_view text) {
    return text.find(capsuleBegin) != std::string_view::npos;
}

Result<Capsule> capsuleFromText(std::string_view text) {
    if (!holdsCapsule(text)) {
        return Error{ExchangeCode("capsule-none"), {}};
    }
    if (text.size() > maxCapsuleText) {
        return Error{ExchangeCode("capsule-too-large"), {std::to_string(maxCapsuleText)}};
    }
    const std::optional<CapsuleBody> body = bodyOf(text);
    if (!body) {
        return Error{ExchangeCode("capsule-cut"), {}};
    }
    if (checksum(body->base64) != body->checksum) {
        return Error{ExchangeCode("capsule-damaged"), {}};
    }
    const auto decoded = QByteArray::fromBase64Encoding(QByteArray::fromStdString(body->base64),
                                                        QByteArray::AbortOnBase64DecodingErrors);
    const std::optional<std::string> json = decoded ? unpacked(*decoded) : std::nullopt;
    return json ? parseCapsule(*json) : Result<Capsule>(Error{ExchangeCode("capsule-damaged"), {}});
}

} // namespace spacetow
