package org.sami.spn.engine.rule;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.FieldSource;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/**
 * Sends the output events of an entered place, each with exactly the tokens that entered (thesis, Algorithm 3).
 *
 * <p>Implements R-END-7, R-ACT-1, R-ACT-2, R-ACT-5.
 */
final class Activating {
    private final MissionRules rules;

    Activating(MissionRules rules) {
        this.rules = rules;
    }

    /** Activates the outputs of a place that was entered; nobody waits for answers where the mission ends. */
    void activate(Visit v, boolean ending) {
        for (CompiledOutput output : v.place.place.outputs) {
            SentActivation sent = new SentActivation(resolve(v, output), v, output);
            if (!ending) {
                v.addSent(sent);
                rules.state().sent.put(sent.activation.id(), sent);
            }
            rules.emit(new Effect.Activated(sent.activation));
            act(sent, ending);
        }
    }

    private Activation resolve(Visit v, CompiledOutput output) {
        MissionState m = v.place.mission;
        Map<String, Value> values = output.fixed;
        Map<TaskId, Map<String, Value>> taskValues = Map.of();
        if (!output.resolved.isEmpty()) {
            values = new LinkedHashMap<>(output.fixed);
            for (Map.Entry<String, FieldSource> field : output.resolved.entrySet()) {
                if (field.getValue() instanceof FieldSource.FromTask) {
                    taskValues = taskValues.isEmpty() ? new LinkedHashMap<>() : taskValues;
                    readTasks(v, field.getKey(), taskValues);
                } else {
                    resolveField(m, output, field.getKey(), field.getValue(), values);
                }
            }
        }
        return new Activation(
                ++rules.state().lastActivation,
                m.id,
                m.root.id,
                v.id,
                m.plan.plan.id(),
                v.place.place.id(),
                output.spec.id(),
                output.typeName,
                values,
                taskValues,
                v.entered,
                allocation(v),
                output.spec.markups(),
                output.priority);
    }

    private void resolveField(
            MissionState m, CompiledOutput output, String field, FieldSource source, Map<String, Value> values) {
        if (source instanceof FieldSource.Asked) {
            Value given = m.parameters.get(output.spec.id() + "." + field);
            if (given != null) {
                values.put(field, given);
            }
        } else if (source instanceof FieldSource.FromVariable read) {
            Value value = rules.scopes.read(m, read.variable());
            if (value != null) {
                values.put(field, value);
            }
            String written = output.spec.writes().get(field);
            if (written != null && values.containsKey(field)) {
                rules.scopes.write(m, written, values.get(field));
            }
        }
    }

    private void readTasks(Visit v, String field, Map<TaskId, Map<String, Value>> into) {
        for (Token token : v.entered) {
            if (token instanceof Token.Task task) {
                TaskState state = rules.task(task.task());
                Value value = state == null ? null : state.field(field);
                if (value != null) {
                    into.computeIfAbsent(task.task(), k -> new LinkedHashMap<>())
                            .put(field, value);
                }
            }
        }
    }

    private Map<TaskId, String> allocation(Visit v) {
        Map<TaskId, String> result = Map.of();
        for (Token token : v.entered) {
            if (token instanceof Token.Task task) {
                TaskState state = rules.task(task.task());
                if (state != null && !state.proxy().isEmpty()) {
                    result = result.isEmpty() ? new LinkedHashMap<>() : result;
                    result.put(task.task(), state.proxy());
                }
            }
        }
        return result;
    }

    /** What the engine itself does for an activation. */
    private void act(SentActivation sent, boolean ending) {
        MissionState m = sent.mission();
        switch (sent.output.role) {
            case RETURN_VALUE ->
                m.returnValue = sent.activation
                        .value(Reserved.VALUE)
                        .map(CompiledInput::text)
                        .orElse("");
            case APPLY_ALLOCATION -> rules.allocation.apply(sent);
            case ABORT_MISSION -> {
                rules.missionEnd.asked(m, Outcome.ABORTED);
                rules.post(() -> rules.interrupts.abort(m));
            }
            case COMPLETE_MISSION -> {
                rules.missionEnd.asked(m, Outcome.COMPLETED);
                rules.post(() -> rules.interrupts.complete(m));
            }
            default -> {
                if (!ending) {
                    actOngoing(sent);
                }
            }
        }
    }

    private void actOngoing(SentActivation sent) {
        switch (sent.output.role) {
            case TIMER, PROXY_TIMER -> rules.timers.start(sent);
            case GET_ALL_TOKENS ->
                rules.post(() -> answer(
                        sent,
                        EventRole.TOKENS_RETURNED,
                        List.copyOf(rules.state().proxies()),
                        List.of()));
            case GENERATE_TASKS -> {
                List<TaskId> made = rules.allocation.generate(sent);
                rules.post(() -> answer(sent, EventRole.TASKS_GENERATED, List.of(), made));
            }
            default -> {
                if (sent.output.decision != null) {
                    rules.questions.open(sent);
                }
            }
        }
    }

    /** The engine's own answer to an activation: routed like any other, because a transition may still wait for tokens that have moved on. */
    void answer(SentActivation sent, EventRole role, List<String> proxies, List<TaskId> tasks) {
        if (!sent.mission().ended) {
            rules.routing.route(Occurrence.answer(
                    rules.project().answerType(sent.output, role), sent.activation, proxies, tasks, Map.of()));
        }
    }
}
