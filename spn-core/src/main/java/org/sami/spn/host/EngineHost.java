package org.sami.spn.host;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.vocabulary.EventFlag;

/**
 * Hosts one engine: gives it a thread, a clock, a journal, listeners and handlers (decision 0030, docs/threads.md).
 *
 * <p>Inputs are posted from any thread. On the injected serial executor the host takes all that wait as one batch, steps
 * the engine through them, makes the batch durable, and only then lets out what followed, in order: for each input first
 * the reply to who posted it, then the listeners, then the handlers of its activations. A fault of the engine stops the host with nothing let out of that
 * batch. While the journal cannot be written, such as on a full disk, the host waits with the batch and with all that is
 * posted, tries again every second, and goes on where it waited; a journal that is not {@linkplain
 * InputJournal#isRecoverable recoverable} stops it (decision 0391).
 *
 * <p>The state is guarded by one fair lock, held from a batch's first step until its last effect has left: a query never
 * sees inputs that are not durable, except while the host waits for its journal; and nobody needs another executor's help
 * to ask. All methods may be called from any thread.
 */
public final class EngineHost implements AutoCloseable, HandlerSupport {
    private static final System.Logger LOG = System.getLogger(EngineHost.class.getName());

    private final JournaledEngine engine;
    private final EngineView view;
    private final HostClock clock;
    private final Executor executor;
    private final int batchLimit;
    private final JournalRetryPolicy retries;

    private final ReentrantLock lock = new ReentrantLock(true);
    private final InputQueue queue = new InputQueue();
    private final ListenerList<HostListener> listeners;
    private final HostLifecycle lifecycle;
    private final Handlers handlers;
    private final AwaitedTelemetry awaited;
    private final NextTimer timer;
    private final AtomicBoolean scheduled = new AtomicBoolean();
    private final HostCounts counts = new HostCounts();
    private volatile boolean closing;
    private volatile @Nullable Thread engineThread;
    private volatile boolean retryDue;
    private volatile boolean checkDue;
    private boolean again;
    private boolean toBeResumed; // for who holds the lock

    EngineHost(EngineFunction function, InputJournal journal, HostClock clock, Executor executor, HostLimits limits) {
        this.engine = new JournaledEngine(function, journal, clock);
        this.view = engine.view();
        this.clock = clock;
        this.executor = executor;
        this.batchLimit = limits.batchLimit();
        this.retries = new JournalRetryPolicy(limits.journalRetryMillis());
        this.listeners = new ListenerList<>("the engine", limits.slowListenerMillis());
        this.lifecycle = new HostLifecycle(listeners);
        this.handlers = new Handlers(function.vocabulary(), this);
        this.awaited = new AwaitedTelemetry(function.vocabulary());
        this.timer = new NextTimer(clock, () -> post(new Input.TimeReached()));
        awaited.look(view);
    }

    /**
     * Takes in inputs as one batch: nothing comes between them, they become durable together. Inputs of one thread are
     * processed in the order in which it posts them.
     *
     * @return false if the host has stopped: they are counted and let go
     */
    @Override
    public boolean post(List<Input> inputs) {
        return enqueue(inputs.stream().map(QueuedInput::of).toList());
    }

    private boolean enqueue(List<QueuedInput> posting) {
        if (posting.isEmpty()) {
            return true;
        }
        if (lifecycle.isWaiting() && queue.queued() + posting.size() > retries.inputs()) {
            fail(lifecycle.status().failed("more than " + retries.inputs() + " inputs wait for it"), null);
        }
        if (closing) {
            counts.refused(posting.size());
            return false;
        }
        queue.add(posting);
        schedule();
        return true;
    }

    /** Takes in one input. */
    public boolean post(Input input) {
        return enqueue(List.of(QueuedInput.of(input)));
    }

    /**
     * Takes in one input, and gives what follows from it to the reply.
     *
     * @return false if the host has stopped: the reply is never called
     */
    public boolean post(Input input, InputReply reply) {
        return enqueue(List.of(new QueuedInput(input, Objects.requireNonNull(reply, "reply"))));
    }

    /**
     * Takes in telemetry, which is no input unless a transition waits for it: at most the latest per type and named
     * robots waits to be processed, and where no transition waits for the type nothing happens. News whose type is not
     * marked {@link EventFlag#COALESCE} is posted like any other input.
     */
    public void postIfAwaited(Occurrence news) {
        if (!awaited.isTelemetry(news.type())) {
            post(List.of(new Input.Received(news)));
        } else if (!closing && awaited.isAwaited(news.type())) {
            queue.addTelemetry(news);
            schedule();
        }
    }

