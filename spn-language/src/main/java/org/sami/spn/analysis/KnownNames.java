package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;

/** What a plan speaks of exists: event types on their side, both ends of edges. Readers refuse such files already. */
final class KnownNames implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "E-DANGLING",
                        "The edge, order or layout speaks of an element that is not there: the plan cannot be run.",
                        "Delete it, or add the element."),
                new Advice(
                        "E-UNKNOWN-EVENT",
                        "The domain has no such event: nobody can carry it out or send it.",
                        "Choose an event of the domain, or correct the name."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Place place : plan.plan().places()) {
            for (OutputEventSpec spec : place.outputs()) {
                event(plan, spec.type(), spec.id(), Direction.OUTPUT, plan.at(place), place.id(), report);
            }
        }
        for (Transition t : plan.plan().transitions()) {
            t.inputs().forEach(i -> event(plan, i.type(), i.id(), Direction.INPUT, plan.at(t), t.id(), report));
        }
        for (InEdge e : plan.plan().inEdges()) {
            edge(plan, e.place(), e.transition(), plan.at(e), e.id(), report);
        }
        for (OutEdge e : plan.plan().outEdges()) {
            edge(plan, e.place(), e.transition(), plan.at(e), e.id(), report);
        }
    }

    private static void event(
            PlanContext plan,
            String name,
            String event,
            Direction side,
            String pointer,
            String id,
            Consumer<Finding> report) {
        if (plan.vocabulary()
                .event(name)
                .map(EventType::direction)
                .filter(side::equals)
                .isEmpty()) {
            String kind = side == Direction.OUTPUT ? "output" : "input";
            report.accept(Finding.error(
                            "E-UNKNOWN-EVENT", pointer, "There is no " + kind + " event \"" + name + "\"", id, event)
                    .fixedBy("Remove the event", new RemoveElements(plan.plan().id(), Set.of(event))));
        }
    }

    private static void edge(
            PlanContext plan, String place, String transition, String pointer, String id, Consumer<Finding> report) {
        if (plan.plan().place(place).isEmpty()
                || plan.plan().transition(transition).isEmpty()) {
            String end = plan.place(place)
                    .map(plan::name)
                    .or(() -> plan.transition(transition).map(plan::name))
                    .map(name -> "An edge at the " + name)
                    .orElse("An edge");
            report.accept(Finding.error(
                            "E-DANGLING", pointer, end + " hangs in the air: there is nothing at its other end", id)
                    .fixedBy("Remove the edge", new RemoveElements(plan.plan().id(), Set.of(id))));
        }
    }
}
