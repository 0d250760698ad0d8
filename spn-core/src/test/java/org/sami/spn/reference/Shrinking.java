package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;

/** Makes a scenario smaller as long as it still shows what it shows, greedily, one piece at a time. */
final class Shrinking {
    private final Predicate<Scenario> shows;
    private int triesLeft = 4000;

    Shrinking(Predicate<Scenario> shows) {
        this.shows = shows;
    }

    Scenario shrink(Scenario scenario) {
        Scenario smallest = scenario;
        while (true) {
            Scenario smaller = shrinkPlans(shrinkInputs(smallest));
            if (smaller.equals(smallest) || triesLeft <= 0) {
                return smaller;
            }
            smallest = smaller;
        }
    }

    private boolean stillShows(Scenario scenario) {
        if (triesLeft-- <= 0) {
            return false;
        }
        try {
            return shows.test(scenario);
        } catch (RuntimeException e) {
            return false; // what is left makes no sense any more
        }
    }

    private Scenario shrinkInputs(Scenario scenario) {
        Scenario smallest = scenario;
        for (int i = smallest.inputs().size() - 1; i >= 0; i--) {
            List<Scenario.Timed> fewer = without(smallest.inputs(), i);
            if (stillShows(smallest.with(fewer))) {
                smallest = smallest.with(fewer);
            }
        }
        return smallest;
    }

    private Scenario shrinkPlans(Scenario scenario) {
        Scenario smallest = scenario;
        for (int p = 0; p < smallest.project().plans().size(); p++) {
            boolean changed = true;
            while (changed) {
                changed = false;
                for (Plan candidate : smaller(smallest.project().plans().get(p))) {
                    Scenario next = smallest.with(replace(smallest.project(), p, candidate));
                    if (stillShows(next)) {
                        smallest = next;
                        changed = true;
                        break;
                    }
                }
            }
        }
        return smallest;
    }

    private static List<Plan> smaller(Plan plan) {
        List<Plan> candidates = new ArrayList<>();
        for (Transition t : plan.transitions()) {
            candidates.add(with(
                    plan,
                    plan.places(),
                    plan.transitions().stream().filter(o -> !o.equals(t)).toList(),
                    plan.inEdges().stream()
                            .filter(e -> !e.transition().equals(t.id()))
                            .toList(),
                    plan.outEdges().stream()
                            .filter(e -> !e.transition().equals(t.id()))
                            .toList()));
        }
        for (int i = 0; i < plan.inEdges().size(); i++) {
            candidates.add(with(plan, plan.places(), plan.transitions(), without(plan.inEdges(), i), plan.outEdges()));
        }
        for (int i = 0; i < plan.outEdges().size(); i++) {
            candidates.add(with(plan, plan.places(), plan.transitions(), plan.inEdges(), without(plan.outEdges(), i)));
        }
        fewerRequirements(plan, candidates);
        simplerPlaces(plan, candidates);
        return candidates;
    }

    private static void fewerRequirements(Plan plan, List<Plan> candidates) {
        for (int i = 0; i < plan.inEdges().size(); i++) {
            InEdge e = plan.inEdges().get(i);
            for (int r = 0; e.requirements().size() > 1 && r < e.requirements().size(); r++) {
                InEdge fewer = e.withRequirements(without(e.requirements(), r));
                candidates.add(
                        with(plan, plan.places(), plan.transitions(), set(plan.inEdges(), i, fewer), plan.outEdges()));
            }
        }
        for (int i = 0; i < plan.outEdges().size(); i++) {
            OutEdge e = plan.outEdges().get(i);
            for (int r = 0; e.requirements().size() > 1 && r < e.requirements().size(); r++) {
                OutEdge fewer = e.withRequirements(without(e.requirements(), r));
                candidates.add(
                        with(plan, plan.places(), plan.transitions(), plan.inEdges(), set(plan.outEdges(), i, fewer)));
            }
        }
    }

    private static void simplerPlaces(Plan plan, List<Plan> candidates) {
        for (int i = 0; i < plan.places().size(); i++) {
            Place p = plan.places().get(i);
            for (int o = 0; o < p.outputs().size(); o++) {
                Place simpler = new Place(
                        p.id(),
                        p.name(),
                        p.start(),
                        p.end(),
                        p.endsSharedInstance(),
                        p.mode(),
                        without(p.outputs(), o),
                        p.subMissions(),
                        p.transitionOrder());
                candidates.add(withPlace(plan, i, simpler));
            }
            for (int s = 0; s < p.subMissions().size(); s++) {
                Place simpler = new Place(
                        p.id(),
                        p.name(),
                        p.start(),
                        p.end(),
                        p.endsSharedInstance(),
                        p.mode(),
                        p.outputs(),
                        without(p.subMissions(), s),
                        p.transitionOrder());
                candidates.add(withPlace(plan, i, simpler));
            }
        }
    }

    private static Plan withPlace(Plan plan, int index, Place place) {
        return with(plan, set(plan.places(), index, place), plan.transitions(), plan.inEdges(), plan.outEdges());
    }

    private static Plan with(
            Plan plan, List<Place> places, List<Transition> transitions, List<InEdge> in, List<OutEdge> out) {
        return plan.withPlaces(places.stream().map(p -> withOrderOf(p, in)).toList())
                .withTransitions(transitions)
                .withInEdges(in)
                .withOutEdges(out);
    }

    /** Without transitions that no edge leads to from that place. */
    private static Place withOrderOf(Place p, List<InEdge> in) {
        List<String> order = p.transitionOrder().stream()
                .filter(t -> in.stream()
                        .anyMatch(
                                e -> e.place().equals(p.id()) && e.transition().equals(t)))
                .toList();
        return new Place(
                p.id(),
                p.name(),
                p.start(),
                p.end(),
                p.endsSharedInstance(),
                p.mode(),
                p.outputs(),
                p.subMissions(),
                order);
    }

    private static Project replace(Project project, int index, Plan plan) {
        return new Project(
                project.id(),
                project.name(),
                project.domain(),
                project.globals(),
                project.missionTree(),
                set(project.plans(), index, plan));
    }

    private static <T> List<T> without(List<T> list, int index) {
        List<T> fewer = new ArrayList<>(list);
        fewer.remove(index);
        return fewer;
    }

    private static <T> List<T> set(List<T> list, int index, T item) {
        List<T> changed = new ArrayList<>(list);
        changed.set(index, item);
        return changed;
    }
}
