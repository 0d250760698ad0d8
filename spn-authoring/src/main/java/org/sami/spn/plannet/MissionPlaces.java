package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.function.Predicate;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;

/** The places of the net for one mission, and what each stands for. For one thread. */
final class MissionPlaces {
    private final PetriNetBuilder net;
    private final List<PlanNetPlace> all = new ArrayList<>();
    private final Map<String, Map<PlanToken, Integer>> tokens = new LinkedHashMap<>();
    private final Map<String, Integer> nobody = new HashMap<>();
    private final Map<String, Map<String, Counter>> counters = new HashMap<>();
    private final Map<PlanToken, Integer> unmade = new HashMap<>();
    private final Map<String, Integer> occasions = new HashMap<>();
    private final Map<Integer, Integer> initial = new HashMap<>();
    private final int running;

    /** A place that counts some tokens of a plan's place. */
    record Counter(int place, Predicate<PlanToken> counts) {}

    /** @param robots how many robots there are */
    MissionPlaces(PetriNetBuilder net, Plan plan, List<PlanToken> team, PossibleTokens possible, int robots) {
        this.net = net;
        running = add("running", "the mission runs", 1, PlanNetPlace.Role.CONTROL, "", "");
        for (Place place : plan.places()) {
            Map<PlanToken, Integer> here = new LinkedHashMap<>();
            for (PlanToken token : team) {
                if (possible.comes(place.id(), token)) {
                    boolean atStart = place.start() && !token.isMade();
                    here.put(
                            token,
                            add(
                                    place.id() + "." + token.label(),
                                    title(place) + ": " + token.label(),
                                    !atStart ? 0 : token.equals(PlanToken.ROBOTS) ? robots : 1,
                                    PlanNetPlace.Role.TOKEN,
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
                                PlanNetPlace.Role.NOBODY,
                                place.id(),
                                ""));
            }
        }
        for (PlanToken token : team) {
            if (token.isMade()) {
                unmade.put(
                        token,
                        add(
                                "unmade." + token.label(),
                                token.label() + " is not made yet",
                                1,
                                PlanNetPlace.Role.CONTROL,
                                "",
                                token.label()));
            }
        }
    }

    private static String title(Place place) {
        return place.name().isBlank() ? place.id() : place.name();
    }

    private int add(
            String id, String title, int tokensAtFirst, PlanNetPlace.Role role, String planPlace, String token) {
        String free = id;
        for (int i = 2; net.hasPlace(free); i++) {
            free = id + "~" + i;
        }
        all.add(new PlanNetPlace(role, planPlace, token));
        int number = net.place(free, title, tokensAtFirst);
        initial.put(number, tokensAtFirst);
        return number;
    }

    /** A control place; a second one with an id gets another. */
    int control(String id, String title, int initial) {
        return add(id, title, initial, PlanNetPlace.Role.CONTROL, "", "");
    }

    /** What places stand for, by their numbers. */
    List<PlanNetPlace> all() {
        return all;
    }

    int running() {
        return running;
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

    private int initialIn(String place, PlanToken token) {
        return initial.getOrDefault(in(place).get(token), 0);
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
