package org.sami.petri.pnml;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Writes symmetric nets as other tools do: with graphics, texts for people, parts of tools and one page. */
final class SymmetricNetText {
    private static final String GRAPHICS = "<graphics><position x='10' y='20'/></graphics>";

    private final StringBuilder declarations = new StringBuilder();
    private final StringBuilder nodes = new StringBuilder();
    private int arcs;

    /** A sort of colours {@code id + number}. */
    SymmetricNetText enumeration(String kind, String id, int size) {
        String colours = IntStream.range(0, size)
                .mapToObj(i -> "<feconstant id='" + id + i + "' name='" + i + "'/>")
                .collect(Collectors.joining());
        return sort(id, "<" + kind + ">" + colours + "</" + kind + ">");
    }

    SymmetricNetText sort(String id, String body) {
        declarations.append("<namedsort id='" + id + "' name='" + id + "'>" + body + "</namedsort>\n");
        return this;
    }

    SymmetricNetText product(String id, String... parts) {
        return sort(
                id,
                Stream.of(parts).map(SymmetricNetText::use).collect(Collectors.joining("", "<productsort>", ""))
                        + "</productsort>");
    }

    SymmetricNetText variables(String sort, String... ids) {
        for (String id : ids) {
            declarations.append("<variabledecl id='" + id + "' name='" + id + "'>" + use(sort) + "</variabledecl>\n");
        }
        return this;
    }

    SymmetricNetText place(String id, String sort, String initial) {
        nodes.append("<place id='" + id + "'><name>" + GRAPHICS + "<text>" + id + "</text></name><type><text>" + sort
                + "</text><structure>" + use(sort) + "</structure></type>");
        if (!initial.isEmpty()) {
            nodes.append("<hlinitialMarking><text>m</text><structure>" + initial + "</structure></hlinitialMarking>");
        }
        nodes.append(GRAPHICS + "</place>\n");
        return this;
    }

    SymmetricNetText transition(String id, String condition) {
        nodes.append("<transition id='" + id + "'><name><text>" + id + "</text></name>" + GRAPHICS);
        if (!condition.isEmpty()) {
            nodes.append("<condition><text>c</text><structure>" + condition + "</structure></condition>");
        }
        nodes.append("<toolspecific tool='x' version='1'><part/></toolspecific></transition>\n");
        return this;
    }

    SymmetricNetText arc(String source, String target, String term) {
        nodes.append("<arc id='arc" + arcs++ + "' source='" + source + "' target='" + target
                + "'><hlinscription><text>i</text><structure>" + term + "</structure></hlinscription></arc>\n");
        return this;
    }

    PnmlReading read() {
        String text = "<?xml version='1.0'?><pnml xmlns='http://www.pnml.org/version-2009/grammar/pnml'><net id='n'"
                + " type='http://www.pnml.org/version-2009/grammar/symmetricnet'><name><text>n</text></name>"
                + "<declaration><structure><declarations>" + declarations
                + "</declarations></structure></declaration><page id='page'><name><text>p</text></name>" + nodes
                + "</page></net></pnml>";
        return PnmlReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), PnmlLimits.STANDARD);
    }

    static String v(String variable) {
        return "<variable refvariable='" + variable + "'/>";
    }

    static String colour(String id) {
        return "<useroperator declaration='" + id + "'/>";
    }

    static String op(String name, String... arguments) {
        return Stream.of(arguments)
                        .map(argument -> "<subterm>" + argument + "</subterm>")
                        .collect(Collectors.joining("", "<" + name + ">", ""))
                + "</" + name + ">";
    }

    /** A term once, as most tools write it. */
    static String one(String term) {
        return op("numberof", "<numberconstant value='1'><positive/></numberconstant>", term);
    }

    static String all(String sort) {
        return "<all>" + use(sort) + "</all>";
    }

    static String none(String sort) {
        return "<empty>" + use(sort) + "</empty>";
    }

    static String dot() {
        return one("<dotconstant/>");
    }

    private static String use(String sort) {
        return "<usersort declaration='" + sort + "'/>";
    }
}
