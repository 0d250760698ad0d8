package org.sami.petri.coverability;

import java.util.List;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Nets with unbounded places. */
final class OpenNets {
    private OpenNets() {}

    /** A producer that never waits, a buffer that never fills, and a consumer. */
    static PetriNet producerAndConsumer() {
        PetriNetBuilder net = new PetriNetBuilder("producer and consumer");
        net.place("idle", 1);
        net.place("made", 0);
        net.place("buffer", 0);
        net.place("waits", 1);
        net.place("got", 0);
        net.move("make", List.of("idle"), List.of("made"));
        net.move("send", List.of("made"), List.of("idle", "buffer"));
        net.move("take", List.of("waits", "buffer"), List.of("got"));
        net.move("use", List.of("got"), List.of("waits"));
        return net.build();
    }

    /** The kanban system of Ciardo and Tilgner with four cells of so many cards, whose finished parts are counted in a place without bound. */
    static PetriNet kanban(int cards) {
        PetriNetBuilder net = new PetriNetBuilder("open kanban");
        for (int cell = 1; cell <= 4; cell++) {
            net.place("work" + cell, 0);
            net.place("back" + cell, 0);
            net.place("card" + cell, cards);
            net.place("out" + cell, 0);
        }
        net.place("finished", 0);
        for (int cell = 1; cell <= 4; cell++) {
            net.move("redo" + cell, List.of("work" + cell), List.of("back" + cell));
            net.move("again" + cell, List.of("back" + cell), List.of("work" + cell));
            net.move("done" + cell, List.of("work" + cell), List.of("out" + cell));
        }
        net.move("in", List.of("card1"), List.of("work1"));
        net.move("divide", List.of("out1", "card2", "card3"), List.of("card1", "work2", "work3"));
        net.move("unite", List.of("out2", "out3", "card4"), List.of("card2", "card3", "work4"));
        net.move("out", List.of("out4"), List.of("card4", "finished"));
        return net.build();
    }
}
