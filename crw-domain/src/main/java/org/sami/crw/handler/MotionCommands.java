package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.decision.MessageSink;
import org.sami.crw.decision.OperatorMessage;
import org.sami.crw.proxy.BoatCommand;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.FollowPath;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.Withdrawal;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TextValue;

/**
 * The commands that activations have sent to boats, and what the plan hears of each: its progress, and one answer (path completed
 * or path failed). A lost link is no failure: the command waits. A command whose id is with the boat already is not sent twice.
 * For the fleet's thread.
 */
final class MotionCommands implements BoatListener {
    private final ProxyRegistry boats;
    private final MessageSink messages;
    private final Map<String, Sent> sent = new LinkedHashMap<>();
    private final Map<Long, Set<String>> takenBack = new HashMap<>();

    MotionCommands(ProxyRegistry boats, MessageSink messages) {
        this.boats = boats;
        this.messages = messages;
    }

    /** Gives commands to boats; what is settled at once is answered in one batch. */
    void send(Activation activation, HandlerContext context, List<Move> moves) {
        Set<String> without = takenBack.getOrDefault(activation.id(), Set.of());
        takenBack.remove(activation.id());
        List<Input> settled = new ArrayList<>();
        for (Move move : moves) {
            if (without.contains(move.addressee().boat())) {
                continue;
            }
            Sent one = new Sent(activation, context, move);
            Optional<BoatProxy> boat = boats.find(move.addressee().boat());
            if (move.command() instanceof FollowPath path
                    && path.startIndex() == path.points().size()) {
                settled.addAll(one.completed());
            } else if (boat.isEmpty()) {
                settled.addAll(failed(one, "no boat of that name is known"));
            } else {
                sent.put(move.command().commandId(), one);
                boat.get().submit(move.command());
            }
        }
        if (!settled.isEmpty()) {
            context.post(settled);
        }
    }

    /** Takes back for boats what an activation is about to ask: the step that asked went on to withdraw it. */
    void takeBack(long activation, List<String> named) {
        takenBack.computeIfAbsent(activation, id -> new HashSet<>()).addAll(named);
    }

    /** Takes back what a mission has for boats; no boats named = for all. */
    void withdraw(long mission, List<String> named) {
        for (String boat : named.isEmpty() ? boats.boatIds() : named) {
            boats.find(boat)
                    .ifPresent(proxy -> proxy.withdraw(mission).forEach(command -> sent.remove(command.commandId())));
        }
    }

    /** Takes back what a mission has for a boat, because another wanted it so; whoever waits for it hears that it failed. */
    void abort(long mission, String boat, String reason) {
        boats.find(boat)
                .ifPresent(proxy -> proxy.withdraw(mission).forEach(command -> onFailed(boat, command, reason)));
    }

    @Override
    public void onProgress(String boatId, BoatCommand command, int visitedCount) {
        Sent one = sent.get(command.commandId());
        if (one != null) {
            one.post(one.progress(visitedCount));
        }
    }

    @Override
    public void onCompleted(String boatId, BoatCommand command) {
        Sent one = sent.remove(command.commandId());
        if (one != null) {
            one.post(one.completed());
        }
    }

    @Override
    public void onFailed(String boatId, BoatCommand command, String reason) {
        Sent one = sent.remove(command.commandId());
        if (one != null) {
            one.post(failed(one, reason));
        }
    }

    /** A command that was displaced fails for whoever still waits for it. */
    @Override
    public void onWithdrawn(String boatId, BoatCommand command, Withdrawal why) {
        Sent one = sent.remove(command.commandId());
        if (one == null) {
            return;
        }
        if (why == Withdrawal.PREEMPTED) {
            one.post(failed(one, "a command of higher priority took the boat"));
        } else if (one.isAwaited()) {
            one.post(failed(one, "a newer command of the same mission took its place"));
        }
    }

    private List<Input> failed(Sent one, String reason) {
        Activation activation = one.activation;
        String boat = one.move.addressee().boat();
        messages.tell(new OperatorMessage(
                one.context.nowMillis(),
                activation.mission(),
                OperatorMessage.Source.DOMAIN,
                Priority.HIGH,
                boat + " could not do what " + activation.place() + " asked: " + reason,
                List.of(boat),
                ""));
        return one.move.answered()
                ? List.of(new Input.Received(one.move
                        .addressee()
                        .answer(EventNames.PATH_FAILED, activation, Map.of("reason", new TextValue(reason)))))
                : List.of();
    }

    /** A command that a boat has, and whom it concerns. */
    private static final class Sent {
        private final Activation activation;
        private final HandlerContext context;
        private final Move move;
        private int remembered;

        Sent(Activation activation, HandlerContext context, Move move) {
            this.activation = activation;
            this.context = context;
            this.move = move;
            remembered = move.command() instanceof FollowPath path ? path.startIndex() : 0;
        }

        List<Input> progress(int visited) {
            if (visited <= remembered || move.progressKey().isEmpty()) {
                return List.of();
            }
            remembered = visited;
            return List.of(PathProgress.remember(
                    activation.mission(), move.progressKey().get(), visited));
        }

        List<Input> completed() {
            List<Input> inputs = new ArrayList<>();
            if (move.command() instanceof FollowPath path) {
                inputs.addAll(progress(path.points().size()));
            }
            if (move.answered()) {
                inputs.add(
                        new Input.Received(move.addressee().answer(EventNames.PATH_COMPLETED, activation, Map.of())));
            }
            return inputs;
        }

        boolean isAwaited() {
            return context.query(
                    view -> view.openActivations().stream().anyMatch(open -> open.id() == activation.id()));
        }

        void post(List<Input> inputs) {
            if (!inputs.isEmpty()) {
                context.post(inputs);
            }
        }
    }
}
