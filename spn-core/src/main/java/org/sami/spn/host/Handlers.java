package org.sami.spn.host;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Function;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Brings activations to the handlers of their types, each on the executor that it was registered with. What a handler
 * throws, and an activation that nothing handles, becomes an input: no event that nothing handles.
 */
final class Handlers {
    private static final System.Logger LOG = System.getLogger(Handlers.class.getName());

    private final Map<String, Entry> byType = new ConcurrentHashMap<>();
    private final Vocabulary vocabulary;
    private final HandlerSupport host;

    Handlers(Vocabulary vocabulary, HandlerSupport host) {
        this.vocabulary = vocabulary;
        this.host = host;
    }

    Registration register(String eventType, ActivationHandler handler, Executor executor) {
        String type = canonical(eventType);
        Entry entry =
                new Entry(Objects.requireNonNull(handler, "handler"), Objects.requireNonNull(executor, "executor"));
        if (byType.putIfAbsent(type, entry) != null) {
            throw new IllegalStateException(type + " has a handler already");
        }
        return () -> byType.remove(type, entry);
    }

    /** Why an activation is delivered. */
    enum Delivery {
        FIRST,
        AFTER_CRASH,
        ORDERED_AGAIN
    }

    void deliver(Activation activation, Delivery delivery) {
        Entry entry = byType.get(canonical(activation.type()));
        if (entry != null) {
            dispatch(entry, activation, delivery);
        } else if (needsHandler(activation)) {
            failed(activation, "nothing handles " + activation.type());
        }
    }

    private void dispatch(Entry entry, Activation activation, Delivery delivery) {
        try {
            entry.executor.execute(() -> run(entry.handler, activation, delivery));
        } catch (RejectedExecutionException refused) {
            LOG.log(Level.WARNING, "the executor of " + activation.type() + " refused activation " + activation.id());
            failed(activation, "the handler of " + activation.type() + " takes no more work");
        }
    }

    private void run(ActivationHandler handler, Activation activation, Delivery delivery) {
        try {
            handler.handle(activation, new Context(delivery));
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            failed(activation, "its handler was interrupted");
        } catch (Exception | LinkageError | StackOverflowError | AssertionError fault) {
            LOG.log(Level.WARNING, "the handler of " + activation.type() + " failed: " + reason(fault), fault);
            failed(activation, reason(fault));
        }
    }

    private void failed(Activation activation, String reason) {
        host.post(List.of(new Input.HandlerFailed(activation.id(), reason)));
    }

    private boolean needsHandler(Activation activation) {
        Optional<EventType> type = vocabulary.event(activation.type());
        if (type.isEmpty()) {
            return true;
        }
        EventType known = type.get();
        boolean asksNobody = known.answers().isEmpty() && !known.flags().contains(EventFlag.COMMAND);
        return known.decision().isEmpty() && known.role() == EventRole.NONE && !asksNobody;
    }

    private String canonical(String eventType) {
        return vocabulary.event(eventType).map(EventType::name).orElse(eventType);
    }

    private static String reason(Throwable fault) {
        String message = fault.getMessage();
        return message == null || message.isBlank() ? fault.getClass().getSimpleName() : message;
    }

    private record Entry(ActivationHandler handler, Executor executor) {}

    private final class Context implements HandlerContext {
        private final Delivery delivery;

        Context(Delivery delivery) {
            this.delivery = delivery;
        }

        @Override
        public void post(List<Input> inputs) {
            host.post(inputs);
        }

        @Override
        public <T> T query(Function<EngineView, T> question) {
            return host.ask(question);
        }

        @Override
        public long nowMillis() {
            return host.nowMillis();
        }

        @Override
        public boolean redelivered() {
            return delivery != Delivery.FIRST;
        }

        @Override
        public boolean orderedAgain() {
            return delivery == Delivery.ORDERED_AGAIN;
        }
    }
}