    /** Adds a listener; it hears of inputs that are processed from now on. */
    public Registration addListener(HostListener listener) {
        return listeners.add(listener);
    }

    /**
     * Registers the handler of an output event type, by its name or an alias.
     *
     * @param executor where it is called; may be shared, need not be serial
     * @throws IllegalStateException if the type has a handler already
     */
    public Registration register(String eventType, ActivationHandler handler, Executor executor) {
        return handlers.register(eventType, handler, executor);
    }

    /**
     * Asks about the state, at once on the thread that runs the engine, else on the engine's executor. What the question
     * throws completes the future.
     */
    public <T> CompletableFuture<T> query(Function<EngineView, T> question) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        Runnable asking = () -> {
            try {
                answer.complete(ask(question));
            } catch (RuntimeException | Error fault) {
                answer.completeExceptionally(fault);
            }
        };
        if (Thread.currentThread() == engineThread) {
            asking.run();
        } else {
            try {
                executor.execute(asking);
            } catch (RejectedExecutionException stopped) {
                answer.completeExceptionally(stopped);
            }
        }
        return answer;
    }

    /**
     * Asks about the state and waits for the answer: at most until the batch that is being processed has left. Needs no
     * other executor, so that handlers may ask on any thread. Not for the event thread of a window, and not while
     * holding a lock that a listener takes.
     */
    @Override
    public <T> T ask(Function<EngineView, T> question) {
        lock.lock();
        try {
            return question.apply(view);
        } finally {
            release();
        }
    }

    /**
     * The whole state with the index of the last input in it, for an engine elsewhere that goes on from there with the inputs that listeners hear of.
     * Waits as {@link #ask} does.
     *
     * @throws IllegalStateException in words, while the journal is waited for: the state has inputs then that nobody has heard of
     */
    public HostState capture() {
        lock.lock();
        try {
            if (engine.undurable() > 0) {
                throw new IllegalStateException("the session waits for its journal");
            }
            return new HostState(engine.lastIndex(), engine.encode());
        } finally {
            release();
        }
    }

    /**
     * Goes on with a state that was restored: delivers the open activations again, in order of id, and arms the timers.
     * Called once, after handlers and listeners were registered and before the first posting.
     */
    public void resume() {
        lock.lock();
        try {
            if (!lifecycle.isRunning()) {
                return;
            }
            engine.sync();
            deliverOpen();
        } catch (IOException fault) {
            toBeResumed = true;
            journalFailed(fault);
        } finally {
            release();
        }
    }

    private void deliverOpen() {
        toBeResumed = false;
        awaited.look(view);
        List<Activation> open = view.openActivations();
        open.forEach(activation -> handlers.deliver(activation, Handlers.Delivery.AFTER_CRASH));
        timer.arm(view.nextDueMillis());
    }

    /** Has it look, on the engine's executor, whether its journal can still be written where it writes by itself: telemetry in addition to the inputs. */
    public void checkJournal() {
        checkDue = true;
        schedule();
    }

    private void check() {
        checkDue = false;
        try {
            if (lifecycle.isRunning()) {
                engine.check();
            }
        } catch (IOException fault) {
            journalFailed(fault);
        }
    }

    /**
     * Delivers an open activation to its handler again, by somebody's order ({@link HandlerContext#orderedAgain}); one whose visit has ended is not. For what
     * has failed of it.
     */
    public void redeliver(long activation) {
        lock.lock();
        try {
            view.activation(activation).ifPresent(open -> handlers.deliver(open, Handlers.Delivery.ORDERED_AGAIN));
        } finally {
            release();
        }
    }

    /** The session's time. */
    @Override
    public long nowMillis() {
        return clock.nowMillis();
    }

    /** Whether it works, and why not. */
    public HostStatus status() {
        return lifecycle.status();
    }

    /** What it has to do and did. */
    public HostLoad load() {
        return counts.load(queue, listeners);
    }

    /**
     * Ends in order: takes nothing more in, processes what was taken in on the calling thread, makes the journal survive
     * the loss of power. What was given to the host (executors, journal, clock) is closed by its maker. Called by
     * a listener, it takes effect after the batch that the listener hears of.
     */
    @Override
    public void close() {
        closing = true;
        if (lock.isHeldByCurrentThread()) {
            return;
        }
        lock.lock();
        try {
            finishClosing();
        } finally {
            lock.unlock();
        }
    }

    private void finishClosing() {
        if (lifecycle.isWaiting()) {
            retry();
        }
        if (lifecycle.isWaiting()) {
            long lost = engine.undurable() + queue.queued();
            fail(lifecycle.status().failed("the last " + lost + " inputs are not in it"), null);
        }
        while (lifecycle.isRunning() && !queue.isEmpty()) {
            processBatch();
        }
        if (!lifecycle.isRunning()) {
            return;
        }
        timer.arm(OptionalLong.empty());
        try {
            engine.sync();
            lifecycle.closed();
        } catch (IOException fault) {
            fail(JournalRetryPolicy.status(HostStatus.Kind.FAILED, fault), fault);
        }
    }

    private void schedule() {
        if (scheduled.compareAndSet(false, true)) {
            handOver();
        }
    }

    private void handOver() {
        try {
            executor.execute(this::drain);
        } catch (RejectedExecutionException stopped) {
            closing = true;
            scheduled.set(false);
            counts.refused(queue.clear());
            LOG.log(Level.ERROR, "the engine's executor takes no more work: the host takes nothing in any longer");
        }
    }

    /** One batch; the next is handed to the executor again, so that others who use it get their turn. */
    private void drain() {
        if (lock.isHeldByCurrentThread()) {
            again = true; // the executor runs at once: the caller that holds the lock continues, further up the stack
            return;
        }
        lock.lock();
        try {
            engineThread = Thread.currentThread();
            do {
                again = false;
                processBatch();
                if (closing) {
                    finishClosing();
                }
                scheduled.set(false);
                if (retryDue || checkDue || (lifecycle.isRunning() && !queue.isEmpty())) {
                    schedule();
                }
            } while (again);
        } finally {
            release();
        }
    }

    private void release() {
        boolean postponed = again && lock.getHoldCount() == 1;
        if (postponed) {
            again = false;
        }
        lock.unlock();
        if (postponed) {
            handOver();
        }
    }

    private void processBatch() {
        if (retryDue) {
            retryDue = false;
            retry();
        }
        if (!lifecycle.status().isAlive()) {
            counts.refused(queue.clear());
        }
        if (checkDue) {
            check();
        }
        if (!lifecycle.isRunning()) {
            return;
        }
        List<QueuedInput> inputs = queue.take(batchLimit);
        inputs.addAll(queue.takeTelemetry(view::awaits));
        if (inputs.isEmpty()) {
            return;
        }
        try {
            List<Step> steps = engine.step(inputs);
            counts.processed(steps.size());
            goOn(steps);
        } catch (IOException fault) {
            journalFailed(fault);
        } catch (RuntimeException | Error fault) {
            fail(met("at entry " + (engine.lastIndex() + 1) + " or after", fault), fault);
        }
    }

    /** What becomes of a batch that is durable. */
    private void goOn(List<Step> steps) throws IOException {
        awaited.look(view);
        steps.forEach(step -> step.letOut(listeners, handlers, view));
        engine.offerSnapshot();
        timer.arm(view.nextDueMillis());
    }

    private void journalFailed(IOException fault) {
        long now = clock.nowMillis();
        HostStatus next = retries.after(fault, engine.isRecoverable(), now);
        if (next.kind() == HostStatus.Kind.FAILED) {
            fail(next, fault);
            return;
        }
        timer.arm(OptionalLong.empty());
        lifecycle.waits(next, fault);
        clock.wakeAt(now + JournalRetryPolicy.RETRY_MILLIS, () -> {
            retryDue = true;
            schedule();
        });
    }

    /** Looks whether the journal can be written again, and goes on if it can. */
    private void retry() {
        if (!lifecycle.isWaiting()) {
            return;
        }
        try {
            List<Step> steps = engine.recover();
            if (lifecycle.goesOn()) {
                retries.recovered();
                if (toBeResumed) {
                    deliverOpen();
                }
                goOn(steps);
            }
        } catch (IOException fault) {
            journalFailed(fault);
        } catch (RuntimeException | Error fault) {
            fail(met("when its journal could be written again", fault), fault);
        }
    }

    /**
     * Stops it at once for a fault that was found elsewhere: nothing more is taken in, and nothing more leaves but what is leaving now. Does nothing where it
     * has stopped. Waits for nobody.
     *
     * @param reason one sentence
     */
    public void fail(String reason) {
        fail(new HostStatus(HostStatus.Kind.FAILED, reason), null);
    }

    private static HostStatus met(String when, Throwable fault) {
        return new HostStatus(HostStatus.Kind.FAILED, "the engine met an error", when + ": " + fault);
    }

    private void fail(HostStatus failed, @Nullable Throwable fault) {
        closing = true;
        counts.refused(queue.clear());
        lifecycle.failed(failed, fault);
    }
}
