package org.sami.crw.session;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import org.sami.session.api.RefusedException;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostStatus;
import org.sami.spn.host.InputReply;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;

/**
 * Posts inputs of callers who wait for the result, which arrives after the listeners that were added before this one. Safe for use by several threads;
 * listens on the engine's.
 */
final class PostedInputs implements HostListener {
    private static final Set<NoteKind> REFUSALS = Set.of(NoteKind.REJECTED_INPUT, NoteKind.INTERRUPT_REFUSED);

    private final EngineHost host;
    private final Replies replies;
    private final AtomicLong posted = new AtomicLong();
    private final Map<Long, Replies.Reply<?>> waiting = new ConcurrentHashMap<>();
    private final List<Runnable> arrivals = new ArrayList<>(); // of the present step; for the engine's thread

    PostedInputs(EngineHost host, Replies replies) {
        this.host = host;
        this.replies = replies;
    }

    /** Posts an input; the stage fails, saying why, if the engine refuses it. */
    <T> CompletionStage<T> post(Input input, Function<List<Effect>, T> result) {
        return post(input, InputReply.NONE, result);
    }

    /**
     * Posts an input; the stage fails, saying why, if the engine refuses it.
     *
     * @param first what is to be done before any listener hears of the step
     */
    <T> CompletionStage<T> post(Input input, InputReply first, Function<List<Effect>, T> result) {
        Replies.Reply<T> reply = replies.open();
        HostStatus status = host.status();
        if (status.kind() == HostStatus.Kind.WAITING) { // whoever pressed a button does not wish it minutes later
            reply.fail(new RefusedException("nothing is taken in now: " + status.reason()));
            return reply.stage();
        }
        long number = posted.incrementAndGet();
        waiting.put(number, reply);
        boolean taken = host.post(input, effects -> {
            waiting.remove(number);
            arrivals.add(() -> settle(reply, effects, result));
            first.onProcessed(effects);
        });
        if (!taken) {
            waiting.remove(number);
            reply.fail(new RefusedException(
                    "the session takes nothing in: " + host.status().reason()));
        }
        return reply.stage();
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        List<Runnable> all = List.copyOf(arrivals);
        arrivals.clear();
        all.forEach(Runnable::run);
    }

    private static <T> void settle(Replies.Reply<T> reply, List<Effect> effects, Function<List<Effect>, T> result) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Noted noted && REFUSALS.contains(noted.kind())) {
                reply.fail(new RefusedException(noted.message()));
                return;
            }
        }
        try {
            reply.complete(result.apply(effects));
        } catch (RuntimeException fault) {
            reply.fail(fault);
        }
    }

    @Override
    public void onFailed(HostStatus status) {
        waiting.values().forEach(reply -> reply.fail(new RefusedException("the session stopped: " + status.whole())));
        waiting.clear();
    }
}
