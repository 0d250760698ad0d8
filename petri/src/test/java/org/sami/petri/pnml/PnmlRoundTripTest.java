package org.sami.petri.pnml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sami.petri.model.ExampleNets;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

class PnmlRoundTripTest {
    @Test
    void netsAreReadAsTheyWereWritten() throws IOException {
        assertIsKept(ExampleNets.kanban(5));
        assertIsKept(ExampleNets.sharedMemory(4));
        assertIsKept(new PetriNetBuilder("").build());
    }

    @Test
    void randomNetsWithStrangeIdsAreReadAsTheyWereWritten() throws IOException {
        String[] ids = {"x", "_place.1", "a b", "<&>\"'", "0", "ä", "_arc.7", "]]>", "😀", "p.q"};
        for (long seed = 0; seed < 300; seed++) {
            Random random = new Random(seed);
            PetriNetBuilder net = new PetriNetBuilder("net " + seed);
            for (String id : ids) {
                net.place(id, random.nextBoolean() ? id : "name of " + id, random.nextInt(3));
                net.transition(id);
            }
            for (int i = random.nextInt(40); i > 0; i--) {
                int t = random.nextInt(ids.length);
                int p = random.nextInt(ids.length);
                switch (random.nextInt(4)) {
                    case 0 -> net.consume(t, p, 1 + random.nextInt(3));
                    case 1 -> net.produce(t, p, 1 + random.nextInt(3));
                    case 2 -> net.inhibit(t, p, 1 + random.nextInt(3));
                    default -> net.reset(t, p);
                }
            }
            assertIsKept(net.build());
        }
    }

    @Test
    void characterThatXmlCannotHoldIsRefused() {
        PetriNetBuilder net = new PetriNetBuilder("n");
        net.place("a\u0000b", 0);
        PetriNet built = net.build();

        assertThatThrownBy(() -> PnmlWriter.write(built, new ByteArrayOutputStream()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("'a?b'");
    }

    private static void assertIsKept(PetriNet net) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        PnmlWriter.write(net, out);

        PnmlReading reading = PnmlReader.read(new ByteArrayInputStream(out.toByteArray()), PnmlLimits.STANDARD);

        assertThat(reading.findings()).as(out.toString(StandardCharsets.UTF_8)).isEmpty();
        assertThat(text(reading.net().orElseThrow())).isEqualTo(text(net));
    }

    private static String text(PetriNet net) {
        StringBuilder text = new StringBuilder(net.name()).append('\n');
        for (int p = 0; p < net.placeCount(); p++) {
            text.append(net.placeId(p)).append('|').append(net.placeName(p)).append('|');
            text.append(net.initial(p)).append('\n');
        }
        for (int t = 0; t < net.transitionCount(); t++) {
            text.append(net.transitionId(t)).append('|').append(net.transitionName(t));
            append(text.append(" -"), net.consumed(), t);
            append(text.append(" +"), net.produced(), t);
            append(text.append(" o"), net.inhibitors(), t);
            append(text.append(" 0"), net.resets(), t);
            text.append('\n');
        }
        return text.toString();
    }

    private static void append(StringBuilder text, ArcTable arcs, int t) {
        for (int arc = arcs.from(t); arc < arcs.to(t); arc++) {
            text.append(' ').append(arcs.node(arc)).append('*').append(arcs.weight(arc));
        }
    }
}
