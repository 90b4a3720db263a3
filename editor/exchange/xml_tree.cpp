#include "editor/exchange/xml_tree.h"

#include "editor/exchange/codes.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <optional>

namespace spacetow {

namespace {

constexpr int maxDepth = 200;
constexpr int maxElements = 1'000'000;

std::string utf8(QStringView text) {
    return text.toUtf8().toStdString();
}

/// Files that were cut out of others use prefixes that they do not declare, so prefixes are taken as they are.
std::string withoutPrefix(std::string name, std::string_view prefix) {
    return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

class XmlTreeReader {
  public:
    XmlTreeReader(std::string_view bytes, const Watch& watch)
        : m_xml(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()))),
          m_size(std::max<std::size_t>(1, bytes.size())), m_watch(watch) {
        m_xml.setNamespaceProcessing(false);
    }

    Result<XmlElement> read() {
        while (!m_xml.atEnd() && !m_error) {
            step();
        }
        if (m_error) {
            return *m_error;
        }
        if (m_xml.hasError() || !m_hasRoot) {
            return Error{ExchangeCode("import-not-xml"),
                         {std::to_string(m_xml.lineNumber()), std::to_string(m_xml.columnNumber() + 1),
                          m_xml.errorString().toStdString()}};
        }
        return std::move(m_root);
    }

  private:
    void step() {
        switch (m_xml.readNext()) {
        case QXmlStreamReader::DTD:
            if (!m_xml.entityDeclarations().isEmpty()) {
                m_error = Error{ExchangeCode("import-entities"), {std::to_string(m_xml.lineNumber())}};
            }
            break;
        case QXmlStreamReader::StartElement:
            open();
            break;
        case QXmlStreamReader::EndElement:
            close();
            break;
        case QXmlStreamReader::Characters:
            if (!m_open.empty()) {
                m_open.back().text += utf8(m_xml.text());
            }
            break;
        default:
            break;
        }
    }

    void open() {
        constexpr int pace = 256; // elements between looks at the clock on the wall
        if (++m_count % pace == 0) {
            m_watch.tell(static_cast<int>(
                std::min<std::size_t>(99, static_cast<std::size_t>(m_xml.characterOffset()) * 100 / m_size)));
            if (m_watch.isStopped()) {
                m_error = Error{ExchangeCode("import-stopped"), {}};
            }
        }
        if (m_count > maxElements) {
            m_error = Error{ExchangeCode("import-too-many"), {std::to_string(maxElements)}};
        }
        if (static_cast<int>(m_open.size()) >= maxDepth) {
            m_error = Error{ExchangeCode("import-too-deep"), {std::to_string(maxDepth)}};
        }
        XmlElement element;
        element.name = withoutPrefix(utf8(m_xml.qualifiedName()), "svg:");
        element.line = static_cast<int>(m_xml.lineNumber());
        for (const QXmlStreamAttribute& attribute : m_xml.attributes()) {
            element.attributes.emplace_back(withoutPrefix(utf8(attribute.qualifiedName()), "xlink:"),
                                            utf8(attribute.value()));
        }
        m_open.push_back(std::move(element));
    }

    void close() {
        XmlElement element = std::move(m_open.back());
        m_open.pop_back();
        if (m_open.empty()) {
            m_root = std::move(element);
            m_hasRoot = true;
        } else {
            m_open.back().children.push_back(std::move(element));
        }
    }

    QXmlStreamReader m_xml;
    std::size_t m_size;
    const Watch& m_watch;
    std::vector<XmlElement> m_open; // from the root to the innermost
    XmlElement m_root;
    bool m_hasRoot = false;
    int m_count = 0;
    std::optional<Error> m_error;
};

} // namespace

const std::string& XmlElement::attribute(std::string_view wanted) const {
    static const std::string none;
    const auto found =
        std::ranges::find(attributes, wanted, [](const auto& one) -> std::string_view { return one.first; });
    return found == attributes.end() ? none : found->second;
}

bool XmlElement::has(std::string_view wanted) const {
    return std::ranges::any_of(attributes, [wanted](const auto& one) { return one.first == wanted; });
}

Result<XmlElement> parseXml(std::string_view bytes, const Watch& watch) {
    return XmlTreeReader(bytes, watch).read();
}

} // namespace spacetow
