package org.sami.crw.handler.activation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/**
 * One boat to which an activation speaks: by its proxy token, or by task tokens that are allocated to it.
 *
 * @param byProxy whether its proxy token entered; answers then name the boat alone
 * @param tasks its tasks that entered, in order; answers name them where only they entered
 */
public record Addressee(String boat, boolean byProxy, List<TaskId> tasks) {
    public Addressee {
        tasks = List.copyOf(tasks);
    }

    /**
     * The boats to which an activation speaks, each once, in order of entry. Where it is delivered again after a crash, those that
     * have left its place since then, or whose task another boat has, are not spoken to again.
     */
    public static List<Addressee> of(Activation activation, HandlerContext context) {
        Map<String, Addressee> byBoat = new LinkedHashMap<>();
        Map<TaskId, String> allocation =
                context.redelivered() ? context.query(EngineView::allocation) : activation.allocation();
        for (Token token : tokens(activation, context)) {
            if (token instanceof Token.Proxy proxy) {
                byBoat.merge(proxy.proxy(), new Addressee(proxy.proxy(), true, List.of()), Addressee::and);
            } else if (token instanceof Token.Task task) {
                String boat = activation.allocation().get(task.task());
                if (boat != null && boat.equals(allocation.get(task.task()))) {
                    byBoat.merge(boat, new Addressee(boat, false, List.of(task.task())), Addressee::and);
                }
            }
        }
        return List.copyOf(byBoat.values());
    }

    private static List<Token> tokens(Activation activation, HandlerContext context) {
        if (!context.redelivered()) {
            return activation.tokens();
        }
        List<Token> standing = context.query(view -> view.mission(activation.mission())
                .map(mission -> mission.marking().getOrDefault(activation.place(), List.of()))
                .orElse(List.of()));
        return activation.tokens().stream().filter(standing::contains).toList();
    }

    /** Whether a token is one by which the activation speaks to this boat. */
    boolean isMeantBy(Token token) {
        return token instanceof Token.Proxy proxy
                ? byProxy && proxy.proxy().equals(boat)
                : token instanceof Token.Task task && tasks.contains(task.task());
    }

    /** Whether one of the tokens by which the activation speaks to this boat still stands in its place. */
    public boolean stands(Activation activation, HandlerContext context) {
        return context.query(view -> view.mission(activation.mission())
                .map(mission -> mission.marking().getOrDefault(activation.place(), List.of()).stream()
                        .anyMatch(this::isMeantBy))
                .orElse(false));
    }

    /** The same without tasks of these names; empty where only they entered. */
    public Optional<Addressee> without(List<TaskId> names) {
        List<TaskId> left = new ArrayList<>(tasks);
        if (byProxy || !left.removeAll(names)) {
            return Optional.of(this);
        }
        return left.isEmpty() ? Optional.empty() : Optional.of(new Addressee(boat, false, left));
    }

    private Addressee and(Addressee other) {
        List<TaskId> all = new ArrayList<>(tasks);
        other.tasks.stream().filter(task -> !all.contains(task)).forEach(all::add);
        return new Addressee(boat, byProxy || other.byProxy, all);
    }

    /**
     * What a field holds for this boat: its value, or where the field is read from tasks that of each of the boat's tasks that
     * entered, in order.
     */
    public List<Value> values(Activation activation, String field) {
        List<Value> values = new ArrayList<>();
        for (TaskId task : tasks) {
            Optional.ofNullable(
                            activation.taskValues().getOrDefault(task, Map.of()).get(field))
                    .ifPresent(values::add);
        }
        if (values.isEmpty()) {
            activation.value(field).ifPresent(values::add);
        }
        return values;
    }

    /** The answer to an activation about this boat. */
    public Occurrence answer(String type, Activation activation, Map<String, Value> values) {
        return Occurrence.answer(type, activation, List.of(boat), byProxy ? List.of() : tasks, values);
    }
}
