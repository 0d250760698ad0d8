package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;

/**
 * Takes robots out of missions: dropped by the operator, or withdrawn by an interrupt in a parent. Choices offer them no longer.
 *
 * <p>Implements R-TOK-5, R-TOK-6, R-TOK-7.
 */
public final class RobotRemoval {
    private final MissionRules rules;
    /** Robots that instances have lost, by mission; their choices are to be asked again. */
    private final Map<MissionState, Set<String>> withdrawn = new LinkedHashMap<>();

    public RobotRemoval(MissionRules rules) {
        this.rules = rules;
    }

    /** The operator drops a robot; a reason where that makes no sense. */
    public Optional<String> drop(Input.ProxyDropped input) {
        MissionState root = rules.state().missions.get(input.mission());
        if (input.mission() != Ids.NONE && root == null) {
            return Optional.of("There is no running mission " + input.mission());
        }
        Token token = new Token.Proxy(input.proxy());
        if (input.mission() == Ids.NONE && !rules.state().removeProxy(input.proxy()) && !standsSomewhere(token)) {
            return Optional.of("No robot '" + input.proxy() + "' is known");
        }
        List<MissionState> concerned = rules.state().missions.values().stream()
                .filter(m -> !m.ended && (root == null || m.root == root.root))
                .toList();
        // before any of them ends for want of the robot: its tasks are released as well
        concerned.forEach(m -> rules.allocation.release(m, input.proxy()));
        for (MissionState m :
                concerned) { // in the order of their ids: a child is looked at in its own turn, not in its parent's
            if (!m.ended) {
                drop(m, token);
            }
        }
        withdrawn.clear();
        Map<MissionState, Set<String>> gone = new LinkedHashMap<>();
        concerned.forEach(m -> gone.put(m, Set.of(input.proxy())));
        rules.robotChoices.gone(gone, "dropped");
        rules.work.addWithdrawn();
        return Optional.empty();
    }

    /** An occurrence can have brought in a robot that never joined. */
    private boolean standsSomewhere(Token token) {
        for (MissionState m : rules.state().missions.values()) {
            for (PlaceState place : m.places) {
                if (place != null && place.has(token)) {
                    return true;
                }
            }
        }
        return false;
    }

    private void drop(MissionState m, Token token) {
        for (List<Token> waiting : m.waiting) {
            waiting.removeIf(token::equals);
        }
        takeOut(m, token);
        rules.work.addDropped(m);
        if (m.ended) {
            return;
        }
        forget(m, token);
        for (TransitionState t : m.transitions) {
            if (t != null && t.pending > 0 && rules.pendings.strikeAll(t, token)) {
                rules.work.add(t);
            }
        }
    }

    /** Nobody waits for the robot in instances of a mission any longer, in any place. */
    private void forget(MissionState m, Token token) {
        for (PlaceState place : m.places) {
            if (place == null) {
                continue;
            }
            List<Instance> instances = new ArrayList<>();
            place.instanceVisits().values().forEach(v -> instances.addAll(v.instances));
            for (SharedRun run : place.shared) {
                rules.sharedInstances.forget(run, token);
            }
            for (Instance i : instances) {
                i.returned.removeIf(token::equals);
                boolean started = i.starting.removeIf(token::equals);
                if (started && i.starting.isEmpty() && i.child != null) {
                    i.status = Instance.Status.ABORTED;
                    rules.missionEnd.stopSilently(i.child, Outcome.ABORTED);
                }
            }
        }
    }

    /** Removes every copy of a token from a mission and its descendants. */
    public void takeOut(MissionState m, Token token) {
        if (m.ended) {
            return;
        }
        List<PlacedToken> removed = new ArrayList<>();
        for (PlaceState place : m.places) {
            if (place != null) {
                removed.addAll(place.copies(token));
            }
        }
        for (List<Token> waiting : m.waiting) {
            waiting.removeIf(token::equals);
        }
        if (removed.isEmpty()) {
            return;
        }
        if (token instanceof Token.Proxy proxy) {
            withdrawn.computeIfAbsent(m, key -> new LinkedHashSet<>()).add(proxy.proxy());
        }
        long before = rules.state().stamp;
        rules.removal.remove(removed);
        withdrawCommands(m, token);
        for (PlacedToken e : removed) {
            rules.work.withdrawn(e.place());
        }
        for (PlacedToken e : removed) {
            rules.removal.left(e, before, true);
        }
        rules.sharedInstances.pulled(removed, List.of(), before);
    }

    /** Asks the choices of instances again that offer robots which were withdrawn from them. */
    void askWithoutWithdrawn() {
        if (!withdrawn.isEmpty()) {
            rules.robotChoices.gone(withdrawn, "withdrawn");
            withdrawn.clear();
        }
    }

    /** Whether no choice has to be asked again. */
    boolean isDone() {
        return withdrawn.isEmpty();
    }

    private void withdrawCommands(MissionState m, Token token) {
        if (token instanceof Token.Proxy proxy) {
            rules.emit(new Effect.CommandsWithdrawn(m.id, List.of(proxy.proxy())));
        } else if (token instanceof Token.Task task) {
            TaskState state = rules.task(task.task());
            if (state != null && !state.proxy().isEmpty()) {
                rules.emit(new Effect.CommandsWithdrawn(m.id, List.of(state.proxy())));
            }
        }
    }
}
