package org.sami.dreamm;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.value.Value;
import org.sami.ui.check.WindowRobot;

/** Gives the events of a drawn plan what its solution gives them: fields, variables, values that are asked for, and markup. */
final class EventGestures {
    private final WindowRobot robot;
    private final Supplier<DreammContext> context;
    private final NetGestures net;
    private final InspectorGestures inspector;
    private final Map<String, String> mine;

    /**
     * A hand for a plan whose events are drawn.
     *
     * @param mine the ids of the solution's elements, and the names of its variables, in the window's plan; variables that are made are added
     */
    EventGestures(
            WindowRobot robot,
            Supplier<DreammContext> context,
            NetGestures net,
            InspectorGestures inspector,
            Map<String, String> mine) {
        this.robot = robot;
        this.context = context;
        this.net = net;
        this.inspector = inspector;
        this.mine = mine;
    }

    private String mine(String id) {
        return Optional.ofNullable(mine.get(id)).orElseThrow(() -> new AssertionError(id + " is not drawn yet"));
    }

    /** The ids of a vertex's events, with their types, in their order. */
    static Map<String, String> eventsOf(Plan plan, String vertex) {
        Map<String, String> events = new LinkedHashMap<>();
        plan.place(vertex).ifPresent(place -> place.outputs().forEach(event -> events.put(event.id(), event.type())));
        plan.transition(vertex)
                .ifPresent(transition -> transition.inputs().forEach(event -> events.put(event.id(), event.type())));
        return events;
    }

    private int index(String vertex, String event) {
        return new ArrayList<>(eventsOf(net.plan(), mine(vertex)).keySet()).indexOf(mine(event));
    }

    private InputEventSpec input(String vertex, String event) {
        return net.plan().transition(mine(vertex)).orElseThrow().inputs().stream()
                .filter(each -> each.id().equals(mine(event)))
                .findFirst()
                .orElseThrow();
    }

    private OutputEventSpec output(String vertex, String event) {
        return net.plan().place(mine(vertex)).orElseThrow().outputs().stream()
                .filter(each -> each.id().equals(mine(event)))
                .findFirst()
                .orElseThrow();
    }

    /** Writes answers into variables, and says with which value an answer is taken. */
    void write(Transition transition) {
        for (InputEventSpec event : transition.inputs()) {
            event.writes().forEach((field, variable) -> {
                Optional<String> now = Optional.ofNullable(
                        input(transition.id(), event.id()).writes().get(field));
                now.ifPresent(there -> mine.putIfAbsent(variable, there));
                if (now.isEmpty() || !now.get().equals(mine.get(variable))) {
                    net.click(mine(transition.id()));
                    inspector.choose(
                            index(transition.id(), event.id()),
                            InspectorGestures.field(field) + "-write",
                            mine.getOrDefault(variable, "new variable…"));
                    robot.until(
                            field + " is written",
                            () -> input(transition.id(), event.id()).writes().containsKey(field));
                    mine.put(
                            variable,
                            Optional.ofNullable(input(transition.id(), event.id())
                                            .writes()
                                            .get(field))
                                    .orElseThrow());
                }
            });
            event.fields().forEach((field, value) -> only(transition.id(), event.id(), field, value));
        }
    }

    private void only(String vertex, String event, String field, Value value) {
        if (Optional.of(value)
                .equals(Optional.ofNullable(input(vertex, event).fields().get(field)))) {
            return;
        }
        net.click(mine(vertex));
        int index = index(vertex, event);
        inspector.choose(index, InspectorGestures.field(field) + "-only", "it is");
        inspector.value(index, field, value);
        robot.until(field + " is asked for", () -> input(vertex, event).fields().containsKey(field));
    }

    /** Says from where the fields of a place's events come, and how they are shown. */
    void fill(Place place) {
        for (OutputEventSpec event : place.outputs()) {
            event.fields().forEach((field, source) -> source(place.id(), event.id(), field, source));
            event.markups().forEach(markup -> markup(place.id(), event.id(), markup));
        }
    }

    private void source(String vertex, String event, String field, FieldSource source) {
        Supplier<Optional<FieldSource>> now =
                () -> Optional.ofNullable(output(vertex, event).fields().get(field));
        if (fits(now.get(), source)) {
            return;
        }
        net.click(mine(vertex));
        int index = index(vertex, event);
        String box = InspectorGestures.field(field) + "-source";
        if (source instanceof FieldSource.Fixed fixed) {
            inspector.choose(index, box, "value");
            inspector.value(index, field, fixed.value());
        } else if (source instanceof FieldSource.Asked) {
            inspector.choose(index, box, "asked, can be changed");
        } else if (source instanceof FieldSource.FromTask) {
            inspector.choose(index, box, "@task");
        } else {
            inspector.choose(index, box, "answer or variable");
        }
        robot.until(field + " comes from somewhere", () -> now.get().isPresent());
        if (!fits(now.get(), source) && source instanceof FieldSource.FromVariable read) {
            String variable = mine(read.variable());
            String list = InspectorGestures.field(field) + "-variable";
            String line = inspector.offered(index, list).stream()
                    .filter(each -> each.contains(variable))
                    .findFirst()
                    .orElseThrow(() -> new AssertionError(field + " can not be read from " + variable));
            inspector.choose(index, list, line);
            robot.until(field + " is read from " + variable, () -> fits(now.get(), source));
        }
    }

    /** Whether a field comes from where it should; a value is what was typed. */
    private boolean fits(Optional<FieldSource> now, FieldSource wanted) {
        if (wanted instanceof FieldSource.FromVariable read) {
            return now.filter(there -> there instanceof FieldSource.FromVariable reads
                            && reads.variable().equals(mine.get(read.variable())))
                    .isPresent();
        }
        return now.filter(there -> there.equals(wanted)
                        || (there.getClass() == wanted.getClass() && !(there instanceof FieldSource.Fixed)))
                .isPresent();
    }

    private void markup(String vertex, String event, MarkupSpec wanted) {
        Supplier<Optional<MarkupSpec>> now = () -> output(vertex, event).markups().stream()
                .filter(each -> each.type().equals(wanted.type()))
                .findFirst();
        if (now.get().equals(Optional.of(wanted))) {
            return;
        }
        net.click(mine(vertex));
        int index = index(vertex, event);
        if (now.get().isEmpty()) {
            inspector.addMarkup(
                    index,
                    Optional.ofNullable(context.get().vocabulary().markups().get(wanted.type()))
                            .orElseThrow(() -> new AssertionError("the lesson does not have " + wanted.type()))
                            .label());
        }
        wanted.options().forEach((option, value) -> {
            boolean there = now.get()
                    .filter(each -> each.option(option).equals(Optional.of(value)))
                    .isPresent();
            if (!there) {
                inspector.option(index, wanted.type(), option, value);
            }
        });
        if (now.get().isEmpty()) {
            inspector.confirmMarkup(index, wanted.type());
        }
        robot.until(
                wanted.type() + " is there",
                () -> now.get()
                        .filter(each -> each.options()
                                .keySet()
                                .containsAll(wanted.options().keySet()))
                        .isPresent());
    }
}
