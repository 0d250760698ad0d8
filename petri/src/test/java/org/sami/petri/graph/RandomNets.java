package org.sami.petri.graph;

import java.util.Random;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Small random nets with weights, inhibitor and reset arcs: equal seeds make equal nets. */
final class RandomNets {
    private RandomNets() {}

    static PetriNet net(long seed) {
        Random random = new Random(seed);
        PetriNetBuilder net = new PetriNetBuilder("random-" + seed);
        int places = 1 + random.nextInt(6);
        int transitions = 1 + random.nextInt(7);
        for (int p = 0; p < places; p++) {
            net.place("p" + p, random.nextInt(3) == 0 ? random.nextInt(9) : random.nextInt(3));
        }
        for (int t = 0; t < transitions; t++) {
            net.transition("t" + t);
            for (int i = random.nextInt(4); i > 0; i--) {
                net.consume(t, random.nextInt(places), 1 + random.nextInt(2));
            }
            for (int i = random.nextInt(4); i > 0; i--) {
                net.produce(t, random.nextInt(places), random.nextInt(20) == 0 ? 40 : 1 + random.nextInt(2));
            }
            if (random.nextInt(4) == 0) {
                net.inhibit(t, random.nextInt(places), 1 + random.nextInt(3));
            }
            if (random.nextInt(6) == 0) {
                net.reset(t, random.nextInt(places));
            }
        }
        return net.build();
    }

    /** Nets in which tokens only move or go, with many inhibitor and reset arcs: their transitions seldom compete, so that reductions leave much out. */
    static PetriNet loose(long seed) {
        Random random = new Random(seed);
        PetriNetBuilder net = new PetriNetBuilder("loose-" + seed);
        int places = 3 + random.nextInt(5);
        int transitions = 3 + random.nextInt(4);
        for (int p = 0; p < places; p++) {
            net.place("p" + p, random.nextInt(3));
        }
        for (int t = 0; t < transitions; t++) {
            net.transition("t" + t);
            net.consume(t, random.nextInt(places), 1);
            if (random.nextInt(4) > 0) {
                net.produce(t, random.nextInt(places), 1);
            }
            if (random.nextInt(3) == 0) {
                net.inhibit(t, random.nextInt(places), 1 + random.nextInt(2));
            }
            if (random.nextInt(3) == 0) {
                net.reset(t, random.nextInt(places));
            }
        }
        return net.build();
    }
}
