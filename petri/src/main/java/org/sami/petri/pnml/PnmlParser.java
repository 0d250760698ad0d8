package org.sami.petri.pnml;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import javax.xml.stream.XMLStreamException;
import org.sami.petri.pnml.PnmlParts.ArcKind;

/** Reads the first net of a file into its parts, and notes what is wrong with them or left out. For one thread, once. */
final class PnmlParser {
    /** What our own writer notes of a node: the id that it has in the net, where that cannot be its id in the file. */
    static final String OWN_TOOL = "org.sami.petri";

    private static final String PT_NET = "http://www.pnml.org/version-2009/grammar/ptnet";
    private static final String SYMMETRIC_NET = "http://www.pnml.org/version-2009/grammar/symmetricnet";

    /** The labels of symmetric nets; the type of an arc is no term, but its kind. */
    private static final Set<String> TERMS = Set.of("type", "hlinitialMarking", "hlinscription", "condition");

    private static final String WEIGHT = "inscription";

    private static final Set<String> NODE_ATTRIBUTES = Set.of("id");
    private static final Set<String> ARC_ATTRIBUTES = Set.of("id", "source", "target", "type");

    /** Types of place/transition nets: of the standard, of its extensions, and of earlier tools. */
    private static final Pattern PT_NETS = Pattern.compile("P/T net|https?://www\\.pnml\\.org/version-2009/"
            + "(grammar/(ptnet|pnmlcoremodel)|extensions/(inhibitor|reset|resetinhibitor)ptnet)");

    private final XmlInput xml;
    private final PnmlLimits limits;
    private final FindingList findings;
    private final PnmlParts parts = new PnmlParts();
    private final TermParser terms;
    private final Map<String, Integer> tools = new TreeMap<>();
    private int graphics;

    /** What stands in a node or an arc. */
    private static final class Content {
        private String ownId = "";
        private String name = "";
        private int number;
        private ArcKind kind = ArcKind.NORMAL;
        private final Map<String, XmlTerm> terms = new HashMap<>();
    }

    PnmlParser(XmlInput xml, PnmlLimits limits, FindingList findings) {
        this.xml = xml;
        this.limits = limits;
        this.findings = findings;
        terms = new TermParser(xml, limits);
    }

    PnmlParts parse() throws XMLStreamException, RefusedPnmlException {
        if (!xml.nextElement() || !xml.name().equals("pnml")) {
            throw new RefusedPnmlException("E-XML", xml.line(), "this is no PNML: the outermost element is not pnml");
        }
        boolean hasNet = false;
        while (xml.nextElement()) {
            if (xml.name().equals("net") && !hasNet) {
                hasNet = true;
                net();
            } else if (xml.name().equals("net")) {
                findings.warning(
                        "W-NETS", xml.line(), "net " + xml.attribute("id"), "only the first net of a file is read");
                xml.skip();
            } else {
                other("pnml");
            }
        }
        if (!hasNet) {
            findings.error("E-XML", 0, "pnml", "there is no net in the file");
        }
        tools.forEach((tool, count) ->
                findings.note("N-TOOL", 0, "", count + " parts of the tool " + tool + " (toolspecific) were left out"));
        if (graphics > 0) {
            findings.note("N-GRAPHICS", 0, "", graphics + " descriptions of graphics were left out");
        }
        return parts;
    }

    private void net() throws XMLStreamException, RefusedPnmlException {
        String type = xml.attribute("type");
        String element = "net " + xml.attribute("id");
        parts.isColoured = type.equals(SYMMETRIC_NET);
        if (!parts.isColoured && !PT_NETS.matcher(type).matches()) {
            findings.error(
                    "E-TYPE",
                    xml.line(),
                    element,
                    "nets of the type '" + type + "' are not read, only " + PT_NET + " and " + SYMMETRIC_NET);
            xml.skip();
            return;
        }
        while (xml.nextElement()) {
            if (xml.name().equals("name")) {
                parts.name = label(element);
            } else if (!pageContent()) {
                other(element);
            }
        }
    }

