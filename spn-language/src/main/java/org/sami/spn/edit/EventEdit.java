package org.sami.spn.edit;

import java.util.Objects;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;

/** Changes of events, their markups, and sub-missions of one plan. They are removed by {@link RemoveElements}. */
public sealed interface EventEdit extends PlanEdit {
    /** Adds an output event at the end of those of a place. */
    record AddOutput(String plan, String place, OutputEventSpec event) implements EventEdit {
        public AddOutput {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(place, "place");
            Objects.requireNonNull(event, "event");
        }

        @Override
        public String label() {
            return "Add " + event.type() + " to \"" + place + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Parts.withPlace(before, place, p -> p.withOutputs(Parts.with(p.outputs(), event)));
        }
    }

    /** Replaces the output event of the same id. */
    record ChangeOutput(String plan, OutputEventSpec event) implements EventEdit {
        public ChangeOutput {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(event, "event");
        }

        @Override
        public String label() {
            return "Change " + event.type() + " \"" + event.id() + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.withOutput(before, event.id(), old -> event);
        }
    }

    /** Adds an input event at the end of those of a transition. */
    record AddInput(String plan, String transition, InputEventSpec event) implements EventEdit {
        public AddInput {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(transition, "transition");
            Objects.requireNonNull(event, "event");
        }

        @Override
        public String label() {
            return "Add " + event.type() + " to \"" + transition + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Parts.withTransition(before, transition, t -> t.withInputs(Parts.with(t.inputs(), event)));
        }
    }

    /** Replaces the input event of the same id. */
    record ChangeInput(String plan, InputEventSpec event) implements EventEdit {
        public ChangeInput {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(event, "event");
        }

        @Override
        public String label() {
            return "Change " + event.type() + " \"" + event.id() + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.withInput(before, event.id(), old -> event);
        }
    }

    /** Moves an event or a sub-mission among its neighbours of the same vertex. */
    record MoveEvent(String plan, String event, int index) implements EventEdit {
        public MoveEvent {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(event, "event");
        }

        @Override
        public String label() {
            return "Move \"" + event + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            if (!Parts.ids(before).contains(event)) {
                throw new EditRefusedException("The plan \"" + plan + "\" has no event " + event);
            }
            return before.withPlaces(before.places().stream()
                            .map(p -> p.withOutputs(Parts.moved(p.outputs(), OutputEventSpec::id, event, index))
                                    .withSubMissions(Parts.moved(p.subMissions(), SubMissionSpec::id, event, index)))
                            .toList())
                    .withTransitions(before.transitions().stream()
                            .map(t -> t.withInputs(Parts.moved(t.inputs(), InputEventSpec::id, event, index)))
                            .toList());
        }
    }

    /** Gives an event a markup; one of the same type is replaced. */
    record SetMarkup(String plan, String event, MarkupSpec markup) implements EventEdit {
        public SetMarkup {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(markup, "markup");
        }

        @Override
        public String label() {
            return "Mark \"" + event + "\" with " + markup.type();
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.withMarkups(
                    before,
                    event,
                    markups -> Parts.with(Parts.without(markups, m -> m.type().equals(markup.type())), markup));
        }
    }

    /** Takes a markup from an event. */
    record RemoveMarkup(String plan, String event, String markup) implements EventEdit {
        public RemoveMarkup {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(event, "event");
            Objects.requireNonNull(markup, "markup");
        }

        @Override
        public String label() {
            return "Remove " + markup + " from \"" + event + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.withMarkups(
                    before,
                    event,
                    markups -> Parts.without(markups, m -> m.type().equals(markup)));
        }
    }

    /** Lets a place run a plan as a sub-mission. */
    record AddSubMission(String plan, String place, SubMissionSpec subMission) implements EventEdit {
        public AddSubMission {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(place, "place");
            Objects.requireNonNull(subMission, "subMission");
        }

        @Override
        public String label() {
            return "Run \"" + subMission.plan() + "\" at \"" + place + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Parts.withPlace(before, place, p -> p.withSubMissions(Parts.with(p.subMissions(), subMission)));
        }
    }

    /** Replaces the sub-mission of the same id. */
    record ChangeSubMission(String plan, SubMissionSpec subMission) implements EventEdit {
        public ChangeSubMission {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(subMission, "subMission");
        }

        @Override
        public String label() {
            return "Change sub-mission \"" + subMission.id() + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            boolean known = before.places().stream()
                    .flatMap(p -> p.subMissions().stream())
                    .anyMatch(s -> s.id().equals(subMission.id()));
            if (!known) {
                throw new EditRefusedException("The plan \"" + plan + "\" has no sub-mission " + subMission.id());
            }
            return before.withPlaces(before.places().stream()
                    .map(p -> p.withSubMissions(
                            Parts.replaced(p.subMissions(), s -> s.id().equals(subMission.id()), s -> subMission)))
                    .toList());
        }
    }
}
