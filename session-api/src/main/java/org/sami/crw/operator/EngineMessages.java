package org.sami.crw.operator;

import java.util.List;
import java.util.Optional;
import org.sami.crw.message.OperatorMessage;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;

/** Which of the engine's notes are shown to the operator. */
final class EngineMessages {
    private EngineMessages() {}

    /** The message that an effect is; empty where it is none. */
    static Optional<OperatorMessage> of(Effect effect, long atMillis) {
        return effect instanceof Effect.Noted noted && concernsOperator(noted)
                ? Optional.of(new OperatorMessage(
                        atMillis,
                        noted.mission(),
                        OperatorMessage.Source.ENGINE,
                        priorityOf(noted.kind()),
                        noted.message(),
                        List.of(),
                        ""))
                : Optional.empty();
    }

    /** News of a boat that no plan waits for is no news to the operator either: the journal has it. */
    private static boolean concernsOperator(Effect.Noted noted) {
        return noted.kind() != NoteKind.DISCARDED || noted.mission() != Ids.NONE;
    }

    /** What stops a mission is critical; what the operator asked for and did not get is high. */
    private static Priority priorityOf(NoteKind kind) {
        return switch (kind) {
            case LIVELOCK -> Priority.CRITICAL;
            case HANDLER_FAILED, INTERRUPT_REFUSED, NOT_RETURNED, NO_AUTOMATIC_ANSWER -> Priority.HIGH;
            case REJECTED_INPUT, NAMES_NOBODY, SHORT_OF_TOKENS, GLOBAL_KEPT -> Priority.MEDIUM;
            case DISCARDED, LATE, GONE -> Priority.LOW;
        };
    }
}
