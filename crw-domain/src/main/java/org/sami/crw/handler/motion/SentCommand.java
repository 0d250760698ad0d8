package org.sami.crw.handler.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.CommandMemory;
import org.sami.crw.handler.activation.OptionalAnswer;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** A command that a boat has, and whom it concerns. */
final class SentCommand {
    private final Activation activation;
    private final HandlerContext context;
    private Addressee addressee;
    private final Reply reply;
    private final Optional<PathProgress.Along> along;
    private final int points;
    private final Optional<String> id; // under which the mission remembers it
    private int remembered;

    /** A command that an activation gave. */
    SentCommand(Activation activation, HandlerContext context, Move move) {
        this.activation = activation;
        this.context = context;
        addressee = move.addressee();
        reply = move.reply();
        along = move.progress();
        id = Optional.of(move.command().commandId());
        boolean isPath = move.command() instanceof FollowPath;
        points = isPath ? ((FollowPath) move.command()).points().size() : 0;
        remembered = isPath ? ((FollowPath) move.command()).startIndex() : 0;
    }

    /** A command of which the mission remembers nothing. */
    SentCommand(Activation activation, HandlerContext context, Addressee addressee, Reply reply) {
        this(activation, context, addressee, reply, Optional.empty());
    }

    private SentCommand(
            Activation activation, HandlerContext context, Addressee addressee, Reply reply, Optional<String> id) {
        this.activation = activation;
        this.context = context;
        this.addressee = addressee;
        this.reply = reply;
        this.id = id;
        along = Optional.empty();
        points = 0;
    }

    /** A command that another activation gave, of which this one wants to hear too, and of which its mission remembers what became of that wish. */
    static SentCommand again(Activation activation, HandlerContext context, Addressee addressee) {
        return new SentCommand(
                activation,
                context,
                addressee,
                Reply.WAY_IF_AWAITED,
                Optional.of(Move.commandId(activation, addressee)));
    }

    long mission() {
        return activation.mission();
    }

    String boat() {
        return addressee.boat();
    }

    /** How many points of its path are behind the boat, so far as the boat has said. */
    int visited() {
        return remembered;
    }

    /** The boat has these tasks no longer; says whether the command was for them alone. */
    boolean release(List<TaskId> names) {
        Optional<Addressee> left = addressee.without(names);
        left.ifPresent(one -> addressee = one);
        return left.isEmpty();
    }

    /** More of its points are behind the boat. */
    List<Input> progress(int visited) {
        if (visited <= remembered) {
            return List.of();
        }
        remembered = visited;
        if (along.isEmpty()) {
            return List.of();
        }
        return List.of(along.get().remember(activation.mission(), visited));
    }

    List<Input> completed() {
        List<Input> inputs = new ArrayList<>(remember(CommandMemory.COMPLETED));
        inputs.addAll(progress(points));
        reply.completedEvent().ifPresent(event -> inputs.addAll(answer(event, Map.of())));
        return inputs;
    }

    /** Pictures were taken. */
    List<Input> pictures(Map<String, Value> values) {
        return List.of(new Input.Received(addressee.answer(reply.pictures(), activation, values)));
    }

    List<Input> failed(String reason) {
        List<Input> inputs = new ArrayList<>(id.map(one -> CommandMemory.failed(mission(), one, reason, context))
                .orElse(List.of()));
        reply.failedEvent().ifPresent(event -> inputs.addAll(answer(event, Map.of("reason", new TextValue(reason)))));
        return inputs;
    }

    /** It is over, and nobody is answered. */
    List<Input> ended() {
        return remember(CommandMemory.ENDED);
    }

    /** Before the answer, which may end the mission; in one batch with it, so that no restart separates them. */
    private List<Input> remember(CommandMemory what) {
        return id.map(one -> what.remember(mission(), one, context)).orElse(List.of());
    }

    private List<Input> answer(String event, Map<String, Value> values) {
        Occurrence answer = addressee.answer(event, activation, values);
        return reply.ifAwaited() ? OptionalAnswer.of(answer, context) : List.of(new Input.Received(answer));
    }

    /** The message to the operator when it failed. */
    OperatorMessage failure(String reason) {
        return ActivationMessages.of(
                activation,
                context,
                Priority.HIGH,
                boat() + " could not do what \"" + activation.place() + "\" asked: " + reason,
                List.of(boat()));
    }

    /** Whether an answer to it is still waited for. */
    boolean isAwaited() {
        return context.query(view -> view.openActivations().stream().anyMatch(open -> open.id() == activation.id()));
    }

    /** The same, by its own boat: another one may be alone in the place that asked. */
    boolean isAwaitedByItsBoat() {
        return isAwaited() && addressee.stands(activation, context);
    }

    void post(List<Input> inputs) {
        if (!inputs.isEmpty()) {
            context.post(inputs);
        }
    }
}
