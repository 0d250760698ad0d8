package org.sami.dreamm.palette;

import java.util.Objects;
import org.sami.spn.edit.FreshIds;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.spn.wizard.PaletteIds;

/** Something that can be added to a plan. */
public sealed interface PaletteItem {
    /** Stable, in kebab case; a profile can hide it. */
    String id();

    /** The id by which a profile names all that become the same in the net, such as the events of places. */
    String kindId();

    /** What people call it. */
    String label();

    /** A few sentences on what it does. */
    String help();

    /** A mark before its label: of what it becomes in the net. */
    String mark();

    /** An event, on a place or on a transition. */
    record Event(EventType type) implements PaletteItem {
        public Event {
            Objects.requireNonNull(type, "type");
        }

        @Override
        public String id() {
            return PaletteIds.event(type);
        }

        @Override
        public String kindId() {
            return type.direction() == Direction.OUTPUT ? "palette-events-of-places" : "palette-events-of-transitions";
        }

        @Override
        public String label() {
            return type.label();
        }

        @Override
        public String help() {
            return type.help();
        }

        @Override
        public String mark() {
            return type.direction() == Direction.OUTPUT ? "→" : "←";
        }
    }

    /** A place that runs a plan of the project. */
    record SubMission(String plan, String label, String help) implements PaletteItem {
        public SubMission {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(label, "label");
            Objects.requireNonNull(help, "help");
        }

        @Override
        public String id() {
            return PaletteIds.subMission(plan);
        }

        @Override
        public String kindId() {
            return "palette-sub-missions";
        }

        @Override
        public String mark() {
            return "◎";
        }
    }

    /** A role that somebody of the team takes: a task of the plan. */
    record Role(TaskClass taskClass) implements PaletteItem {
        public Role {
            Objects.requireNonNull(taskClass, "taskClass");
        }

        @Override
        public String id() {
            return "palette-role-" + FreshIds.ofWords(taskClass.name());
        }

        @Override
        public String kindId() {
            return "palette-roles";
        }

        @Override
        public String label() {
            return "Task: " + taskClass.name();
        }

        @Override
        public String help() {
            return taskClass.help();
        }

        @Override
        public String mark() {
            return "◇";
        }
    }

    /** A blank place. */
    record BlankPlace() implements PaletteItem {
        @Override
        public String id() {
            return PaletteIds.BLANK_PLACE;
        }

        @Override
        public String kindId() {
            return "palette-blank";
        }

        @Override
        public String label() {
            return "Blank place";
        }

        @Override
        public String help() {
            return "A place where tokens wait; it asks for nothing.";
        }

        @Override
        public String mark() {
            return "○";
        }
    }

    /** A blank transition. */
    record BlankTransition() implements PaletteItem {
        @Override
        public String id() {
            return PaletteIds.BLANK_TRANSITION;
        }

        @Override
        public String kindId() {
            return "palette-blank";
        }

        @Override
        public String label() {
            return "Blank transition";
        }

        @Override
        public String help() {
            return "A transition that fires as soon as the requirements of its edges are met; it waits for no event.";
        }

        @Override
        public String mark() {
            return "▮";
        }
    }
}
