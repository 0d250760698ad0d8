package org.sami.spn.planspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.sami.petri.query.LinearComparison;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetNames;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetPlace;
import org.sami.spn.plannet.PlanNetPlace.Role;

/**
 * What the names in a query about a plan mean: {@code visit} all tokens in a place, by its id or its name; {@code visit.robots}, {@code visit.generic},
 * {@code visit.tasks} those of a kind, {@code visit.nobody} visits by nobody, {@code visit.robot-1} or {@code visit.T1} those of one robot or task; transitions by id or
 * name, in any of their cases; {@code duplicated} a marking in which one robot or task stands in several places. Immutable.
 */
public final class PlanNetNames implements NetNames {
    private static final String GENERIC = "generic";

    private final PlanNet net;
    private final Plan plan;

    public PlanNetNames(PlanNet net) {
        this.net = net;
        plan = net.request().project().plan(net.request().plan()).orElseThrow();
    }

    @Override
    public Optional<List<Integer>> places(String name) {
        Optional<String> whole = placeId(name);
        if (whole.isPresent()) {
            return Optional.of(tokens(whole.get(), token -> true));
        }
        for (int dot = name.lastIndexOf('.'); dot > 0; dot = name.lastIndexOf('.', dot - 1)) {
            Optional<String> place = placeId(name.substring(0, dot));
            if (place.isPresent()) {
                return part(place.get(), name.substring(dot + 1));
            }
        }
        return Optional.empty();
    }

    private Optional<List<Integer>> part(String place, String of) {
        List<String> robots = net.request().robots();
        return switch (of) {
            case "robots" -> Optional.of(tokens(place, net::isRobot));
            case GENERIC -> Optional.of(tokens(place, GENERIC::equals));
            case "tasks" -> Optional.of(tokens(place, token -> token.startsWith("#")));
            case "nobody" -> Optional.of(netPlaces(place, Role.NOBODY, token -> true));
            default -> {
                if (!net.hasNames() && robots.contains(of)) {
                    yield Optional.empty(); // robots have no names here
                }
                boolean isKnown = robots.contains(of)
                        || plan.tasks().stream().map(TaskSpec::name).anyMatch(of::equals)
                        || !tokens(place, ("#" + of)::equals).isEmpty();
                yield isKnown
                        ? Optional.of(tokens(place, token -> token.equals(of) || token.equals("#" + of)))
                        : Optional.empty();
            }
        };
    }

    private Optional<String> placeId(String name) {
        return plan.place(name)
                .or(() -> plan.places().stream()
                        .filter(place -> place.name().equals(name))
                        .findFirst())
                .map(Place::id);
    }

    private List<Integer> tokens(String place, Predicate<String> which) {
        return netPlaces(place, Role.TOKEN, which);
    }

    private List<Integer> netPlaces(String place, Role role, Predicate<String> token) {
        return IntStream.range(0, net.net().placeCount())
                .filter(i -> {
                    PlanNetPlace is = net.place(i);
                    return is.role() == role && is.planPlace().equals(place) && token.test(is.token());
                })
                .boxed()
                .toList();
    }

    @Override
    public Optional<List<Integer>> transitions(String name) {
        return plan.transition(name)
                .or(() -> plan.transitions().stream()
                        .filter(transition -> transition.name().equals(name))
                        .findFirst())
                .map(transition -> IntStream.range(0, net.net().transitionCount())
                        .filter(i -> net.firing(i).transition().equals(transition.id()))
                        .boxed()
                        .toList());
    }

    /** The mission is over. */
    @Override
    public Optional<MarkingCondition> end() {
        int running = net.net().place("running").orElseThrow();
        return Optional.of(new LinearComparison(
                List.of(new LinearComparison.Term(running, 1)), LinearComparison.Relation.EQUAL, 0));
    }

    /** One robot or task stands in several places, or twice in one; there is no such word where robots have no names. */
    @Override
    public Optional<MarkingCondition> duplicated() {
        if (!net.hasNames()) {
            return Optional.empty();
        }
        Map<String, List<LinearComparison.Term>> ofToken = new TreeMap<>();
        for (int i = 0; i < net.net().placeCount(); i++) {
            PlanNetPlace place = net.place(i);
            if (place.role() == Role.TOKEN && !place.token().equals(GENERIC)) {
                ofToken.computeIfAbsent(place.token(), token -> new ArrayList<>())
                        .add(new LinearComparison.Term(i, 1));
            }
        }
        return Optional.of(new MarkingCondition.Any(ofToken.values().stream()
                .<MarkingCondition>map(places -> new LinearComparison(places, LinearComparison.Relation.AT_LEAST, 2))
                .toList()));
    }
}
