package org.sami.crw.operator;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import org.sami.crw.decision.BoatFilter;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Priority;

/**
 * What lies before the operator: decisions, messages and the count of clicks, fed by a host and by handlers. The models belong
 * to the thread of one executor; everything reaches them by one hop to it, at this border and nowhere else.
 */
public final class OperatorModels implements HostListener, MessageSink {
    private static final int MESSAGES_KEPT = 1000;

    private final Executor owner;
    private final DecisionQueue decisions = new DecisionQueue();
    private final MessageList messages = new MessageList(MESSAGES_KEPT);
    private final ClickCount clicks = new ClickCount();

    /** A desk whose models belong to that executor's one thread; {@code Runnable::run} where there is only one. */
    public OperatorModels(Executor owner) {
        this.owner = owner;
    }

    /** Decisions that wait. Only for the owning thread, as are the other models. */
    public DecisionQueue decisions() {
        return decisions;
    }

    /** Messages to the operator. */
    public MessageList messages() {
        return messages;
    }

    /** The operator's clicks. */
    public ClickCount clicks() {
        return clicks;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        List<Effect> interesting = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.DecisionOpened opened) {
                interesting.add(new Effect.DecisionOpened(BoatFilter.narrowed(opened.decision(), view)));
            } else if (effect instanceof Effect.DecisionClosed
                    || (effect instanceof Effect.Noted noted && concernsOperator(noted))) {
                interesting.add(effect);
            }
        }
        if (!interesting.isEmpty() || !(input instanceof Input.Received)) {
            owner.execute(() -> take(atMillis, input, interesting));
        }
    }

    /** Lays decisions that are open already on the desk: those of a state that was restored. */
    public void restore(EngineView view, long atMillis) {
        List<Effect> opened = new ArrayList<>();
        view.decisions()
                .forEach(decision -> opened.add(new Effect.DecisionOpened(BoatFilter.narrowed(decision, view))));
        owner.execute(() -> take(atMillis, new Input.TimeReached(), opened));
    }

    @Override
    public void tell(OperatorMessage message) {
        owner.execute(() -> messages.add(message));
    }

    private void take(long atMillis, Input input, List<Effect> effects) {
        clicks.count(input, effects);
        for (Effect effect : effects) {
            decisions.apply(effect, atMillis);
            if (effect instanceof Effect.Noted noted) {
                messages.add(messageOf(noted, atMillis));
            }
        }
    }

    /** News of a boat that no plan waits for is no news to the operator either: the journal has it. */
    private static boolean concernsOperator(Effect.Noted noted) {
        return noted.kind() != NoteKind.DISCARDED || noted.mission() != Ids.NONE;
    }

    private static OperatorMessage messageOf(Effect.Noted noted, long atMillis) {
        return new OperatorMessage(
                atMillis,
                noted.mission(),
                OperatorMessage.Source.ENGINE,
                priorityOf(noted.kind()),
                noted.message(),
                List.of(),
                "");
    }

    /** What stops a mission is critical; what the operator asked for and did not get is high. */
    private static Priority priorityOf(NoteKind kind) {
        return switch (kind) {
            case LIVELOCK -> Priority.CRITICAL;
            case HANDLER_FAILED, INTERRUPT_REFUSED, NOT_RETURNED, NO_AUTOMATIC_ANSWER -> Priority.HIGH;
            case REJECTED_INPUT, NAMES_NOBODY, SHORT_OF_TOKENS, GLOBAL_KEPT -> Priority.MEDIUM;
            case DISCARDED, LATE -> Priority.LOW;
        };
    }
}
