package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;
import org.sami.spn.vocabulary.Reserved;

/** Goes through the names inside values: references to variables and plans, and names of interrupts. */
final class ValueNames {
    private final String plan;
    private final Function<NameUse, String> names;

    /**
     * Of values in one plan.
     *
     * @param plan the id of the plan to which variables belong
     */
    ValueNames(String plan, Function<NameUse, String> names) {
        this.plan = plan;
        this.names = names;
    }

    /** The value of a field of an event, which may be the name of an interrupt. */
    Value field(String field, Value value, String element, String where) {
        if (field.equals(Reserved.INTERRUPT_NAME) && value instanceof TextValue text) {
            return new TextValue(names.apply(new NameUse(NameUse.Kind.INTERRUPT, text.value(), "", element, where)));
        }
        return value(value, element, where);
    }

    Value value(Value value, String element, String where) {
        if (value instanceof VariableReference reference) {
            return new VariableReference(
                    names.apply(new NameUse(NameUse.Kind.VARIABLE, reference.variable(), plan, element, where)));
        }
        if (value instanceof PlanReference reference) {
            return new PlanReference(names.apply(new NameUse(NameUse.Kind.PLAN, reference.plan(), "", element, where)));
        }
        if (value instanceof ListValue list) {
            List<Value> items = new ArrayList<>();
            list.items().forEach(item -> items.add(value(item, element, where)));
            return new ListValue(items);
        }
        if (value instanceof MapValue map) {
            Map<Value, Value> entries = new LinkedHashMap<>();
            map.entries().forEach((key, item) -> entries.put(value(key, element, where), value(item, element, where)));
            return new MapValue(entries);
        }
        if (value instanceof RecordValue record) {
            Map<String, Value> fields = new LinkedHashMap<>();
            record.fields().forEach((field, item) -> fields.put(field, value(item, element, where)));
            return new RecordValue(record.type(), fields);
        }
        return value;
    }
}
