package org.sami.crw.handler.activation;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/**
 * What a mission remembers of a command that an activation gave to a boat, across restarts of the base: activations stay open after their commands are
 * over, and are delivered again (decision 0731). Journals from before 2026-11-30 lack it. From any thread.
 */
public enum CommandMemory {
    /** It went into the boat's queue: its way was checked, or the operator wanted it. */
    SENT("sent"),
    /** The boat has done it. */
    COMPLETED("completed"),
    /** It ended without that: it failed, was refused, or was taken back. */
    ENDED("ended"),
    /** It was over, and somebody ordered it again: it is not in the boat's queue yet. */
    ORDERED_AGAIN("ordered again");

    private static final String KEY = "command/";
    private static final String REASON = ": "; // after the word, before the reason or the other command

    private final String word;

    CommandMemory(String word) {
        this.word = word;
    }

    /** The id of an activation's command for a boat: the same whenever the activation is delivered, and no other's. */
    public static String id(Activation activation, String boat) {
        return "m" + activation.mission() + "-a" + activation.id() + "-" + boat;
    }

    /** What the mission remembers of a command; empty where it remembers nothing. */
    public static Optional<CommandMemory> of(long mission, String commandId, HandlerContext context) {
        return context.query(view -> view.memory(mission, KEY + commandId).flatMap(CommandMemory::read));
    }

    private static Optional<CommandMemory> read(Value remembered) {
        return Arrays.stream(values())
                .filter(one -> remembered instanceof TextValue text
                        && (text.value().equals(one.word) || text.value().startsWith(one.word + REASON)))
                .findFirst();
    }

    /** Why a command failed, as its plan was told; empty where it did not fail. */
    public static Optional<String> failure(long mission, String commandId, EngineView view) {
        return detail(ENDED, mission, commandId, view);
    }

    private static Optional<String> detail(CommandMemory what, long mission, String commandId, EngineView view) {
        String before = what.word + REASON;
        return view.memory(mission, KEY + commandId)
                .filter(TextValue.class::isInstance)
                .map(remembered -> ((TextValue) remembered).value())
                .filter(text -> text.startsWith(before))
                .map(text -> text.substring(before.length()));
    }

    /** Whether an activation is delivered again after a restart of the base, and its command has had its result already: then it is not sent. */
    public static boolean isOver(Activation activation, String commandId, HandlerContext context) {
        return context.redelivered()
                && !context.orderedAgain()
                && of(activation.mission(), commandId, context)
                        .filter(CommandMemory::isOver)
                        .isPresent();
    }

    /** Has the mission remember that somebody ordered a command again that was over; nothing where it was not, or nobody did. */
    public static List<Input> ordered(Activation activation, String commandId, HandlerContext context) {
        long mission = activation.mission();
        boolean again = context.orderedAgain()
                && of(mission, commandId, context).filter(CommandMemory::isOver).isPresent();
        return again ? ORDERED_AGAIN.remember(mission, commandId, context) : List.of();
    }

    /** The command of another activation that was sent to the boat once more; empty where none is remembered. */
    public static Optional<String> sentAgain(long mission, String id, HandlerContext context) {
        return context.query(view -> detail(SENT, mission, id, view));
    }

    /** Has the mission remember that the command of another activation was sent to the boat once more. */
    public static List<Input> sentAgain(long mission, String id, String commandId, HandlerContext context) {
        return remember(mission, id, SENT.word + REASON + commandId, context);
    }

    /** Has the mission remember that a command failed, and why. */
    public static List<Input> failed(long mission, String commandId, String reason, HandlerContext context) {
        return remember(mission, commandId, ENDED.word + REASON + reason, context);
    }

    /** Whether the command has had its result. */
    public boolean isOver() {
        return this == COMPLETED || this == ENDED;
    }

    /** Has the mission remember this of a command; nothing where the mission is over, as nothing is delivered again then. */
    public List<Input> remember(long mission, String commandId, HandlerContext context) {
        return remember(mission, commandId, word, context);
    }

    private static List<Input> remember(long mission, String commandId, String text, HandlerContext context) {
        return context.query(view -> view.mission(mission).isPresent())
                ? List.of(new Input.Remember(mission, KEY + commandId, new TextValue(text)))
                : List.of();
    }
}
