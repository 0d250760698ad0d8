package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sami.petri.graph.FiringSequence;
import org.sami.petri.net.FiringRule;
import org.sami.petri.net.PetriNet;

/**
 * A plan with its team as a place/transition net (thesis 4.1): a place of the net for each token that can stand in a place of the plan, a transition for each case
 * of a firing. What the engine can reach the net can reach, as far as {@link #abstractions} says nothing else: input events may come or not, and name any of
 * those whom they may name. Nobody connects, is dropped or aborts the mission. Immutable.
 *
 * <p>Source: thesis, section 4.1; the rules of docs/semantics.md.
 */
public final class PlanNet {
    /** The token of robots that are counted. */
    public static final String ROBOTS = PlanToken.ROBOTS.label();

    private final PlanNetRequest request;
    private final PetriNet net;
    private final List<PlanNetPlace> places;
    private final List<PlanNetFiring> firings;
    private final List<Abstraction> abstractions;
    private final int beyond;
    private final Map<String, Integer> open;
    private final Optional<CountedParts> counted;
    private final Optional<BitSet> sure;

    PlanNet(
            PlanNetRequest request,
            PetriNet net,
            List<PlanNetPlace> places,
            List<PlanNetFiring> firings,
            List<Abstraction> abstractions,
            int beyond,
            Map<String, Integer> open,
            Optional<CountedParts> counted,
            Optional<BitSet> sure) {
        this.request = request;
        this.net = net;
        this.places = List.copyOf(places);
        this.firings = List.copyOf(firings);
        this.abstractions = List.copyOf(abstractions);
        this.beyond = beyond;
        this.open = Map.copyOf(open);
        this.counted = counted;
        this.sure = sure.map(all -> (BitSet) all.clone());
    }

    /**
     * The net of a plan.
     *
     * @throws PlanNetTooLargeException if it would have more transitions than asked for
     * @throws IllegalArgumentException if there is no such plan, or it has no start place
     */
    public static PlanNet of(PlanNetRequest request) throws PlanNetTooLargeException {
        return new PlanTranslation(request, RobotView.NAMED).translate().orElseThrow();
    }

    /**
     * The net of a plan in which robots are counted and not named: far smaller with many robots, and with the same graph up to an exchange of robots.
     *
     * @return empty where there are fewer than two robots, several copies of one can be in one place, or copies can be in many sets of places
     * @throws PlanNetTooLargeException if it would have more transitions than asked for
     * @throws IllegalArgumentException if there is no such plan, or it has no start place
     */
    public static Optional<PlanNet> counted(PlanNetRequest request) throws PlanNetTooLargeException {
        PlanTranslation translation = new PlanTranslation(request, RobotView.COUNTED);
        return request.robots().size() < 2 || translation.losesCount() ? Optional.empty() : translation.translate();
    }

    /**
     * A net of a plan that follows only whether any robots are in a place: with all robots as small as with one. It does more than the net that names them. Each marking of
     * that net has its image here, and so has each firing; {@link #sure} are those that it can do from each marking with the same image.
     *
     * @return empty where there are fewer than two robots, or several copies of one cannot be in one place
     * @throws PlanNetTooLargeException if it would have more transitions than asked for
     * @throws IllegalArgumentException if there is no such plan, or it has no start place
     */
    public static Optional<PlanNet> present(PlanNetRequest request) throws PlanNetTooLargeException {
        PlanTranslation translation = new PlanTranslation(request, RobotView.PRESENT);
        return request.robots().size() < 2 || !translation.losesCount() ? Optional.empty() : translation.translate();
    }

    /**
     * The net of a plan in which sub-missions are followed, with robots that have names, where that is asked for and can be; else robots are counted where that can be; with several robots else one that follows whether any are in a place; else one that names them.
     *
     * @throws PlanNetTooLargeException if it would have more transitions than asked for
     * @throws IllegalArgumentException if there is no such plan, or it has no start place
     */
    public static PlanNet smallest(PlanNetRequest request) throws PlanNetTooLargeException {
        Optional<PlanNet> following = following(request);
        if (following.isPresent()) {
            return following.get();
        }
        Optional<PlanNet> counted = counted(request);
        return counted.isPresent() ? counted.get() : presentOrNamed(request);
    }

    /** With robots that have names, and with its sub-missions, as far as that is not too large. */
    private static Optional<PlanNet> following(PlanNetRequest request) {
        if (request.depth() == 0) {
            return Optional.empty();
        }
        try {
            return Optional.of(of(request)).filter(PlanNet::followsSubMissions);
        } catch (PlanNetTooLargeException tooLarge) {
            return Optional.empty();
        }
    }

    private static PlanNet presentOrNamed(PlanNetRequest request) throws PlanNetTooLargeException {
        try {
            Optional<PlanNet> present = present(request);
            return present.isPresent() ? present.get() : of(request);
        } catch (PlanNetTooLargeException tooLarge) {
            return of(request);
        }
    }

    /** Whether it follows only whether any robots are in a place: then it does more than the net that names them. */
    public boolean isPresent() {
        return sure.isPresent();
    }

    /** The transitions that the net with names can do from each marking that is meant, with the same effect: all of them but where {@link #isPresent}. */
    public BitSet sure() {
        BitSet all = new BitSet();
        all.set(0, net.transitionCount());
        return sure.map(some -> (BitSet) some.clone()).orElse(all);
    }

    /** The places that say only whether there are robots; empty but where {@link #isPresent}. */
    public BitSet presence() {
        BitSet found = new BitSet();
        for (int i = 0; i < places.size() && isPresent(); i++) {
            found.set(i, isRobot(places.get(i).token()));
        }
        return found;
    }

