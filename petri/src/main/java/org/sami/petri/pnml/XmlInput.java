package org.sami.petri.pnml;

import java.io.BufferedInputStream;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import javax.xml.XMLConstants;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * The elements of a strange XML file, one after the other. Refuses document types and entities of its own, which could read other files or grow without end, more
 * bytes than are allowed, and elements that are nested too deep. For one thread.
 */
final class XmlInput {
    private static final int HEAD = 200; // bytes, in which the encoding is declared
    private static final Pattern ENCODING =
            Pattern.compile("^(?:\u00ef\u00bb\u00bf)?<\\?xml[^>]*\\sencoding\\s*=\\s*[\"']([\\w.-]+)");
    private static final String UTF8_MARK = "\u00ef\u00bb\u00bf"; // its bytes

    private final XMLStreamReader xml;
    private final PnmlLimits limits;
    private int depth;

    XmlInput(InputStream in, PnmlLimits limits) throws XMLStreamException {
        this.limits = limits;
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false);
        factory.setProperty(XMLInputFactory.IS_COALESCING, false);
        factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
        xml = reader(factory, new BufferedInputStream(new Counted(in, limits.bytes())));
    }

    /** UTF-8, which PNML is written in, is decoded here: the JDK's own decoder prints a line of its own about bytes that are none. */
    private static XMLStreamReader reader(XMLInputFactory factory, BufferedInputStream in) throws XMLStreamException {
        try {
            in.mark(HEAD);
            String head = new String(in.readNBytes(HEAD), StandardCharsets.ISO_8859_1);
            in.reset();
            boolean isUtf8 = ENCODING.matcher(head)
                    .results()
                    .allMatch(encoding -> encoding.group(1).equalsIgnoreCase("UTF-8"));
            boolean isUtf16 =
                    head.startsWith("\u00fe\u00ff") || head.startsWith("\u00ff\u00fe") || head.indexOf(0) >= 0;
            if (!isUtf8 || isUtf16) {
                return factory.createXMLStreamReader(in);
            }
            in.skipNBytes(head.startsWith(UTF8_MARK) ? UTF8_MARK.length() : 0);
            return factory.createXMLStreamReader(
                    new InputStreamReader(in, StandardCharsets.UTF_8.newDecoder())); // faults are no question marks
        } catch (IOException fault) {
            throw new XMLStreamException(String.valueOf(fault.getMessage()), fault);
        }
    }

    /** Goes on to the next tag; whether it begins an element. False at the end of the enclosing element or of the file. */
    boolean nextElement() throws XMLStreamException, RefusedPnmlException {
        while (xml.hasNext()) {
            switch (xml.next()) {
                case XMLStreamConstants.START_ELEMENT -> {
                    if (++depth > limits.depth()) {
                        throw new RefusedPnmlException(
                                "E-DEPTH", line(), "elements are nested deeper than " + limits.depth());
                    }
                    return true;
                }
                case XMLStreamConstants.END_ELEMENT -> {
                    depth--;
                    return false;
                }
                default -> refuseEntities();
            }
        }
        return false;
    }

    /** Skips what is left of the current element. */
    void skip() throws XMLStreamException, RefusedPnmlException {
        int outer = depth - 1;
        while (depth > outer) {
            nextElement();
        }
    }

    /** The text of the current element, without that of elements in it; the element ends. */
    String text() throws XMLStreamException, RefusedPnmlException {
        StringBuilder text = new StringBuilder();
        while (xml.hasNext()) {
            switch (xml.next()) {
                case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA, XMLStreamConstants.SPACE -> {
                    text.append(xml.getTextCharacters(), xml.getTextStart(), xml.getTextLength());
                    if (text.length() > limits.text()) {
                        throw new RefusedPnmlException(
                                "E-SIZE", line(), "a text is longer than " + limits.text() + " characters");
                    }
                }
                case XMLStreamConstants.START_ELEMENT -> {
                    depth++;
                    skip();
                }
                case XMLStreamConstants.END_ELEMENT -> {
                    depth--;
                    return text.toString().strip();
                }
                default -> refuseEntities();
            }
        }
        return text.toString().strip();
    }

    private void refuseEntities() throws RefusedPnmlException {
        int event = xml.getEventType();
        if (event == XMLStreamConstants.DTD) {
            throw new RefusedPnmlException(
                    "E-DTD", line(), "the file has a document type (DOCTYPE), which is not read");
        }
        if (event == XMLStreamConstants.ENTITY_REFERENCE) {
            throw new RefusedPnmlException(
                    "E-DTD", line(), "the entity &" + xml.getLocalName() + "; is not one of XML's own");
        }
    }

    /** The name of the current element, without its prefix. */
    String name() {
        return xml.getLocalName();
    }

    /** An attribute of the current element; empty text where it is absent. Its length is limited as that of texts. */
    String attribute(String name) throws RefusedPnmlException {
        String value = xml.getAttributeValue(null, name);
        if (value != null && value.length() > limits.text()) {
            throw new RefusedPnmlException(
                    "E-SIZE", line(), "the attribute " + name + " is longer than " + limits.text() + " characters");
        }
        return value == null ? "" : value.strip();
    }

    /** The names of the current element's attributes that have no prefix. Those with one belong to other vocabularies. */
    List<String> attributes() {
        List<String> names = new ArrayList<>();
        for (int i = 0; i < xml.getAttributeCount(); i++) {
            String prefix = xml.getAttributePrefix(i);
            if (prefix == null || prefix.isEmpty()) {
                names.add(xml.getAttributeLocalName(i));
            }
        }
        return names;
    }

    int line() {
        return xml.getLocation().getLineNumber();
    }

    /** Ends with a fault once more bytes than allowed were read. */
    private static final class Counted extends FilterInputStream {
        private final long limit;
        private long left;

        Counted(InputStream in, long limit) {
            super(in);
            this.limit = limit;
            left = limit;
        }

        @Override
        public int read() throws IOException {
            int value = super.read();
            return value < 0 ? value : count(1, value);
        }

        @Override
        public int read(byte[] into, int offset, int length) throws IOException {
            int read = super.read(into, offset, length);
            return read < 0 ? read : count(read, read);
        }

        private int count(int bytes, int result) throws IOException {
            left -= bytes;
            if (left < 0) {
                throw new IOException("the file is larger than " + limit + " bytes");
            }
            return result;
        }
    }
}
