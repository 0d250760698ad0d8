package org.sami.crw.report.file;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;

/** An XML document that is written element by element, indented, in UTF-8. What XML cannot hold of a text becomes a question mark. */
final class XmlText {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private final XMLStreamWriter xml;
    private int depth;
    private boolean hasChildren;

    /** A document whose outermost element is open. */
    XmlText(String root, String namespace) {
        try {
            xml = XMLOutputFactory.newFactory().createXMLStreamWriter(bytes, StandardCharsets.UTF_8.name());
            xml.writeStartDocument(StandardCharsets.UTF_8.name(), "1.0");
        } catch (XMLStreamException e) {
            throw new IllegalStateException("memory can be written to", e);
        }
        open(root);
        write(() -> xml.writeDefaultNamespace(namespace));
    }

    @FunctionalInterface
    private interface Step {
        void write() throws XMLStreamException;
    }

    private static void write(Step step) {
        try {
            step.write();
        } catch (XMLStreamException e) {
            throw new IllegalStateException("memory can be written to", e);
        }
    }

    /** Begins an element; attributes are pairs of name and value. */
    XmlText open(String element, String... attributes) {
        write(() -> {
            indent();
            xml.writeStartElement(element);
            for (int i = 0; i < attributes.length; i += 2) {
                xml.writeAttribute(attributes[i], clean(attributes[i + 1]));
            }
        });
        depth++;
        hasChildren = false;
        return this;
    }

    /** An attribute of the element that was opened last. */
    XmlText attribute(String name, String value) {
        write(() -> xml.writeAttribute(name, clean(value)));
        return this;
    }

    /** Declares a prefix on the element that was opened last. */
    XmlText prefix(String prefix, String namespace) {
        write(() -> xml.writeNamespace(prefix, namespace));
        return this;
    }

    /** An element with text in it. */
    XmlText leaf(String element, String text) {
        write(() -> {
            indent();
            xml.writeStartElement(element);
            xml.writeCharacters(clean(text));
            xml.writeEndElement();
        });
        hasChildren = true;
        return this;
    }

    /** Ends the innermost open element. */
    XmlText close() {
        depth--;
        write(() -> {
            if (hasChildren) {
                indent();
            }
            xml.writeEndElement();
        });
        hasChildren = true;
        return this;
    }

    /** Ends the document. */
    String end() {
        close();
        write(() -> {
            xml.writeCharacters("\n");
            xml.writeEndDocument();
            xml.close();
        });
        return bytes.toString(StandardCharsets.UTF_8);
    }

    private void indent() throws XMLStreamException {
        xml.writeCharacters("\n" + " ".repeat(depth));
    }

    /** Degrees to about a centimetre. */
    static String degrees(double value) {
        return String.format(Locale.ROOT, "%.7f", value);
    }

    private static String clean(String text) {
        StringBuilder clean = new StringBuilder();
        text.codePoints().map(c -> isXml(c) ? c : '?').forEach(clean::appendCodePoint);
        return clean.toString();
    }

    private static boolean isXml(int c) {
        boolean low = c == '\t' || c == '\n' || c == '\r' || (c >= 0x20 && c <= 0xD7FF);
        return low || (c >= 0xE000 && c != 0xFFFE && c != 0xFFFF);
    }
}