    /** Reads an element that may stand on a page; false where the current one is none. */
    private boolean pageContent() throws XMLStreamException, RefusedPnmlException {
        switch (xml.name()) {
            case "page" -> page();
            case "place" -> node("place");
            case "transition" -> node("transition");
            case "arc" -> arc();
            case "declaration" -> declarations();
            case "referencePlace" -> reference("referencePlace");
            case "referenceTransition" -> reference("referenceTransition");
            default -> {
                return false;
            }
        }
        if (parts.nodes() > limits.nodes()) {
            throw new RefusedPnmlException("E-SIZE", xml.line(), "the net has more than " + limits.nodes() + " nodes");
        }
        if (parts.arcs.size() > limits.arcs()) {
            throw new RefusedPnmlException("E-SIZE", xml.line(), "the net has more than " + limits.arcs() + " arcs");
        }
        return true;
    }

    /** A page: its nodes and arcs belong to the net like any other. */
    private void page() throws XMLStreamException, RefusedPnmlException {
        String element = "page " + xml.attribute("id");
        while (xml.nextElement()) {
            if (xml.name().equals("name")) {
                xml.skip();
            } else if (!pageContent()) {
                other(element);
            }
        }
    }

    private void declarations() throws XMLStreamException, RefusedPnmlException {
        while (xml.nextElement()) {
            if (xml.name().equals("structure")) {
                for (XmlTerm list : terms.read().parts()) {
                    parts.declarations.addAll(list.parts());
                }
            } else {
                xml.skip();
            }
        }
    }

    /** The structure of a label, which is a term; its text says the same for people. A text alone is not read. */
    private void structure(String label, Content content, String element)
            throws XMLStreamException, RefusedPnmlException {
        int line = xml.line();
        String text = "";
        while (xml.nextElement()) {
            switch (xml.name()) {
                case "structure" -> content.terms.put(label, terms.read().only());
                case "text" -> text = xml.text();
                default -> other(element);
            }
        }
        if (!content.terms.containsKey(label) && !text.isBlank()) {
            findings.error("E-TERM", line, element, label + " '" + text + "' has no structure: texts are not read");
        }
    }

    private void node(String kind) throws XMLStreamException, RefusedPnmlException {
        int line = xml.line();
        String id = id(kind);
        attributesBut(NODE_ATTRIBUTES, kind + " " + id);
        Content content = content(kind + " " + id, kind.equals("place") ? "initialMarking" : "", 0);
        String own = content.ownId.isEmpty() ? id : content.ownId;
        PnmlParts.Node node = new PnmlParts.Node(
                id, own, content.name.isEmpty() ? own : content.name, content.number, line, Map.copyOf(content.terms));
        (kind.equals("place") ? parts.places : parts.transitions).add(node);
    }

    private void reference(String kind) throws XMLStreamException, RefusedPnmlException {
        PnmlParts.Reference reference = new PnmlParts.Reference(id(kind), xml.attribute("ref"), xml.line());
        content(kind + " " + reference.id(), "", 0);
        (kind.equals("referencePlace") ? parts.placeReferences : parts.transitionReferences).add(reference);
    }

    private void arc() throws XMLStreamException, RefusedPnmlException {
        int line = xml.line();
        String id = xml.attribute("id");
        String source = xml.attribute("source");
        String target = xml.attribute("target");
        String element = "arc " + id;
        attributesBut(ARC_ATTRIBUTES, element);
        String type = xml.attribute("type");
        if (!type.isEmpty() && !type.equalsIgnoreCase("normal")) {
            findings.error(
                    "E-ARC",
                    line,
                    element,
                    "the attribute type='" + type + "' is not read: the element type says what an arc is");
        }
        Content content = content(element, WEIGHT, 1);
        parts.arcs.add(
                new PnmlParts.Arc(id, source, target, content.number, content.kind, line, Map.copyOf(content.terms)));
    }

