package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;

/** Finds parts of plans or refuses, and puts changed ones in their places. */
final class Parts {
    private Parts() {}

    static Plan plan(Project project, String id) throws EditRefusedException {
        return found(project.plan(id), "The project has no plan \"" + id + "\"");
    }

    static Place place(Plan plan, String id) throws EditRefusedException {
        return found(plan.place(id), "The plan \"" + plan.id() + "\" has no place " + id);
    }

    static Transition transition(Plan plan, String id) throws EditRefusedException {
        return found(plan.transition(id), "The plan \"" + plan.id() + "\" has no transition " + id);
    }

    static <T> T found(Optional<T> part, String otherwise) throws EditRefusedException {
        if (part.isEmpty()) {
            throw new EditRefusedException(otherwise);
        }
        return part.get();
    }

    /** A list with each element for which something holds replaced by another. */
    static <T> List<T> replaced(List<T> list, Predicate<T> which, UnaryOperator<T> by) {
        return list.stream().map(e -> which.test(e) ? by.apply(e) : e).toList();
    }

    static <T> List<T> without(List<T> list, Predicate<T> which) {
        return list.stream().filter(which.negate()).toList();
    }

    static <T> List<T> with(List<T> list, T more) {
        List<T> longer = new ArrayList<>(list);
        longer.add(more);
        return longer;
    }

    /** A list with the elements of one id at another index; an index behind the end is the end. */
    static <T> List<T> moved(List<T> list, Function<T, String> id, String which, int index) {
        List<T> moved = new ArrayList<>(list);
        list.stream().filter(e -> id.apply(e).equals(which)).findFirst().ifPresent(e -> {
            moved.remove(e);
            moved.add(Math.max(0, Math.min(index, moved.size())), e);
        });
        return moved;
    }

    static Plan withPlace(Plan plan, String id, UnaryOperator<Place> by) throws EditRefusedException {
        place(plan, id);
        return plan.withPlaces(replaced(plan.places(), p -> p.id().equals(id), by));
    }

    static Plan withTransition(Plan plan, String id, UnaryOperator<Transition> by) throws EditRefusedException {
        transition(plan, id);
        return plan.withTransitions(replaced(plan.transitions(), t -> t.id().equals(id), by));
    }

    /** The ids of a plan: vertices, edges, events and sub-missions. */
    static Set<String> ids(Plan plan) {
        Set<String> ids = new HashSet<>();
        for (Place place : plan.places()) {
            ids.add(place.id());
            place.outputs().stream().map(OutputEventSpec::id).forEach(ids::add);
            place.subMissions().stream().map(SubMissionSpec::id).forEach(ids::add);
        }
        for (Transition transition : plan.transitions()) {
            ids.add(transition.id());
            transition.inputs().stream().map(InputEventSpec::id).forEach(ids::add);
        }
        plan.inEdges().stream().map(InEdge::id).forEach(ids::add);
        plan.outEdges().stream().map(OutEdge::id).forEach(ids::add);
        return ids;
    }

    /** An id that is not taken yet, made of a word: the word itself, or with a number from 2. */
    static String freshId(Set<String> taken, String word) {
        String stem = word.isEmpty() ? "new" : word;
        if (!taken.contains(stem)) {
            return stem;
        }
        stem = stem.replaceFirst("-[0-9]+$", "");
        int n = 2;
        while (taken.contains(stem + "-" + n)) {
            n++;
        }
        return stem + "-" + n;
    }
}
