package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.petri.net.PetriNet;

class PnmlReaderTest {
    private static final String HEAD = """
        <?xml version="1.0"?>
        <pnml xmlns="http://www.pnml.org/version-2009/grammar/pnml">
        <net id="n" type="http://www.pnml.org/version-2009/grammar/ptnet">
        """;
    private static final String TAIL = "</net></pnml>";

    private static PnmlReading read(String text) {
        return PnmlReader.read(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), PnmlLimits.STANDARD);
    }

    private static PnmlReading net(String content) {
        return read(HEAD + content + TAIL);
    }

    @Test
    void readsNamesMarkingsInscriptionsAndPages() {
        PnmlReading reading = net("""
            <name><text>two pages</text></name>
            <page id="g1">
              <place id="p"><name><text> In the
               dock </text><graphics><offset x="1" y="2"/></graphics></name><initialMarking><text> 3 </text></initialMarking></place>
              <page id="g2"><name><text>inner</text></name>
                <referencePlace id="r1" ref="r2"/>
                <transition id="t"><toolspecific tool="other" version="1"><deep><deeper/></deep></toolspecific></transition>
                <arc id="a" source="r1" target="t"><inscription><text>2</text></inscription></arc>
                <arc id="b" source="t" target="q"/>
              </page>
              <referencePlace id="r2" ref="p"/>
              <place id="q"/>
            </page>
            """);

        PetriNet net = reading.net().orElseThrow();
        assertThat(net.name()).isEqualTo("two pages");
        assertThat(net.placeName(0)).startsWith("In the").endsWith("dock");
        assertThat(net.placeName(1)).isEqualTo("q");
        assertThat(net.initialMarking()).containsExactly(3, 0);
        assertThat(net.consumed().weight(0, 0)).isEqualTo(2);
        assertThat(net.produced().weight(0, 1)).isEqualTo(1);
        assertThat(reading.findings()).extracting(PnmlFinding::code).containsExactly("N-TOOL", "N-GRAPHICS");
        assertThat(reading.findings().get(0).message())
                .isEqualTo("1 parts of the tool other (toolspecific) were left out");
    }

    @Test
    void placeAndTransitionMayShareAnId() {
        PnmlReading reading = net("""
            <page id="g"><place id="x"><initialMarking><text>1</text></initialMarking></place><place id="y"/>
            <transition id="x"/>
            <arc id="a" source="x" target="y"/></page>
            """);

        PetriNet net = reading.net().orElseThrow();
        assertThat(net.produced().weight(0, 1)).isEqualTo(1);
        assertThat(net.consumed().size()).isZero();
    }

    @Test
    void readsTheKindsOfArcsThatToolsWrite() {
        PnmlReading reading = net("""
            <place id="p"/><transition id="t"/>
            <arc id="a" source="p" target="t"><type value="inhibitor"/><inscription><text>4</text></inscription></arc>
            <arc id="b" source="p" target="t"><arctype><text>reset</text></arctype></arc>
            <arc id="c" source="p" target="t"><type value="test"/></arc>
            """);

        PetriNet net = reading.net().orElseThrow();
        assertThat(net.inhibitors().weight(0, 0)).isEqualTo(4);
        assertThat(net.resets().weight(0, 0)).isEqualTo(1);
        assertThat(net.consumed().weight(0, 0)).isEqualTo(1);
        assertThat(net.produced().weight(0, 0)).isEqualTo(1);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        <place id="p"><initialMarking><text>-3</text></initialMarking></place> | E-NUMBER | place p | -3 is not between 0 and 2147483647
        <place id="p"><initialMarking><text>3000000000</text></initialMarking></place> | E-NUMBER | place p | 3000000000 is not between 0 and 2147483647
        <place id="p"><initialMarking><text>99999999999999999999999</text></initialMarking></place> | E-NUMBER | place p | 99999999999999999999999 is not between 0 and 2147483647
        <place id="p"><initialMarking><text>two</text></initialMarking></place> | E-NUMBER | place p | 'two' is no whole number
        <place id="p"/><transition id="t"/><arc id="a" source="p" target="t"><inscription><text>-1</text></inscription></arc> | E-NUMBER | arc a | -1 is not between 1 and 2147483647
        <place id="p"/><transition id="t"/><arc id="a" source="p" target="t"><inscription><text>0</text></inscription></arc> | E-NUMBER | arc a | 0 is not between 1 and 2147483647
        <place id="p"/><arc id="a" source="p" target="u"/> | E-ARC | arc a | there is no node with the id 'u'
        <place id="p"/><place id="q"/><arc id="a" source="p" target="q"/> | E-ARC | arc a | it leads from p to q, not between a place and a transition
        <place id="p"/><transition id="t"/><arc id="a" source="t" target="p"><type value="inhibitor"/></arc> | E-ARC | arc a | inhibitor, reset and read arcs lead from a place to a transition
        <place id="p"/><transition id="t"/><arc id="a" source="p" target="t"><type value="magic"/></arc> | E-ARC | arc a | arcs of the type 'magic' are not read
        <place id="p"/><place id="p"/> | E-ID | place p | there is a place with this id already
        <place/> | E-ID | place | a place has no id
        <referencePlace id="r" ref="s"/><referencePlace id="s" ref="r"/> | E-REFERENCE | reference r | it leads back to itself
        <referencePlace id="r" ref="nowhere"/> | E-REFERENCE | reference r | it leads to no place
        """)
    void saysWhatIsWrongWithItsLineAndElement(String content, String code, String element, String message) {
        PnmlReading reading = net(content);

        assertThat(reading.net()).isEmpty();
        PnmlFinding first = reading.findings().get(0);
        assertThat(first.code()).isEqualTo(code);
        assertThat(first.line()).isEqualTo(4);
        assertThat(first.element()).isEqualTo(element);
        assertThat(first.message()).isEqualTo(message);
    }

    @Test
    void unknownElementsAreNamedAndLeftOut() {
        PnmlReading reading = net("<place id='p'>\n<capacity><text>3</text></capacity></place>");

        assertThat(reading.net()).isPresent();
        assertThat(reading.findings()).hasSize(1);
        assertThat(reading.findings().get(0).line()).isEqualTo(5);
        assertThat(reading.findings().get(0).element()).isEqualTo("place p");
        assertThat(reading.findings().get(0).message()).isEqualTo("the element capacity is not known, and left out");
    }

    @Test
    void otherTypesOfNetsAreNamed() {
        PnmlReading reading = read(HEAD.replace("grammar/ptnet", "grammar/highlevelnet") + "<place id='p'/>" + TAIL);

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings().get(0).code()).isEqualTo("E-TYPE");
        assertThat(reading.findings().get(0).message()).contains("grammar/highlevelnet");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "http://www.pnml.org/version-2009/grammar/ptnet",
                "https://www.pnml.org/version-2009/grammar/pnmlcoremodel",
                "http://www.pnml.org/version-2009/extensions/inhibitorptnet",
                "http://www.pnml.org/version-2009/extensions/resetinhibitorptnet",
                "P/T net"
            })
    void typesOfPlaceTransitionNetsAreRead(String type) {
        assertThat(read(HEAD.replace("http://www.pnml.org/version-2009/grammar/ptnet", type) + "<place id='p'/>" + TAIL)
                        .net())
                .isPresent();
    }

    @Test
    void entitiesAndDocumentTypesAreRefused(@TempDir Path folder) throws IOException {
        Path secret = Files.writeString(folder.resolve("secret"), "1");
        List<String> doctypes = List.of(
                "<!DOCTYPE pnml SYSTEM \"" + secret.toUri() + "\">",
                "<!DOCTYPE pnml [<!ENTITY e SYSTEM \"" + secret.toUri() + "\">]>",
                "<!DOCTYPE pnml [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;\">]>");
        for (String doctype : doctypes) {
            PnmlReading reading = read(HEAD.replace("<pnml ", doctype + "<pnml ")
                    + "<place id='p'><initialMarking><text>&e;</text></initialMarking></place>" + TAIL);

            assertThat(reading.net()).isEmpty();
            assertThat(reading.findings().get(0).code()).isEqualTo("E-DTD");
        }
    }

    @Test
    void undeclaredEntityIsRefused() {
        PnmlReading reading = net("<place id='p'><name><text>&nbsp;</text></name></place>");

        assertThat(reading.net()).isEmpty();
        assertThat(reading.findings().get(0).code()).isIn("E-DTD", "E-XML");
    }

    @Test
    void everyCutOffFileIsRefusedAndNothingBreaks() {
        String text = HEAD + "<page id='g'><place id='p'><name><text>x</text></name></place></page>" + TAIL;
        for (int end = 0; end < text.length() - 1; end++) {
            PnmlReading reading = read(text.substring(0, end));

            assertThat(reading.net()).as("cut off after %d characters", end).isEmpty();
            assertThat(reading.hasErrors()).isTrue();
        }
    }

    @Test
    void deepNestingIsRefused() {
        String deep = "<page id='g'>".repeat(5000) + "</page>".repeat(5000);
        String tools = "<toolspecific tool='x'>".repeat(100_000) + "</toolspecific>".repeat(100_000);

        assertThat(net(deep).findings().get(0).code()).isEqualTo("E-DEPTH");
        assertThat(net(tools).findings().get(0).code()).isEqualTo("E-DEPTH");
    }

    @Test
    void longTextsManyNodesAndLargeFilesAreRefused() {
        PnmlLimits limits = new PnmlLimits(100_000, 10, 10, 10, 100);
        String name = HEAD + "<name><text>" + "x".repeat(200) + "</text></name>" + TAIL;
        StringBuilder places = new StringBuilder(HEAD);
        for (int i = 0; i < 20; i++) {
            places.append("<place id='p").append(i).append("'/>");
        }
        String large = HEAD + " ".repeat(200_000) + TAIL;

        assertThat(first(name, limits)).isEqualTo("a text is longer than 100 characters");
        assertThat(first(places.append(TAIL).toString(), limits)).isEqualTo("the net has more than 10 nodes");
        assertThat(first(large, limits)).isEqualTo("the file is larger than 100000 bytes");
    }

    private static String first(String text, PnmlLimits limits) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        return PnmlReader.read(new ByteArrayInputStream(bytes), limits)
                .findings()
                .get(0)
                .message();
    }

    @Test
    void ofManyFindingsTheFirstAreNamedAndTheRestIsCounted() {
        PnmlReading reading = net("<magic/>".repeat(1000));

        assertThat(reading.findings()).hasSize(21);
        assertThat(reading.findings().get(20).message()).isEqualTo("and 980 more of this kind");
    }

    @Test
    void onlyTheFirstNetIsRead() {
        PnmlReading reading = read(HEAD + "<place id='p'/></net><net id='m' type='x'></net></pnml>");

        assertThat(reading.net().orElseThrow().placeCount()).isEqualTo(1);
        assertThat(reading.findings().get(0).code()).isEqualTo("W-NETS");
    }

    @Test
    void longChainsOfReferencesLeadToTheirNode() {
        StringBuilder text = new StringBuilder("<place id='p'/><transition id='t'/>");
        for (int i = 0; i < 20_000; i++) {
            text.append("<referencePlace id='r" + i + "' ref='" + (i == 19_999 ? "p" : "r" + (i + 1)) + "'/>");
        }
        PnmlReading reading = net(text + "<arc id='a' source='r0' target='t'/>");

        assertThat(reading.findings()).isEmpty();
        assertThat(reading.net().orElseThrow().consumed().weight(0, 0)).isEqualTo(1);
    }

    @Test
    void allReferencesThatLeadIntoARingOrToNothingAreFindings() {
        PnmlReading ring = net("<referencePlace id='a' ref='b'/><referencePlace id='b' ref='c'/>"
                + "<referencePlace id='c' ref='b'/>");
        PnmlReading nothing = net("<referencePlace id='a' ref='b'/><referencePlace id='b' ref='x'/>");

        assertThat(ring.findings()).extracting(PnmlFinding::message).containsOnly("it leads back to itself");
        assertThat(ring.findings())
                .extracting(PnmlFinding::element)
                .containsExactly("reference a", "reference b", "reference c");
        assertThat(nothing.findings())
                .extracting(PnmlFinding::message)
                .containsExactly("it leads to no place", "it leads to no place");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        <place id="p" initialMarking="5"/> | place p | initialMarking
        <transition id="t" priority="2"/> | transition t | priority
        <place id="p"/><transition id="t"/><arc id="a" source="p" target="t" weight="3"/> | arc a | weight
        """)
    void unknownAttributesAreNamedAndLeftOut(String content, String element, String attribute) {
        PnmlReading reading = net(content);

        assertThat(reading.net()).isPresent();
        assertThat(reading.findings())
                .containsExactly(new PnmlFinding(
                        PnmlFinding.Severity.WARNING,
                        "W-ATTRIBUTE",
                        4,
                        element,
                        "the attribute " + attribute + " is not known, and left out"));
    }

    @Test
    void arcWithAnAttributeTypeIsReadOnlyWhereItIsNormal() {
        String nodes = "<place id='p'/><transition id='t'/>";

        PnmlReading inhibitor = net(nodes + "<arc id='a' source='p' target='t' type='inhibitor' weight='3'/>");
        PnmlReading normal = net(nodes + "<arc id='a' source='p' target='t' type='Normal'/>");

        assertThat(inhibitor.net()).isEmpty();
        assertThat(inhibitor.findings())
                .extracting(PnmlFinding::code)
                .containsExactlyInAnyOrder("W-ATTRIBUTE", "E-ARC");
        assertThat(normal.net()).isPresent();
        assertThat(normal.findings()).isEmpty();
    }

    @Test
    void attributesWithAPrefixAndTheNamespacesAreIgnored() {
        PnmlReading reading = net("<place xmlns:x='urn:x' xmlns='http://www.pnml.org/version-2009/grammar/pnml'"
                + " id='p' x:weight='3' xml:lang='en'/>");

        assertThat(reading.net()).isPresent();
        assertThat(reading.findings()).isEmpty();
    }
}
