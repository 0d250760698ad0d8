package org.sami.petri.coverability;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.petri.net.PetriNet;

/** The tree of Karp and Miller as they wrote it, without pruning; its largest labels are the minimal coverability set. Shares no code with what it checks. */
final class PlainKarpMiller {
    private static final int ANY = 1_000_000_000;

    private final PetriNet net;
    private final int mostNodes;
    private final Set<List<Integer>> labels = new HashSet<>();
    private int nodes;

    private PlainKarpMiller(PetriNet net, int mostNodes) {
        this.net = net;
        this.mostNodes = mostNodes;
    }

    /** The set, with {@link Omega#OMEGA} for any number; empty where the tree has too many nodes. */
    static Optional<Set<List<Integer>>> set(PetriNet net, int mostNodes) {
        PlainKarpMiller tree = new PlainKarpMiller(net, mostNodes);
        List<Integer> root = new ArrayList<>();
        for (int place = 0; place < net.placeCount(); place++) {
            root.add(net.initial(place));
        }
        List<List<Integer>> path = new ArrayList<>();
        return tree.grow(root, path) ? Optional.of(tree.largest()) : Optional.empty();
    }

    private boolean grow(List<Integer> label, List<List<Integer>> path) {
        if (++nodes > mostNodes || path.size() > 2_000) {
            return false;
        }
        labels.add(label);
        if (path.contains(label)) {
            return true;
        }
        path.add(label);
        for (int transition = 0; transition < net.transitionCount(); transition++) {
            List<Integer> next = next(label, transition);
            if (next != null) {
                boolean again = true;
                while (again) {
                    again = false;
                    for (List<Integer> above : path) {
                        if (atMost(above, next) && !above.equals(next)) {
                            for (int place = 0; place < next.size(); place++) {
                                if (above.get(place) < next.get(place) && next.get(place) != ANY) {
                                    next.set(place, ANY);
                                    again = true;
                                }
                            }
                        }
                    }
                }
                if (!grow(next, path)) {
                    return false;
                }
            }
        }
        path.remove(path.size() - 1);
        return true;
    }

    private List<Integer> next(List<Integer> label, int transition) {
        List<Integer> next = new ArrayList<>();
        for (int place = 0; place < label.size(); place++) {
            int needed = net.consumed().weight(transition, place);
            if (label.get(place) < needed) {
                return null;
            }
            boolean any = label.get(place) == ANY;
            next.add(any ? ANY : label.get(place) - needed + net.produced().weight(transition, place));
        }
        return next;
    }

    private Set<List<Integer>> largest() {
        Set<List<Integer>> largest = new HashSet<>();
        for (List<Integer> label : labels) {
            if (labels.stream().noneMatch(other -> !other.equals(label) && atMost(label, other))) {
                largest.add(label.stream()
                        .map(tokens -> tokens == ANY ? Omega.OMEGA : tokens)
                        .toList());
            }
        }
        return largest;
    }

    private static boolean atMost(List<Integer> small, List<Integer> large) {
        for (int place = 0; place < small.size(); place++) {
            if (small.get(place) > large.get(place)) {
                return false;
            }
        }
        return true;
    }
}
