package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.function.Predicate;
import java.util.function.ToIntBiFunction;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;

/** The places of the net for one mission, and what each stands for. For one thread. */
final class MissionPlaces {
    private final PetriNetBuilder net;
    private final List<PlanNetPlace> all;
    /** Of a sub-mission: the path to its places; else empty. */
    private final String path;

    private final List<Integer> owned = new ArrayList<>();
    private final Map<String, Map<PlanToken, Integer>> tokens = new LinkedHashMap<>();
    private final Map<String, Integer> nobody = new HashMap<>();
    private final Map<String, Map<String, Counter>> counters = new HashMap<>();
    private final Map<PlanToken, Integer> unmade = new HashMap<>();
    private final Map<String, Integer> occasions = new HashMap<>();
    private final Map<String, Integer> heard = new HashMap<>();
    private final Map<Integer, Integer> initial = new HashMap<>();
    private final int running;

    /** A place that counts some tokens of a plan's place. */
    record Counter(int place, Predicate<PlanToken> counts) {}

    /** @param robots how many robots there are */
    MissionPlaces(PetriNetBuilder net, Plan plan, List<PlanToken> team, PossibleTokens possible, int robots) {
        this(
                net,
                new ArrayList<>(),
                "",
                plan,
                team,
                possible,
                (place, token) -> place.start() && !token.isMade() ? token.equals(PlanToken.ROBOTS) ? robots : 1 : 0,
                true);
    }

    /** The places of a sub-mission, in the same net, with a path in front of their ids. */
    MissionPlaces(
            MissionPlaces parent,
            String path,
            Plan plan,
            List<PlanToken> team,
            PossibleTokens possible,
            ToIntBiFunction<Place, PlanToken> initially,
            boolean runs) {
        this(parent.net, parent.all, path, plan, team, possible, initially, runs);
    }

    private MissionPlaces(
            PetriNetBuilder net,
            List<PlanNetPlace> all,
            String path,
            Plan plan,
            List<PlanToken> team,
            PossibleTokens possible,
            ToIntBiFunction<Place, PlanToken> initially,
            boolean runs) {
        this.net = net;
        this.all = all;
        this.path = path;
        running = control("running", "the mission runs", runs ? 1 : 0);
        for (Place place : plan.places()) {
            Map<PlanToken, Integer> here = new LinkedHashMap<>();
            for (PlanToken token : team) {
                if (possible.comes(place.id(), token)) {
                    here.put(
                            token,
                            add(
                                    place.id() + "." + token.label(),
                                    title(place) + ": " + token.label(),
                                    initially.applyAsInt(place, token),
                                    path.isEmpty() ? PlanNetPlace.Role.TOKEN : PlanNetPlace.Role.CHILD_TOKEN,
                                    place.id(),
                                    token.label()));
                }
            }
            tokens.put(place.id(), here);
            if (possible.isEnteredByNobody(place.id()) && !place.end()) {
                nobody.put(
                        place.id(),
                        add(
                                place.id() + ".nobody",
                                title(place) + ": visits by nobody",
                                0,
                                path.isEmpty() ? PlanNetPlace.Role.NOBODY : PlanNetPlace.Role.CHILD_NOBODY,
                                place.id(),
                                ""));
            }
        }
        team.stream()
                .filter(PlanToken::isMade)
                .forEach(token -> unmade.put(
                        token,
                        add(
                                "unmade." + token.label(),
                                token.label() + " is not made yet",
                                1,
                                PlanNetPlace.Role.CONTROL,
                                "",
                                token.label())));
    }

    private static String title(Place place) {
        return place.name().isBlank() ? place.id() : place.name();
    }

    private int add(
            String id, String title, int tokensAtFirst, PlanNetPlace.Role role, String planPlace, String token) {
        String free = path + id;
        for (int i = 2; net.hasPlace(free); i++) {
            free = path + id + "~" + i;
        }
        all.add(new PlanNetPlace(role, planPlace.isEmpty() ? "" : path + planPlace, token));
        int number = net.place(free, path + title, tokensAtFirst);
        initial.put(number, tokensAtFirst);
        owned.add(number);
        return number;
    }

    /** A control place; a second one with an id gets another. */
    int control(String id, String title, int initial) {
        return add(id, title, initial, PlanNetPlace.Role.CONTROL, "", "");
    }

    /** The place that says that a token came back from a sub-mission. */
    int back(String place, PlanToken token) {
        return add(
                place + ".back." + token.label(),
                place + ": " + token.label() + " came back",
                0,
                PlanNetPlace.Role.CHILD_TOKEN,
                place + "/",
                token.label());
    }

