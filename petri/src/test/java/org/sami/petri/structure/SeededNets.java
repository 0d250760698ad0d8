package org.sami.petri.structure;

import java.util.Random;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Small random nets: the same seed gives the same net. */
public final class SeededNets {
    private final Random random;
    private final int mostPlaces;
    private final int mostWeight;
    private boolean inhibitors;
    private boolean resets;

    private SeededNets(long seed, int mostPlaces, int mostWeight) {
        this.random = new Random(seed);
        this.mostPlaces = mostPlaces;
        this.mostWeight = mostWeight;
    }

    /** A net without inhibitor and reset arcs. */
    public static PetriNet plain(long seed, int mostPlaces, int mostWeight) {
        return new SeededNets(seed, mostPlaces, mostWeight).build();
    }

    /** A net in which inhibitor and reset arcs are likely. */
    public static PetriNet withAllArcs(long seed, int mostPlaces, int mostWeight) {
        SeededNets nets = new SeededNets(seed, mostPlaces, mostWeight);
        nets.inhibitors = true;
        nets.resets = true;
        return nets.build();
    }

    /** A net in which reset arcs are likely, without inhibitor arcs. */
    public static PetriNet withResets(long seed, int mostPlaces, int mostWeight) {
        SeededNets nets = new SeededNets(seed, mostPlaces, mostWeight);
        nets.resets = true;
        return nets.build();
    }

    private PetriNet build() {
        PetriNetBuilder net = new PetriNetBuilder("seeded");
        int places = 2 + random.nextInt(mostPlaces - 1);
        for (int place = 0; place < places; place++) {
            net.place("p" + place, random.nextInt(3) == 0 ? 0 : random.nextInt(3));
        }
        int transitions = 1 + random.nextInt(5);
        for (int transition = 0; transition < transitions; transition++) {
            net.transition("t" + transition);
            for (int i = random.nextInt(3) + (random.nextInt(5) == 0 ? 0 : 1); i > 0; i--) {
                net.consume(transition, random.nextInt(places), weight());
            }
            for (int i = random.nextInt(3); i >= 0; i--) {
                net.produce(transition, random.nextInt(places), weight());
            }
            if (inhibitors && random.nextInt(3) == 0) {
                net.inhibit(transition, random.nextInt(places), 1 + random.nextInt(3));
            }
            if (resets && random.nextInt(3) == 0) {
                net.reset(transition, random.nextInt(places));
            }
        }
        return net.build();
    }

    private int weight() {
        return random.nextInt(4) == 0 ? 1 + random.nextInt(mostWeight) : 1;
    }
}