    /** Whether each robot has places of its own. */
    public boolean hasNames() {
        return !isCounted() && !isPresent();
    }

    /** Whether robots are counted and not named. */
    public boolean isCounted() {
        return counted.isPresent();
    }

    /** Whether the token that a place of the net stands for is a robot, or stands for robots. */
    public boolean isRobot(String token) {
        return !hasNames() ? token.equals(ROBOTS) : request.robots().contains(token);
    }

    /** The net with its initial marking. */
    public PetriNet net() {
        return net;
    }

    /** Ways to exchange two robots, or two tasks that are made, next to each other: for each the place that each place is exchanged for. */
    public List<int[]> exchanges() {
        return new TokenExchanges(places).of(hasNames() ? request.robots() : List.of(), request.madeTasks());
    }

    /** The places of generic tokens and of visits by nobody, which alone can gather without bound. */
    public BitSet uncounted() {
        BitSet found = new BitSet();
        for (int i = 0; i < places.size(); i++) {
            PlanNetPlace place = places.get(i);
            found.set(
                    i,
                    place.role() == PlanNetPlace.Role.NOBODY
                            || place.role() == PlanNetPlace.Role.CHILD_NOBODY
                            || place.token().equals(PlanToken.GENERIC.label()));
        }
        return found;
    }

    /** What was translated. */
    public PlanNetRequest request() {
        return request;
    }

    /** Where the net is not exactly what the engine does; empty where it is. */
    public List<Abstraction> abstractions() {
        return abstractions;
    }

    /** Whether it follows only a part of what the plan can do: then nothing that it never does is proved for the plan. */
    public boolean isPartial() {
        return abstractions.stream().anyMatch(a -> a.kind() == Abstraction.Kind.PARTIAL);
    }

    /** What a place of the net stands for. */
    public PlanNetPlace place(int netPlace) {
        return places.get(netPlace);
    }

    /** What a transition of the net stands for. */
    public PlanNetFiring firing(int netTransition) {
        return firings.get(netTransition);
    }

    /** The place of the net that is marked once there were more tokens at once than it follows: what it says from then on is no proof. */
    public int beyond() {
        return beyond;
    }

    /** Whether it follows sub-missions. */
    public boolean followsSubMissions() {
        return !open.isEmpty();
    }

    /** The places of the net that are marked while the sub-mission of a place that is followed is left open all the same. */
    public Collection<Integer> open() {
        return open.values();
    }

    /**
     * Whether the net does not know what a sub-mission does, as it is left open or not followed at all.
     *
     * @param place the path to its place, as {@code swap} or {@code swap/go}
     */
    public boolean isOpen(int[] netMarking, String place) {
        Integer at = open.get(place);
        int slash = place.lastIndexOf('/');
        return at == null || netMarking[at] > 0 || (slash >= 0 && isOpen(netMarking, place.substring(0, slash)));
    }

    /**
     * What a marking of the net says of the tokens of a sub-mission that is followed, by the paths of its places.
     *
     * @param path to its places, as {@code swap/}
     */
    public SortedMap<String, SortedMap<String, Integer>> inside(int[] netMarking, String path) {
        SortedMap<String, SortedMap<String, Integer>> inside = new TreeMap<>();
        for (int i = 0; i < netMarking.length; i++) {
            PlanNetPlace is = places.get(i);
            boolean isOfIt = is.role() == PlanNetPlace.Role.CHILD_TOKEN
                    && is.planPlace().startsWith(path)
                    && is.planPlace().length() > path.length()
                    && is.planPlace().indexOf('/', path.length()) < 0;
            if (netMarking[i] > 0 && isOfIt) {
                inside.computeIfAbsent(is.planPlace(), p -> new TreeMap<>()).put(is.token(), netMarking[i]);
            }
        }
        return inside;
    }

    /** A run of the net as firings of the plan, with the markings before and after each; robots have names, whether the net counts them or not. */
    public PlanRun run(FiringSequence run) {
        return counted.isPresent() ? new NamedRobots(this, counted.get()).run(run) : named(run);
    }

    private PlanRun named(FiringSequence run) {
        int[] at = net.initialMarking();
        List<PlanMarking> markings = new ArrayList<>(List.of(marking(at)));
        for (int transition : run.transitions()) {
            at = FiringRule.fire(net, transition, at);
            markings.add(marking(at));
        }
        return new PlanRun(run.transitions().stream().map(firings::get).toList(), markings);
    }

    /** A marking of the net in the words of the plan. */
    public PlanMarking marking(int[] netMarking) {
        SortedMap<String, SortedMap<String, Integer>> tokens = new TreeMap<>();
        Set<String> nobody = new TreeSet<>();
        for (int i = 0; i < places.size(); i++) {
            PlanNetPlace place = places.get(i);
            if (netMarking[i] > 0 && place.role() == PlanNetPlace.Role.TOKEN) {
                tokens.computeIfAbsent(place.planPlace(), p -> new TreeMap<>()).put(place.token(), netMarking[i]);
            } else if (netMarking[i] > 0 && place.role() == PlanNetPlace.Role.NOBODY) {
                nobody.add(place.planPlace());
            }
        }
        return new PlanMarking(tokens, nobody, netMarking[0] > 0);
    }

    /** The places of the net that hold the tokens of a plan's place. */
    public List<Integer> placesOf(String planPlace) {
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < places.size(); i++) {
            if (places.get(i).role() == PlanNetPlace.Role.TOKEN
                    && places.get(i).planPlace().equals(planPlace)) {
                found.add(i);
            }
        }
        return found;
    }
}
