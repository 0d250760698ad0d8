package org.sami.petri.pnml;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.xml.stream.XMLStreamException;

/** Reads terms and declarations of symmetric nets; of all of them together there may be as many as the limits allow. For one thread. */
final class TermParser {
    private static final Set<String> NAMED = Set.of("feconstant", "partitionelement");

    private final XmlInput xml;
    private final PnmlLimits limits;
    private int count;

    TermParser(XmlInput xml, PnmlLimits limits) {
        this.xml = xml;
        this.limits = limits;
    }

    /** The current element with all that stands in it. */
    XmlTerm read() throws XMLStreamException, RefusedPnmlException {
        if (++count > limits.nodes()) {
            throw new RefusedPnmlException("E-SIZE", xml.line(), "the net has more than " + limits.nodes() + " terms");
        }
        String name = xml.name();
        String reference = xml.attribute("declaration") + xml.attribute("refvariable") + xml.attribute("refpartition");
        String value = name.equals("finiteintrange")
                ? xml.attribute("start") + ".." + xml.attribute("end")
                : xml.attribute(NAMED.contains(name) ? "name" : "value");
        String id = xml.attribute("id");
        int line = xml.line();
        List<XmlTerm> inner = new ArrayList<>();
        while (xml.nextElement()) {
            inner.add(read());
        }
        boolean isNumber = name.equals("numberconstant"); // its parts are the sort that it is a number of
        return new XmlTerm(name, id, reference, value, isNumber ? List.of() : inner, line);
    }
}
