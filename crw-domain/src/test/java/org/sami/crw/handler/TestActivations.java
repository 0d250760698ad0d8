package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Builds activations: mission 1, place "here". */
final class TestActivations {
    private final String type;
    private long id = 7;
    private final Map<String, Value> values = new LinkedHashMap<>();
    private final Map<TaskId, Map<String, Value>> taskValues = new LinkedHashMap<>();
    private final Map<TaskId, String> allocation = new LinkedHashMap<>();
    private final List<Token> tokens = new ArrayList<>(List.of(Token.GENERIC));
    private final List<MarkupSpec> markups = new ArrayList<>();
    private Priority priority = Priority.MEDIUM;
    private long mission = 1;

    TestActivations(String type) {
        this.type = type;
    }

    TestActivations id(long value) {
        id = value;
        return this;
    }

    TestActivations mission(long value) {
        mission = value;
        return this;
    }

    TestActivations with(String field, Value value) {
        values.put(field, value);
        return this;
    }

    TestActivations of(String... boats) {
        for (String boat : boats) {
            tokens.add(new Token.Proxy(boat));
        }
        return this;
    }

    TestActivations task(String name, String boat, String field, Value value) {
        TaskId task = new TaskId(1, name);
        tokens.add(new Token.Task(task));
        allocation.put(task, boat);
        taskValues.put(task, Map.of(field, value));
        return this;
    }

    TestActivations priority(Priority value) {
        priority = value;
        return this;
    }

    TestActivations markup(String name, String option, Value value) {
        markups.add(new MarkupSpec(name, Map.of(option, value)));
        return this;
    }

    Activation activation() {
        return new Activation(
                id,
                mission,
                mission,
                1,
                "plan",
                "here",
                "event",
                type,
                values,
                taskValues,
                tokens,
                allocation,
                markups,
                priority);
    }

    Effect effect() {
        return new Effect.Activated(activation());
    }
}
