package org.sami.crw.session;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.host.HostStatus;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;

/** Posts inputs of callers who wish to know what came of them. Safe for use by several threads; listens on the engine's. */
final class PostedInputs implements HostListener {
    private static final Set<NoteKind> REFUSALS = Set.of(NoteKind.REJECTED_INPUT, NoteKind.INTERRUPT_REFUSED);

    private final EngineHost host;
    private final Replies replies;
    // never gone through: equal inputs are two
    private final IdentityHashMap<Input, Waiting<?>> waiting = new IdentityHashMap<>();

    PostedInputs(EngineHost host, Replies replies) {
        this.host = host;
        this.replies = replies;
    }

    private record Waiting<T>(Replies.Reply<T> reply, Function<List<Effect>, T> result) {}

    /** Posts an input; the stage fails, saying why, if the engine refuses it. */
    <T> CompletionStage<T> post(Input input, Function<List<Effect>, T> result) {
        Replies.Reply<T> reply = replies.open();
        HostStatus status = host.status();
        if (status.kind() == HostStatus.Kind.WAITING) { // whoever pressed a button does not wish it minutes later
            reply.fail(new RefusedException("nothing is taken in now: " + status.reason()));
            return reply.stage();
        }
        synchronized (waiting) {
            waiting.put(input, new Waiting<>(reply, result));
        }
        if (!host.post(input)) {
            take(input);
            reply.fail(new RefusedException(
                    "the session takes nothing in: " + host.status().reason()));
        }
        return reply.stage();
    }

    private Waiting<?> take(Input input) {
        synchronized (waiting) {
            return waiting.remove(input);
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        Waiting<?> caller = take(input);
        if (caller != null) {
            settle(caller, effects);
        }
    }

    private <T> void settle(Waiting<T> caller, List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.Noted noted && REFUSALS.contains(noted.kind())) {
                caller.reply.fail(new RefusedException(noted.message()));
                return;
            }
        }
        try {
            caller.reply.complete(caller.result.apply(effects));
        } catch (RuntimeException fault) {
            caller.reply.fail(fault);
        }
    }

    @Override
    public void onFailed(HostStatus status) {
        List<Waiting<?>> all;
        synchronized (waiting) {
            all = new ArrayList<>(waiting.values());
            waiting.clear();
        }
        all.forEach(caller -> caller.reply.fail(new RefusedException("the session stopped: " + status.whole())));
    }
}
