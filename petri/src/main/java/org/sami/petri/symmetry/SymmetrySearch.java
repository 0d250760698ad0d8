package org.sami.petri.symmetry;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.petri.net.PetriNet;

/**
 * Finds permutations that keep a net: colours its nodes by their neighbourhoods, pairs two places of one colour, and refines until each node has one image (the
 * method of individualization and refinement, without backtracking). For one thread, once.
 */
final class SymmetrySearch {
    /** So many arcs are looked at: about a second. */
    static final long MOST_WORK = 60_000_000;

    private final PetriNet net;
    private final int places;
    private final long mostWork;

    /** For each place another one of those that permutations turn into it; itself at the end. */
    private final int[] orbit;

    private long work;

    /** A search that ends without finding more when it has done so much work. */
    SymmetrySearch(PetriNet net, long mostWork) {
        this.net = net;
        this.mostWork = mostWork;
        places = net.placeCount();
        orbit = new int[places];
        for (int place = 0; place < places; place++) {
            orbit[place] = place;
        }
    }

    List<NetPermutation> find() {
        PairedColours colours = new PairedColours(net, mostWork);
        work = colours.work();
        Map<Integer, Integer> lastOfColour = new HashMap<>();
        List<NetPermutation> found = new ArrayList<>();
        for (int place = 0; place < places && work < mostWork; place++) {
            Integer before = lastOfColour.put(colours.ofNet(place), place);
            if (before != null && root(before) != root(place)) {
                Optional<NetPermutation> permutation = exchange(colours, before, place);
                permutation.ifPresent(found::add);
                permutation.ifPresent(this::join);
            }
        }
        return found;
    }

    private void join(NetPermutation permutation) {
        for (int place : permutation.moved()) {
            orbit[root(place)] = root(permutation.place(place));
        }
    }

    private int root(int place) {
        int at = place;
        while (orbit[at] != at) {
            orbit[at] = orbit[orbit[at]];
            at = orbit[at];
        }
        return at;
    }

    /** A permutation that takes one place to another, at best one that exchanges them. */
    private Optional<NetPermutation> exchange(PairedColours colours, int first, int second) {
        PairedColours both = colours.copy(mostWork - work);
        both.pair(first, second);
        both.pair(second, first);
        Optional<NetPermutation> exchanging = complete(both);
        if (exchanging.isPresent()) {
            return exchanging;
        }
        PairedColours one = colours.copy(mostWork - work);
        one.pair(first, second);
        return complete(one);
    }

    private Optional<NetPermutation> complete(PairedColours colours) {
        int nodes = colours.nodes();
        int[] image = new int[nodes];
        boolean isOpen = true;
        while (isOpen) {
            colours.refine();
            if (colours.isCutOff()) {
                work += colours.work();
                return Optional.empty();
            }
            Map<Integer, List<Integer>> copies = new HashMap<>();
            Map<Integer, Integer> counts = new HashMap<>();
            for (int node = 0; node < nodes; node++) {
                copies.computeIfAbsent(colours.ofCopy(node), colour -> new ArrayList<>())
                        .add(node);
                counts.merge(colours.ofNet(node), 1, Integer::sum);
            }
            isOpen = false;
            for (int node = 0; node < nodes; node++) {
                List<Integer> candidates = copies.getOrDefault(colours.ofNet(node), List.of());
                if (candidates.size() != counts.getOrDefault(colours.ofNet(node), 0)) {
                    work += colours.work();
                    return Optional.empty();
                }
                boolean canStay = colours.ofCopy(node) == colours.ofNet(node);
                image[node] = canStay ? node : candidates.get(0);
                if (candidates.size() > 1 && !canStay) {
                    isOpen = true;
                    colours.pair(node, candidates.get(0));
                    break;
                }
            }
        }
        work += colours.work();
        NetPermutation permutation = permutation(image);
        return permutation.keeps(net) ? Optional.of(permutation) : Optional.empty();
    }

    private NetPermutation permutation(int[] image) {
        int[] ofPlaces = new int[places];
        int[] ofTransitions = new int[net.transitionCount()];
        System.arraycopy(image, 0, ofPlaces, 0, places);
        for (int t = 0; t < ofTransitions.length; t++) {
            ofTransitions[t] = image[places + t] - places;
        }
        return new NetPermutation(ofPlaces, ofTransitions);
    }
}
