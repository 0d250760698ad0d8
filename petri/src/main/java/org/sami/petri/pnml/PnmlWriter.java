package org.sami.petri.pnml;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Set;
import java.util.regex.Pattern;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/**
 * Writes nets as PNML (ISO/IEC 15909-2, ptnet), in UTF-8. Inhibitor and reset arcs, which the standard does not have, get the {@code type} that other tools give
 * them. A node whose id is no XML id, or is that of another node, gets another one in the file and its own as a part of this tool; {@link PnmlReader} reads it
 * back. For one thread, once.
 */
public final class PnmlWriter {
    private static final Pattern XML_ID = Pattern.compile("[A-Za-z_][A-Za-z0-9_.-]*");
    private static final Pattern NOT_XML =
            Pattern.compile("[^\\t\\n\\r\\x20-\\uD7FF\\uE000-\\uFFFD\\x{10000}-\\x{10FFFF}]");

    private final PetriNet net;
    private final XMLStreamWriter xml;
    private final Set<String> used = new HashSet<>();
    private int made;

    private PnmlWriter(PetriNet net, XMLStreamWriter xml) {
        this.net = net;
        this.xml = xml;
    }

    /**
     * Writes a net to a stream, which stays open.
     *
     * @throws IllegalArgumentException if an id or a name has a character that XML cannot hold
     */
    public static void write(PetriNet net, OutputStream out) throws IOException {
        try {
            XMLStreamWriter xml =
                    XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(out, StandardCharsets.UTF_8.name());
            new PnmlWriter(net, xml).write();
            xml.flush();
        } catch (UncheckedIOException fault) {
            throw fault.getCause();
        } catch (XMLStreamException fault) {
            throw new IOException("the net cannot be written: " + fault.getMessage(), fault);
        }
    }

    private void write() throws XMLStreamException {
        xml.writeStartDocument(StandardCharsets.UTF_8.name(), "1.0");
        xml.writeCharacters("\n");
        xml.writeStartElement("pnml");
        xml.writeDefaultNamespace("http://www.pnml.org/version-2009/grammar/pnml");
        line();
        xml.writeStartElement("net");
        xml.writeAttribute("id", made("net"));
        xml.writeAttribute("type", "http://www.pnml.org/version-2009/grammar/ptnet");
        if (!net.name().isEmpty()) {
            text("name", net.name());
        }
        line();
        xml.writeStartElement("page");
        xml.writeAttribute("id", made("page"));
        String[] places = new String[net.placeCount()];
        for (int place = 0; place < places.length; place++) {
            places[place] = begin("place", net.placeId(place), net.placeName(place));
            if (net.initial(place) > 0) {
                text("initialMarking", Integer.toString(net.initial(place)));
            }
            xml.writeEndElement();
        }
        for (int t = 0; t < net.transitionCount(); t++) {
            String id = begin("transition", net.transitionId(t), net.transitionName(t));
            xml.writeEndElement();
            arcs(net.consumed(), t, id, places, "");
            arcs(net.inhibitors(), t, id, places, "inhibitor");
            arcs(net.resets(), t, id, places, "reset");
            ArcTable produced = net.produced();
            for (int arc = produced.from(t); arc < produced.to(t); arc++) {
                arc(id, places[produced.node(arc)], produced.weight(arc), "");
            }
        }
        line();
        xml.writeEndDocument();
        xml.writeCharacters("\n");
    }

    private void arcs(ArcTable arcs, int transition, String id, String[] places, String type)
            throws XMLStreamException {
        for (int arc = arcs.from(transition); arc < arcs.to(transition); arc++) {
            arc(places[arcs.node(arc)], id, arcs.weight(arc), type);
        }
    }

    private void arc(String source, String target, int weight, String type) throws XMLStreamException {
        line();
        xml.writeStartElement("arc");
        xml.writeAttribute("id", made("arc"));
        xml.writeAttribute("source", source);
        xml.writeAttribute("target", target);
        if (weight != 1) {
            text("inscription", Integer.toString(weight));
        }
        if (!type.isEmpty()) {
            xml.writeEmptyElement("type");
            xml.writeAttribute("value", type);
        }
        xml.writeEndElement();
    }

    /** Begins a node; returns its id in the file. */
    private String begin(String kind, String id, String name) throws XMLStreamException {
        boolean isOwn = XML_ID.matcher(id).matches() && used.add(id);
        String xmlId = isOwn ? id : made(kind);
        line();
        xml.writeStartElement(kind);
        xml.writeAttribute("id", xmlId);
        if (!name.equals(id)) {
            text("name", name);
        }
        if (!isOwn) {
            xml.writeStartElement("toolspecific");
            xml.writeAttribute("tool", PnmlParser.OWN_TOOL);
            xml.writeAttribute("version", "1");
            element("text", id);
            xml.writeEndElement();
        }
        return xmlId;
    }

    /** An id of the file that no node has, neither before nor after. */
    private String made(String kind) {
        String id;
        do {
            id = "_" + kind + "." + ++made;
        } while (net.place(id).isPresent() || net.transition(id).isPresent() || !used.add(id));
        return id;
    }

    private void text(String label, String text) throws XMLStreamException {
        xml.writeStartElement(label);
        element("text", text);
        xml.writeEndElement();
    }

    private void element(String name, String text) throws XMLStreamException {
        if (NOT_XML.matcher(text).find()) {
            throw new IllegalArgumentException(
                    "'" + NOT_XML.matcher(text).replaceAll("?") + "' has a character that an XML file cannot hold");
        }
        xml.writeStartElement(name);
        xml.writeCharacters(text);
        xml.writeEndElement();
    }

    private void line() throws XMLStreamException {
        xml.writeCharacters("\n");
    }
}