    /** Warns of each attribute of the current element that is not among the known ones, as it would change the net where it had a meaning. */
    private void attributesBut(Set<String> known, String element) {
        for (String name : xml.attributes()) {
            if (!known.contains(name)) {
                findings.warning(
                        "W-ATTRIBUTE", xml.line(), element, "the attribute " + name + " is not known, and left out");
            }
        }
    }

    private String id(String kind) throws RefusedPnmlException {
        String id = xml.attribute("id");
        if (id.isEmpty()) {
            findings.error("E-ID", xml.line(), kind, "a " + kind + " has no id");
        }
        return id;
    }

    /** Reads what stands in a node or an arc to its end. In a symmetric net plain numbers have no meaning: its terms say how many tokens there are. */
    private Content content(String element, String numberLabel, int number)
            throws XMLStreamException, RefusedPnmlException {
        Content content = new Content();
        content.number = number;
        while (xml.nextElement()) {
            String name = xml.name();
            if (name.equals("name")) {
                content.name = label(element);
            } else if (!parts.isColoured && name.equals(numberLabel)) {
                int line = xml.line();
                content.number = number(label(element), number, line, element);
            } else if (parts.isColoured
                    && TERMS.contains(name)
                    && !(name.equals("type") && numberLabel.equals(WEIGHT))
                    && xml.attribute("value").isEmpty()) {
                structure(name, content, element);
            } else if (name.equals("type") || name.equals("arctype")) {
                arcKind(content, element);
            } else if (name.equals("toolspecific") && xml.attribute("tool").equals(OWN_TOOL)) {
                content.ownId = label(element);
            } else {
                other(element);
            }
        }
        return content;
    }

    /** The text of a label such as a name; what else stands in it is graphics or of a tool. */
    private String label(String element) throws XMLStreamException, RefusedPnmlException {
        String text = "";
        while (xml.nextElement()) {
            if (xml.name().equals("text") || xml.name().equals("value")) {
                text = xml.text();
            } else {
                other(element);
            }
        }
        return text;
    }

    /** A number of tokens or a weight, which must be at least {@code least}. */
    private int number(String text, int least, int line, String element) {
        if (text.isEmpty()) {
            return least;
        }
        if (!text.matches("[+-]?\\d+")) {
            findings.error("E-NUMBER", line, element, "'" + text + "' is no whole number");
            return least;
        }
        String digits = text.replaceFirst("^[+-]?0*(?=\\d)", "");
        boolean isNegative = text.startsWith("-") && !digits.equals("0");
        if (isNegative
                || digits.length() > 10
                || Long.parseLong(digits) > Integer.MAX_VALUE
                || Long.parseLong(digits) < least) {
            findings.error("E-NUMBER", line, element, text + " is not between " + least + " and " + Integer.MAX_VALUE);
            return least;
        }
        return Integer.parseInt(digits);
    }

    /** The kind of an arc, which tools write as an attribute {@code value} or as a text. */
    private void arcKind(Content content, String element) throws XMLStreamException, RefusedPnmlException {
        int line = xml.line();
        String value = xml.attribute("value");
        String text = label(element);
        String kind = (value.isEmpty() ? text : value).toLowerCase(Locale.ROOT);
        switch (kind) {
            case "", "normal" -> content.kind = ArcKind.NORMAL;
            case "inhibitor" -> content.kind = ArcKind.INHIBITOR;
            case "reset" -> content.kind = ArcKind.RESET;
            case "read", "test" -> content.kind = ArcKind.READ;
            default -> findings.error("E-ARC", line, element, "arcs of the type '" + kind + "' are not read");
        }
    }

    /** An element that has no meaning for the net, or none that is known. */
    private void other(String element) throws XMLStreamException, RefusedPnmlException {
        switch (xml.name()) {
            case "toolspecific" -> tools.merge(xml.attribute("tool"), 1, Integer::sum);
            case "graphics" -> graphics++;
            default ->
                findings.warning(
                        "W-ELEMENT", xml.line(), element, "the element " + xml.name() + " is not known, and left out");
        }
        xml.skip();
    }
}
