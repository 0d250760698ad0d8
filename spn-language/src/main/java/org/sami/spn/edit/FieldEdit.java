package org.sami.spn.edit;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.value.Value;

/** Changes of single fields of events; what else an event has stays as it is. */
public sealed interface FieldEdit extends PlanEdit {
    /** Says where a field of an output event comes from. */
    record SetField(String plan, String event, String field, FieldSource source) implements FieldEdit {
        public SetField {
            check(plan, event, field);
            Objects.requireNonNull(source, "source");
        }

        @Override
        public String label() {
            return "Set " + field + " of \"" + event + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.withOutput(before, event, o -> o.withFields(with(o.fields(), field, source)));
        }
    }

    /** Sets the value by which an input event is selected. */
    record SetInputField(String plan, String event, String field, Value value) implements FieldEdit {
        public SetInputField {
            check(plan, event, field);
            Objects.requireNonNull(value, "value");
        }

        @Override
        public String label() {
            return "Set " + field + " of \"" + event + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.withInput(before, event, i -> i.withFields(with(i.fields(), field, value)));
        }
    }

    /** Takes the value or source of a field away. */
    record ClearField(String plan, String event, String field) implements FieldEdit {
        public ClearField {
            check(plan, event, field);
        }

        @Override
        public String label() {
            return "Reset " + field + " of \"" + event + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.with(
                    before,
                    event,
                    o -> o.withFields(without(o.fields(), field)),
                    i -> i.withFields(without(i.fields(), field)));
        }
    }

    /** Writes a field of an event into a variable. */
    record SetWrite(String plan, String event, String field, String variable) implements FieldEdit {
        public SetWrite {
            check(plan, event, field);
            Objects.requireNonNull(variable, "variable");
        }

        @Override
        public String label() {
            return "Write " + field + " of \"" + event + "\" into " + variable;
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.with(
                    before,
                    event,
                    o -> o.withWrites(with(o.writes(), field, variable)),
                    i -> i.withWrites(with(i.writes(), field, variable)));
        }
    }

    /** Writes a field of an event into no variable any more. */
    record ClearWrite(String plan, String event, String field) implements FieldEdit {
        public ClearWrite {
            check(plan, event, field);
        }

        @Override
        public String label() {
            return "Do not write " + field + " of \"" + event + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            return Events.with(
                    before,
                    event,
                    o -> o.withWrites(without(o.writes(), field)),
                    i -> i.withWrites(without(i.writes(), field)));
        }
    }

    /** Lets an event or sub-mission speak of another variable than of one; others keep speaking of it. */
    record UseVariable(String plan, String element, String instead, String variable) implements FieldEdit {
        public UseVariable {
            Objects.requireNonNull(plan, "plan");
            Objects.requireNonNull(element, "element");
            Objects.requireNonNull(instead, "instead");
            Objects.requireNonNull(variable, "variable");
        }

        @Override
        public String label() {
            return "Use " + variable + " at \"" + element + "\"";
        }

        @Override
        public Plan change(Plan before, EditContext context) throws EditRefusedException {
            Plan after = PlanNames.replaced(
                    before,
                    use -> use.is(NameUse.Kind.VARIABLE, instead, before)
                                    && use.element().equals(element)
                            ? variable
                            : use.name());
            if (after.equals(before)) {
                throw new EditRefusedException(
                        "In the plan \"" + plan + "\" " + element + " does not speak of " + instead);
            }
            return after;
        }
    }

    private static void check(String plan, String event, String field) {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(event, "event");
        Objects.requireNonNull(field, "field");
    }

    private static <T> Map<String, T> with(Map<String, T> map, String key, T value) {
        Map<String, T> changed = new LinkedHashMap<>(map);
        changed.put(key, value);
        return changed;
    }

    private static <T> Map<String, T> without(Map<String, T> map, String key) {
        Map<String, T> changed = new LinkedHashMap<>(map);
        changed.remove(key);
        return changed;
    }
}
