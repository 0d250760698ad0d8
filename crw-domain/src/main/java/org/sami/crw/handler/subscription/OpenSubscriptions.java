package org.sami.crw.handler.subscription;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/**
 * The open subscriptions of one kind, by activation; those of an ended activation are dropped. For the fleet's thread; it passes the engine's steps
 * on to it.
 *
 * @param <S> the state of a subscription
 */
final class OpenSubscriptions<S> implements HostListener {
    private final Executor fleet;
    private final Predicate<S> isOver;
    private final Map<Long, S> open = new LinkedHashMap<>();

    /**
     * Without subscriptions.
     *
     * @param isOver whether a subscription has no boat left
     */
    OpenSubscriptions(Executor fleet, Predicate<S> isOver) {
        this.fleet = fleet;
        this.isOver = isOver;
    }

    void add(long activation, S subscription) {
        open.put(activation, subscription);
    }

    Stream<S> stream() {
        return open.values().stream();
    }

    /** Gives news to each, and drops those that are over then. */
    void tell(Consumer<S> news) {
        for (Iterator<S> all = open.values().iterator(); all.hasNext(); ) {
            S subscription = all.next();
            news.accept(subscription);
            if (isOver.test(subscription)) {
                all.remove();
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        List<Long> ended = new ArrayList<>();
        for (Effect effect : effects) {
            if (effect instanceof Effect.ActivationEnded over) {
                ended.add(over.activation());
            }
        }
        if (!ended.isEmpty()) {
            fleet.execute(() -> ended.forEach(open::remove));
        }
    }
}
