package org.sami.petri.symmetry;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;

/** Random nets whose parts are alike, or nearly: the same seed gives the same net. */
public final class CopiedNets {
    private static final int COPIES = 3;

    private CopiedNets() {}

    /** Three copies of a small random component around random shared places. */
    public static PetriNet net(long seed) {
        return copies(seed, false);
    }

    /** The same, where the last copy may have a token, an inhibitor arc or a reset arc more, or a transition that consumes another number. */
    public static PetriNet nearly(long seed) {
        return copies(seed, true);
    }

    private static PetriNet copies(long seed, boolean mayDiffer) {
        Random random = new Random(seed);
        PetriNetBuilder net = new PetriNetBuilder("copies-" + seed);
        int shared = 1 + random.nextInt(2);
        int own = 2 + random.nextInt(2);
        int transitions = 2 + random.nextInt(3);
        for (int p = 0; p < shared; p++) {
            net.place("shared" + p, random.nextInt(3));
        }
        int[] initial = random.ints(own, 0, 2).toArray();
        long parts = random.nextLong();
        for (int copy = 0; copy < COPIES; copy++) {
            Random same = new Random(parts);
            int difference = mayDiffer && copy == COPIES - 1 ? (int) (seed % 5) : 0;
            int[] places = new int[shared + own];
            for (int p = 0; p < places.length; p++) {
                int more = difference == 1 && p == shared ? 1 : 0;
                places[p] = p < shared ? p : net.place("own" + copy + "." + p, initial[p - shared] + more);
            }
            for (int t = 0; t < transitions; t++) {
                int transition = net.transition("t" + copy + "." + t);
                net.consume(transition, places[same.nextInt(places.length)], difference == 2 && t == 0 ? 2 : 1);
                if (same.nextInt(3) > 0) {
                    net.produce(transition, places[same.nextInt(places.length)], 1);
                }
                if (same.nextInt(4) == 0) {
                    net.inhibit(transition, places[same.nextInt(places.length)], 1 + same.nextInt(2));
                }
                if (same.nextInt(6) == 0) {
                    net.reset(transition, places[same.nextInt(places.length)]);
                }
                if (difference == 3 && t == 0) {
                    net.inhibit(transition, places[shared], 1);
                }
                if (difference == 4 && t == 0) {
                    net.reset(transition, places[shared]);
                }
            }
        }
        return net.build();
    }

    /** Small random parts in a ring, each of which changes something in the next one: they can be turned, and not exchanged. */
    static PetriNet ring(long seed) {
        Random random = new Random(seed);
        PetriNetBuilder net = new PetriNetBuilder("ring-" + seed);
        int parts = 3 + random.nextInt(2);
        int[] initial = random.ints(3, 0, 2).toArray();
        for (int p = 0; p < 3 * parts; p++) {
            net.place("p" + p, initial[p % 3]);
        }
        int transitions = 1 + random.nextInt(3);
        long alike = random.nextLong();
        for (int part = 0; part < parts; part++) {
            Random same = new Random(alike);
            for (int t = 0; t < transitions; t++) {
                int transition = net.transition("t" + part + "." + t);
                net.consume(transition, (3 * part + same.nextInt(3)) % (3 * parts), 1);
                if (same.nextInt(3) == 0) {
                    net.consume(transition, (3 * part + same.nextInt(6)) % (3 * parts), 1);
                }
                net.produce(transition, (3 * part + same.nextInt(6)) % (3 * parts), 1);
            }
        }
        return net.build();
    }

    /** The exchanges of each two copies: of all their places, where the net may be another one afterwards. */
    static List<int[]> exchanges(PetriNet net) {
        int own = (int) IntStream.range(0, net.placeCount())
                .filter(place -> net.placeId(place).startsWith("own0."))
                .count();
        int shared = net.placeCount() - COPIES * own;
        List<int[]> images = new ArrayList<>();
        for (int first = 0; first < COPIES; first++) {
            for (int second = first + 1; second < COPIES; second++) {
                int[] image = IntStream.range(0, net.placeCount()).toArray();
                for (int p = 0; p < own; p++) {
                    image[shared + first * own + p] = shared + second * own + p;
                    image[shared + second * own + p] = shared + first * own + p;
                }
                images.add(image);
            }
        }
        return images;
    }

    /** A graph in which each node has three edges: nodes are places with a token, an edge takes the tokens of its two ends. All nodes look alike from near by. */
    static PetriNet regular(long seed) {
        Random random = new Random(seed);
        int nodes = 8;
        List<List<Integer>> edges = List.of();
        while (edges.isEmpty()) {
            List<Integer> ends = new ArrayList<>();
            IntStream.range(0, nodes).forEach(node -> ends.addAll(Collections.nCopies(3, node)));
            Collections.shuffle(ends, random);
            edges = pairs(ends);
        }
        PetriNetBuilder net = new PetriNetBuilder("regular-" + seed);
        IntStream.range(0, nodes).forEach(node -> net.place("node" + node, 1));
        for (List<Integer> edge : edges) {
            int taken = net.transition("edge" + edge);
            edge.forEach(end -> net.consume(taken, end, 1));
        }
        return net.build();
    }

    /** Each two of a list; empty where two are equal, or two pairs are. */
    private static List<List<Integer>> pairs(List<Integer> ends) {
        List<List<Integer>> pairs = new ArrayList<>();
        for (int i = 0; i < ends.size(); i += 2) {
            int first = Math.min(ends.get(i), ends.get(i + 1));
            List<Integer> pair = List.of(first, ends.get(i) + ends.get(i + 1) - first);
            if (pair.get(0).equals(pair.get(1)) || pairs.contains(pair)) {
                return List.of();
            }
            pairs.add(pair);
        }
        return pairs;
    }
}
