package org.sami.petri.symmetry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.sami.petri.graph.MarkingSymmetry;
import org.sami.petri.net.PetriNet;

/**
 * Permutations of a net's nodes after which it is the same net with the same initial marking: equal components can be exchanged. Of markings that they turn into one
 * another, one stands for all where the permutations exchange components as wholes; else there may be several, which costs states and no truth. For one thread.
 */
public final class NetSymmetry implements MarkingSymmetry {
    private final List<NetPermutation> generators;
    private final int[] room;
    private final int transitions;
    private final int[] all;

    /** By transition: the generators that move a place that it changes. */
    private final int[][] touchedBy;

    /** By generator: those that move a place that it moves. */
    private final int[][] overlapping;

    private final boolean[] isListed;
    private final int[] open;
    private final boolean[] isOpen;

    /** Those of the generators that change nothing in the marking that is looked at. */
    private final List<NetPermutation> fixing = new ArrayList<>();

    private NetSymmetry(List<NetPermutation> generators, PetriNet net) {
        this.generators = List.copyOf(generators);
        room = new int[net.placeCount()];
        transitions = net.transitionCount();
        isListed = new boolean[transitions];
        open = new int[generators.size()];
        isOpen = new boolean[generators.size()];
        all = IntStream.range(0, generators.size()).toArray();
        overlapping = new int[generators.size()][];
        Arrays.setAll(overlapping, i -> touching(generators.get(i).moved()));
        touchedBy = new int[transitions][];
        Arrays.setAll(touchedBy, t -> touching(places(net, t)));
    }

    /** The generators that move one of some places. */
    private int[] touching(int[] places) {
        return IntStream.range(0, generators.size())
                .filter(i -> IntStream.of(places).anyMatch(generators.get(i)::moves))
                .toArray();
    }

    /** The places in which a transition changes something. */
    private static int[] places(PetriNet net, int transition) {
        return Stream.of(net.consumed(), net.produced(), net.resets())
                .flatMapToInt(arcs -> IntStream.range(arcs.from(transition), arcs.to(transition))
                        .map(arcs::node))
                .distinct()
                .toArray();
    }

    /** Finds permutations. In a net with very many nodes some may be missed; each one that is used was verified arc by arc. */
    public static NetSymmetry of(PetriNet net) {
        return new NetSymmetry(new SymmetrySearch(net, SymmetrySearch.MOST_WORK).find(), net);
    }

    /**
     * The permutations that move places as given, where the net allows them: far quicker than to search for them.
     *
     * @param images for each permutation where it takes each place; those after which it is not the same net are left out
     */
    public static NetSymmetry of(PetriNet net, List<int[]> images) {
        KnownExchange exchange = new KnownExchange(net);
        return new NetSymmetry(
                images.stream().flatMap(image -> exchange.of(image).stream()).toList(), net);
    }

    /** Whether nothing can be exchanged. */
    public boolean isEmpty() {
        return generators.isEmpty();
    }

    /** How many permutations generate all that were found. */
    public int generators() {
        return generators.size();
    }

    /** For each of the permutations that generate all: where it takes a place. */
    public List<Integer> imagesOfPlace(int place) {
        return generators.stream().map(generator -> generator.place(place)).toList();
    }

    /** For each of the permutations that generate all: where it takes a transition. */
    public List<Integer> imagesOfTransition(int transition) {
        return generators.stream()
                .map(generator -> generator.transition(transition))
                .toList();
    }

    @Override
    public void normalize(int[] marking) {
        change(all, marking, generator -> {});
    }

    @Override
    public void normalizeAfter(int transition, int[] marking) {
        change(touchedBy[transition], marking, generator -> {});
    }

    @Override
    public int[] normalizeAndTrace(int[] marking) {
        return trace(all, marking);
    }

    @Override
    public int[] normalizeAfterAndTrace(int transition, int[] marking) {
        return trace(touchedBy[transition], marking);
    }

    private int[] trace(int[] first, int[] marking) {
        int[] before = IntStream.range(0, transitions).toArray();
        change(first, marking, generator -> {
            int[] then = before.clone();
            for (int t = 0; t < transitions; t++) {
                before[t] = then[generator.transition(t)];
            }
        });
        return before;
    }

    /** Applies generators until none makes the marking larger: those that are given first, then those that share places with one that was applied. */
    private void change(int[] first, int[] marking, Consumer<NetPermutation> applied) {
        int waiting = 0;
        for (int i = first.length - 1; i >= 0; i--) {
            open[waiting++] = first[i];
            isOpen[first[i]] = true;
        }
        while (waiting > 0) {
            int next = open[--waiting];
            isOpen[next] = false;
            NetPermutation generator = generators.get(next);
            if (generator.enlarge(marking, room)) {
                applied.accept(generator);
                for (int other : overlapping[next]) {
                    if (!isOpen[other]) {
                        isOpen[other] = true;
                        open[waiting++] = other;
                    }
                }
            }
        }
    }

    @Override
    public int withoutAlike(int[] marking, int[] enabled, int count) {
        fixing.clear();
        for (NetPermutation generator : generators) {
            if (generator.fixes(marking)) {
                fixing.add(generator);
            }
        }
        if (fixing.isEmpty()) {
            return count;
        }
        for (int i = 0; i < count; i++) {
            isListed[enabled[i]] = true;
        }
        int[] listed = Arrays.copyOf(enabled, count);
        int kept = 0;
        for (int transition : listed) {
            if (!hasEarlierOneLikeIt(transition)) {
                enabled[kept++] = transition;
            }
        }
        for (int transition : listed) {
            isListed[transition] = false;
        }
        return kept;
    }

    /** Whether a permutation that changes nothing in the marking takes the transition to one of a lower number, which is in the list too. */
    private boolean hasEarlierOneLikeIt(int transition) {
        for (NetPermutation generator : fixing) {
            int other = generator.transition(transition);
            if (other < transition && isListed[other]) {
                return true;
            }
        }
        return false;
    }

    @Override
    public void spread(BitSet fired, int[] mostTokens) {
        boolean changed = true;
        while (changed) {
            changed = false;
            for (NetPermutation generator : generators) {
                changed |= spread(generator, fired, mostTokens);
            }
        }
    }

    private boolean spread(NetPermutation generator, BitSet fired, int[] mostTokens) {
        boolean isChanged = false;
        for (int place : generator.moved()) {
            int image = generator.place(place);
            if (mostTokens[place] < mostTokens[image]) {
                mostTokens[place] = mostTokens[image];
                isChanged = true;
            }
        }
        for (int t = 0; t < transitions; t++) {
            int image = generator.transition(t);
            if (fired.get(image) && !fired.get(t)) {
                fired.set(t);
                isChanged = true;
            }
        }
        return isChanged;
    }
}
