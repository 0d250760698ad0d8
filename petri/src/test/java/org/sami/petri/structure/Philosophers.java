package org.sami.petri.structure;

import java.util.List;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Dining philosophers who take first one fork and then the other: all stop where each has one. */
final class Philosophers {
    private Philosophers() {}

    static PetriNet net(int count) {
        PetriNetBuilder net = new PetriNetBuilder("philosophers");
        for (int i = 0; i < count; i++) {
            net.place("think" + i, 1);
            net.place("one" + i, 0);
            net.place("eat" + i, 0);
            net.place("fork" + i, 1);
        }
        for (int i = 0; i < count; i++) {
            String right = "fork" + (i + 1) % count;
            net.move("first" + i, List.of("think" + i, "fork" + i), List.of("one" + i));
            net.move("second" + i, List.of("one" + i, right), List.of("eat" + i));
            net.move("done" + i, List.of("eat" + i), List.of("think" + i, "fork" + i, right));
        }
        return net.build();
    }
}
