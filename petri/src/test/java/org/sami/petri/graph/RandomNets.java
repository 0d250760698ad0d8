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

    /** Nets of many places, some with very many tokens, so that a marking takes several words: a few tokens move, and change the many as they go. */
    static PetriNet wide(long seed) {
        Random random = new Random(seed);
        PetriNetBuilder net = new PetriNetBuilder("wide-" + seed);
        int small = 4 + random.nextInt(3);
        int large = 3 + random.nextInt(8);
        for (int p = 0; p < small; p++) {
            net.place("small" + p, random.nextInt(2));
        }
        for (int p = 0; p < large; p++) {
            net.place("large" + p, random.nextInt(1 << random.nextInt(30)));
        }
        for (int t = 3 + random.nextInt(4); t > 0; t--) {
            int transition = net.transition("t" + t);
            net.consume(transition, random.nextInt(small), 1);
            net.produce(transition, random.nextInt(small), 1);
            for (int i = random.nextInt(3); i > 0; i--) {
                net.consume(transition, small + random.nextInt(large), 1 + random.nextInt(1 << random.nextInt(29)));
            }
            if (random.nextInt(3) == 0) {
                net.reset(transition, small + random.nextInt(large));
            }
            if (random.nextInt(3) == 0) {
                net.produce(transition, small + random.nextInt(large), 1 + random.nextInt(1 << random.nextInt(20)));
            }
        }
        return net.build();
    }
}
