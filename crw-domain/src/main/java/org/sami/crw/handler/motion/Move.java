package org.sami.crw.handler.motion;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.handler.activation.Addressee;
import org.sami.crw.handler.activation.CommandMemory;
import org.sami.crw.handler.boat.SentLists;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.FollowPath;
import org.sami.crw.service.reach.WayDoubt;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoPoint;

/**
 * A command for one boat, from an activation.
 *
 * @param progress how the mission remembers visited points; empty = it does not
 * @param reply the answers on completion and failure
 * @param doubt a problem other than its way, found by other checks
 * @param wayFromHere its way, where that follows from where the boat is: the command has none until the boat has said it. Empty where the command has it
 */
public record Move(
        Addressee addressee,
        BoatCommand command,
        Optional<PathProgress.Along> progress,
        Reply reply,
        Optional<WayDoubt> doubt,
        Optional<WayFromHere> wayFromHere) {
    /** Chooses a way, from where the boat is; without points there is nothing to drive. */
    @FunctionalInterface
    interface WayFromHere {
        List<GeoPoint> from(GeoPoint here);
    }

    /** A command with which nothing is wrong but maybe its way. */
    public Move(Addressee addressee, BoatCommand command, Optional<PathProgress.Along> progress, Reply reply) {
        this(addressee, command, progress, reply, Optional.empty(), Optional.empty());
    }

    public Move {
        Objects.requireNonNull(doubt, "doubt");
        Objects.requireNonNull(addressee, "addressee");
        Objects.requireNonNull(command, "command");
        Objects.requireNonNull(progress, "progress");
        Objects.requireNonNull(reply, "reply");
        Objects.requireNonNull(wayFromHere, "wayFromHere");
    }

    /** The same with the command changed. */
    Move with(BoatCommand other) {
        return new Move(addressee, other, progress, reply, doubt, wayFromHere);
    }

    /** The same for those that it is left for. */
    Move with(Addressee other) {
        return new Move(other, command, progress, reply, doubt, wayFromHere);
    }

    /** A move whose way follows from where the boat is. */
    static Move fromHere(Activation activation, Addressee addressee, WayFromHere way) {
        return new Move(
                addressee,
                pathOf(activation, addressee, List.of()),
                Optional.empty(),
                Reply.WAY,
                Optional.empty(),
                Optional.of(way));
    }

    /** The same with its way, for a boat that is here. */
    Move from(GeoPoint here, Activation activation) {
        return wayFromHere
                .map(way -> new Move(
                        addressee,
                        pathOf(activation, addressee, way.from(here)),
                        progress,
                        reply,
                        doubt,
                        Optional.empty()))
                .orElse(this);
    }

    /** The command to go to points, one after the other. */
    static FollowPath pathOf(Activation activation, Addressee addressee, List<GeoPoint> points) {
        return FollowPath.of(
                commandId(activation, addressee), activation.mission(), activation.id(), points, activation.priority());
    }

    /** The same, about which the operator is to be asked. */
    public Move doubted(WayDoubt other) {
        return new Move(addressee, command, progress, reply, Optional.of(other), wayFromHere);
    }

    /** What the mission remembers of its command; empty where it remembers nothing. */
    Optional<CommandMemory> remembered(Activation activation, HandlerContext context) {
        return CommandMemory.of(activation.mission(), command.commandId(), context)
                .or(() -> tookItsList(context));
    }

    /** Of an earlier version's command the session knows whether the boat took its list last. */
    private Optional<CommandMemory> tookItsList(HandlerContext context) {
        return context.query(view -> SentLists.isOf(command.commandId(), addressee.boat(), view))
                ? Optional.of(CommandMemory.SENT)
                : Optional.empty();
    }

    /** Whether its activation is delivered again after a restart of the base, and its command has had its result already: then it is not sent. */
    public boolean isOver(Activation activation, HandlerContext context) {
        return CommandMemory.isOver(activation, command.commandId(), context);
    }

    /** Has the mission remember this of its command. */
    List<Input> remember(CommandMemory what, Activation activation, HandlerContext context) {
        return what.remember(activation.mission(), command.commandId(), context);
    }

    /** The command's id: the same whenever the activation is delivered, and no other's. */
    public static String commandId(Activation activation, Addressee addressee) {
        return CommandMemory.id(activation, addressee.boat());
    }

    /**
     * Why the command that an activation gave to a boat failed, as the mission remembers it and its plan was told; empty where it did not fail, or was ordered
     * again.
     */
    public static Optional<String> failure(Activation activation, String boat, EngineView view) {
        return CommandMemory.failure(activation.mission(), CommandMemory.id(activation, boat), view);
    }

    /**
     * Whether the mission can keep a boat for itself: not where it has ended already, when its end place asks for it, as nothing would
     * ever give the boat back.
     */
    static boolean mayBlock(Activation activation, HandlerContext context) {
        return context.query(view -> view.mission(activation.mission()).isPresent());
    }
}
