package org.sami.spn.edit;

import java.util.List;
import java.util.function.UnaryOperator;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/** Replaces events where they stand, or refuses. */
final class Events {
    private Events() {}

    static boolean isOutput(Plan plan, String event) {
        return plan.places().stream().flatMap(p -> p.outputs().stream()).anyMatch(o -> o.id().equals(event));
    }

    static Plan withOutput(Plan plan, String event, UnaryOperator<OutputEventSpec> by) throws EditRefusedException {
        Place place = Parts.found(
                plan.places().stream()
                        .filter(p -> p.outputs().stream().anyMatch(o -> o.id().equals(event)))
                        .findFirst(),
                "The plan \"" + plan.id() + "\" has no output event " + event);
        return Parts.withPlace(
                plan, place.id(), p -> p.withOutputs(Parts.replaced(p.outputs(), o -> o.id().equals(event), by)));
    }

    static Plan withInput(Plan plan, String event, UnaryOperator<InputEventSpec> by) throws EditRefusedException {
        Transition transition = Parts.found(
                plan.transitions().stream()
                        .filter(t -> t.inputs().stream().anyMatch(i -> i.id().equals(event)))
                        .findFirst(),
                "The plan \"" + plan.id() + "\" has no input event " + event);
        return Parts.withTransition(
                plan, transition.id(), t -> t.withInputs(Parts.replaced(t.inputs(), i -> i.id().equals(event), by)));
    }

    static Plan withMarkups(Plan plan, String event, UnaryOperator<List<MarkupSpec>> by) throws EditRefusedException {
        return with(plan, event, o -> o.withMarkups(by.apply(o.markups())), i -> i.withMarkups(by.apply(i.markups())));
    }

    /** Replaces an event, of whichever direction it is. */
    static Plan with(
            Plan plan, String event, UnaryOperator<OutputEventSpec> output, UnaryOperator<InputEventSpec> input)
            throws EditRefusedException {
        return isOutput(plan, event) ? withOutput(plan, event, output) : withInput(plan, event, input);
    }
}
