package org.sami.spn.plannet;

import java.util.List;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;

/** Lists what the net of a plan leaves to chance, place by place and transition by transition. */
final class AbstractionsOfPlan {
    private final PlanNetWork work;
    private final AbstractionList list;

    AbstractionsOfPlan(PlanNetWork work, AbstractionList list) {
        this.work = work;
        this.list = list;
    }

    void list() {
        Plan plan = work.plan();
        for (Place place : plan.places()) {
            place.outputs().stream()
                    .flatMap(output -> work.vocabulary().event(output.type()).stream())
                    .filter(type -> type.role() == EventRole.ABORT_MISSION || type.role() == EventRole.COMPLETE_MISSION)
                    .filter(type -> !place.end())
                    .forEach(type -> list.wider(
                            work.path(place.id()),
                            "\"" + title(place) + "\" ends the mission; the net lets it go on as well"));
        }
        for (Transition t : plan.transitions()) {
            transition(plan, t);
        }
        List<String> copied = work.team().stream()
                .filter(work.possible()::isLoose)
                .filter(token -> !token.equals(PlanToken.GENERIC))
                .map(PlanToken::label)
                .toList();
        if (!copied.isEmpty()) {
            list.wider(
                    work.parent().isEmpty()
                            ? ""
                            : work.path(plan.startPlace().map(Place::id).orElse("")),
                    (work.parent().isEmpty() ? "the plan can make" : "the sub-mission can have")
                            + " copies of " + String.join(", ", copied)
                            + ": the net follows in which places they are, and not how many copies are there");
        }
    }

    private void transition(Plan plan, Transition t) {
        if (t.inputs().isEmpty()) {
            if (plan.transitions().size() > 1) {
                list.wider(
                        work.path(t.id()),
                        "\"" + title(t) + "\" fires at once; the net lets other things happen before");
            }
        } else {
            t.inputs()
                    .forEach(input -> list.wider(
                            work.path(t.id()),
                            "\""
                                    + work.vocabulary()
                                            .event(input.type())
                                            .map(EventType::title)
                                            .orElse(input.type())
                                    + "\" may come at \"" + title(t)
                                    + "\" whenever it could fire, again and again, and name any of those who"
                                    + " are there"));
        }
        TransitionLooks.choosing(plan, t)
                .ifPresent(r -> list.wider(
                        work.path(t.id()),
                        "\"" + title(t) + "\" selects the " + r.n()
                                + " oldest tokens; the net lets it select any as many"));
    }

    private static String title(Place place) {
        return place.name().isBlank() ? place.id() : place.name();
    }

    private static String title(Transition t) {
        return t.name().isBlank() ? t.id() : t.name();
    }
}