    /** The place that counts the unused returns of a shared sub-mission that bring no robot. */
    int returnsOfNobody(String place) {
        return add(
                place + ".returns",
                place + ": unused returns without a robot",
                0,
                PlanNetPlace.Role.CHILD_NOBODY,
                place + "/",
                "");
    }

    /** The places of the net that this mission has, besides those of its sub-missions. */
    List<Integer> owned() {
        return owned;
    }

    /** What places stand for, by their numbers. */
    List<PlanNetPlace> all() {
        return all;
    }

    int running() {
        return running;
    }

    /** Whether the mission runs at first: a sub-mission that is started later does not. */
    boolean runsAtFirst() {
        return initial.getOrDefault(running, 0) > 0;
    }

    /** The place of a token in a plan's place; empty where it never comes there. */
    OptionalInt of(String place, PlanToken token) {
        Integer found = tokens.getOrDefault(place, Map.of()).get(token);
        return found == null ? OptionalInt.empty() : OptionalInt.of(found);
    }

    /** The places of all tokens that can stand in a plan's place. */
    Map<PlanToken, Integer> in(String place) {
        return tokens.getOrDefault(place, Map.of());
    }

    /** The places of the net that speak of tokens in a plan's place. */
    List<Integer> allIn(String place) {
        List<Integer> found = new ArrayList<>(in(place).values());
        counters.getOrDefault(place, Map.of()).values().forEach(counter -> found.add(counter.place()));
        return found;
    }

    OptionalInt nobody(String place) {
        Integer found = nobody.get(place);
        return found == null ? OptionalInt.empty() : OptionalInt.of(found);
    }

    int unmade(PlanToken token) {
        return Objects.requireNonNull(unmade.get(token), token.name());
    }

    /** The mark that a transition is to be looked at once; empty where it needs none. */
    OptionalInt occasion(String transition) {
        Integer found = occasions.get(transition);
        return found == null ? OptionalInt.empty() : OptionalInt.of(found);
    }

    /** Notes what entering a plan's place, or leaving it, is an occasion for. */
    void occasions(Plan plan, String place, boolean isEntered, CaseArcs arcs) {
        plan.inEdges().stream()
                .filter(edge -> edge.place().equals(place))
                .map(InEdge::transition)
                .distinct()
                .forEach(t -> {
                    occasion(t).ifPresent(arcs::set);
                    if (isEntered && heard.containsKey(t)) {
                        arcs.set(Objects.requireNonNull(heard.get(t), t));
                    }
                });
    }

    /** The mark that an event may have come to a transition and waits; empty where it needs none. */
    OptionalInt heard(String transition) {
        Integer found = heard.get(transition);
        return found == null ? OptionalInt.empty() : OptionalInt.of(found);
    }

    void addHeard(String transition, boolean atStart) {
        heard.put(transition, control("heard." + transition, "an event may wait for " + transition, atStart ? 1 : 0));
    }

    void addOccasion(String transition, boolean atStart) {
        occasions.put(
                transition,
                control("look." + transition, "there is occasion to look at " + transition, atStart ? 1 : 0));
    }

    /** The place that counts the tokens of a group in a plan's place; made at the first use, with those that stand there at first. */
    int counter(String place, String group, Predicate<PlanToken> counts) {
        Map<String, Counter> here = counters.computeIfAbsent(place, p -> new LinkedHashMap<>());
        Counter known = here.get(group);
        if (known == null) {
            List<PlanToken> counted = in(place).keySet().stream().filter(counts).toList();
            int tokensAtFirst =
                    counted.stream().mapToInt(token -> initialIn(place, token)).sum();
            int number = add(
                    place + "." + group + ".count",
                    place + ": number of " + group,
                    tokensAtFirst,
                    PlanNetPlace.Role.COUNT,
                    place,
                    "");
            known = new Counter(number, counts);
            here.put(group, known);
        }
        return known.place();
    }

    /** How many of a token stand in a plan's place at first. */
    int initialIn(String place, PlanToken token) {
        Integer at = in(place).get(token);
        return at == null ? 0 : initial.getOrDefault(at, 0);
    }

    /** Whether tokens stand in a plan's place at first. */
    boolean startsWith(String place) {
        return in(place).values().stream().anyMatch(at -> initial.getOrDefault(at, 0) > 0);
    }

    /** The counters of a plan's place that count a token. */
    List<Integer> counting(String place, PlanToken token) {
        return counters.getOrDefault(place, Map.of()).values().stream()
                .filter(counter -> counter.counts().test(token))
                .map(Counter::place)
                .toList();
    }

    /** Whether a token is a generic one, a robot or a task. */
    static Predicate<PlanToken> ofType(TokenType type) {
        return token -> token.type() == type;
    }
}
