package org.sami.crw.handler.planning;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sami.crw.handler.activation.ActivationMessages;
import org.sami.crw.handler.motion.LaterMoves;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.message.MessageSink;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.HandlerContext;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/**
 * What services compute for activations (docs/services.md). In a session in real time they compute on threads of their own, and what
 * they found comes back to the fleet's thread; a message says when it takes long, and a computation is given up when its activation
 * ends or its time is over. Under a virtual clock, time stands still meanwhile: it is computed on the spot, in the order in which the
 * activations are delivered.
 *
 * <p>Computations begin, and what follows them happens, on the fleet's thread.
 */
public final class Computations implements HostListener, LaterMoves {
    private final Executor fleet;
    private final MessageSink messages;
    private final Optional<ServiceThreads> threads;
    private final Map<Long, Running> running = new ConcurrentHashMap<>(); // by activation

    /** What a service computes, and what then becomes of it. */
    public interface Task<A> {
        /** What is computed, for people: "the allocation of 12 locations". */
        String what();

        /** Computes, on any thread; asks neither engine nor boats. */
        A compute() throws Exception;

        /** Goes on with what was found. */
        void found(A answer);

        /** It was given up, or failed: nothing will be found. */
        default void gone() {}

        /** Whether it leads to commands, which can be taken back for boats before they are given. */
        default boolean commandsBoats() {
            return false;
        }
    }

    private static final class Running {
        private final Activation activation;
        private final HandlerContext context;
        private final Task<?> task;
        private final long startNanos = System.nanoTime();
        private volatile @Nullable Future<?> work;
        private volatile @Nullable Future<?> watch;

        Running(Activation activation, HandlerContext context, Task<?> task) {
            this.activation = activation;
            this.context = context;
            this.task = task;
        }

        long millis() {
            return TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - startNanos);
        }

        void giveUp() {
            if (work != null) {
                work.cancel(true);
            }
            if (watch != null) {
                watch.cancel(false);
            }
        }
    }

    public Computations(Executor fleet, MessageSink messages, Optional<ServiceThreads> threads) {
        this.fleet = fleet;
        this.messages = messages;
        this.threads = threads;
    }

    /** Computes for an activation. What the task throws becomes the handler's failure. */
    public <A> void compute(Activation activation, HandlerContext context, Task<A> task) throws Exception {
        if (threads.isEmpty()) {
            task.found(task.compute());
            return;
        }
        Running one = new Running(activation, context, task);
        running.put(activation.id(), one);
        if (!isOpen(activation, context)) {
            running.remove(activation.id());
            task.gone();
            return;
        }
        try {
            one.work = threads.get().start(() -> work(one, task));
            one.watch = threads.get().lookAfter(() -> fleet.execute(() -> look(one)));
            if (!running.containsKey(activation.id())) {
                one.giveUp(); // it was over at once
            }
        } catch (RejectedExecutionException closed) {
            running.remove(activation.id());
            task.gone();
        }
    }

    /** Computes something without a waiting activation, on a service thread if there is one, and continues with the result on the fleet's thread. */
    <A> void aside(Supplier<A> work, Consumer<A> then) {
        if (threads.isPresent()) {
            threads.get().execute(() -> {
                A found = work.get();
                fleet.execute(() -> then.accept(found));
            });
        } else {
            then.accept(work.get());
        }
    }

    /** Whether it is computed while the fleet goes on, so that boats may have left meanwhile. */
    boolean areElsewhere() {
        return threads.isPresent();
    }

    /** Whether something is being computed for a mission; from any thread. */
    public boolean areUnderWay() {
        return !running.isEmpty();
    }

    /** The missions for which something is being computed; from any thread. */
    public Set<Long> missions() {
        return running.values().stream().map(one -> one.activation.mission()).collect(Collectors.toSet());
    }

    @Override
    public Set<Long> missions(String boat) {
        return running.values().stream()
                .filter(one ->
                        one.task.commandsBoats() && one.activation.proxies().contains(boat))
                .map(one -> one.activation.mission())
                .collect(Collectors.toSet());
    }

    /** Gives up all that is being computed: nobody waits for it any longer. */
    public void close() {
        running.values().forEach(Running::giveUp);
        running.clear();
    }

    private static boolean isOpen(Activation activation, HandlerContext context) {
        return context.query(view -> view.openActivations().stream().anyMatch(open -> open.id() == activation.id()));
    }

    @SuppressWarnings("CatchingUnchecked") // an exception of a service is reported to the plan like one of its handler
    private <A> void work(Running one, Task<A> task) {
        Callable<Runnable> outcome = () -> {
            A answer = task.compute();
            return () -> task.found(answer);
        };
        Runnable then;
        try {
            then = outcome.call();
        } catch (Exception | LinkageError | StackOverflowError | AssertionError fault) {
            then = failed(one, task, fault);
        } catch (Error fault) {
            threads.ifPresent(known -> known.fault(fault));
            then = failed(one, task, fault);
        }
        Runnable last = then;
        fleet.execute(() -> end(one, last));
    }

    private static Runnable failed(Running one, Task<?> task, Throwable fault) {
        return () -> {
            task.gone();
            fail(one, fault);
        };
    }

    private void end(Running one, Runnable then) {
        if (one.watch != null) {
            one.watch.cancel(false);
        }
        if (!running.remove(one.activation.id(), one)) {
            return; // given up
        }
        try {
            then.run();
        } catch (RuntimeException fault) {
            fail(one, fault);
        }
    }

    private static void fail(Running one, Throwable fault) {
        String reason = fault instanceof CancellationException
                ? one.task.what() + " was given up after " + one.millis() / 1000 + " s: ask for less at a time"
                : Optional.ofNullable(fault.getMessage())
                        .filter(words -> !words.isBlank())
                        .orElse(fault.getClass().getSimpleName());
        one.context.post(new Input.HandlerFailed(one.activation.id(), reason));
    }

    private void look(Running one) {
        if (!running.containsKey(one.activation.id())) {
            return;
        }
        long limitMillis = threads.orElseThrow().limitMillis();
        if (one.millis() >= limitMillis) {
            if (running.remove(one.activation.id(), one)) {
                one.giveUp();
                one.task.gone();
                fail(one, new CancellationException());
            }
            return;
        }
        messages.tell(ActivationMessages.of(
                one.activation,
                one.context,
                Priority.LOW,
                one.task.what() + " takes long: " + one.millis() / 1000 + " s so far, given up after "
                        + limitMillis / 1000 + " s",
                one.activation.proxies()));
    }

    @Override
    public void withdraw(long mission, List<String> named, Optional<String> why, MotionCommands motion) {
        for (Running one : running.values()) {
            if (one.activation.mission() == mission && one.task.commandsBoats()) {
                motion.takeBack(one.activation.id(), named.isEmpty() ? one.activation.proxies() : named, why);
            }
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.ActivationEnded ended) {
                Optional.ofNullable(running.remove(ended.activation())).ifPresent(one -> {
                    one.giveUp();
                    fleet.execute(one.task::gone);
                });
            }
        }
    }
}
