package org.sami.petri.symmetry;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.petri.net.ArcTable;
import org.sami.petri.net.PetriNet;

/** Finds the transitions that belong to a permutation of the places of a net. For one thread. */
final class KnownExchange {
    private final PetriNet net;
    private final long[] own;

    KnownExchange(PetriNet net) {
        this.net = net;
        own = sums(IntStream.range(0, net.placeCount()).toArray());
    }

    /** The permutation that takes places there; empty where the net is not the same afterwards. */
    Optional<NetPermutation> of(int[] places) {
        if (IntStream.of(places).distinct().count() != places.length) {
            return Optional.empty();
        }
        Map<Long, Deque<Integer>> free = new HashMap<>();
        for (int t = 0; t < own.length; t++) {
            free.computeIfAbsent(own[t], sum -> new ArrayDeque<>()).add(t);
        }
        long[] moved = sums(places);
        int[] transitions = new int[own.length];
        for (int t = 0; t < own.length; t++) {
            Integer image =
                    Optional.ofNullable(free.get(moved[t])).map(Deque::poll).orElse(null);
            if (image == null) {
                return Optional.empty();
            }
            transitions[t] = image;
        }
        NetPermutation permutation = new NetPermutation(places.clone(), transitions);
        return permutation.keeps(net) ? Optional.of(permutation) : Optional.empty();
    }

    /** A number for each transition that is the same for equal arcs, whatever their order, to places as they are taken to others. */
    private long[] sums(int[] places) {
        long[] sums = new long[net.transitionCount()];
        int kind = 0;
        for (ArcTable arcs : Arrays.asList(net.consumed(), net.produced(), net.inhibitors(), net.resets())) {
            for (int t = 0; t < sums.length; t++) {
                for (int arc = arcs.from(t); arc < arcs.to(t); arc++) {
                    sums[t] += mixed(mixed(4L * places[arcs.node(arc)] + kind) + arcs.weight(arc));
                }
            }
            kind++;
        }
        return sums;
    }

    private static long mixed(long value) {
        long spread = (value ^ (value >>> 31)) * 0x9E3779B97F4A7C15L;
        return (spread ^ (spread >>> 29)) * 0xBF58476D1CE4E5B9L;
    }
}
