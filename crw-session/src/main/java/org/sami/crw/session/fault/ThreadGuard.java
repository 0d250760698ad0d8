package org.sami.crw.session.fault;

import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Priority;

/**
 * Handles uncaught exceptions on a session's threads: it logs them and makes each an entry of the session's health. Where the Java machine itself
 * fails (above all for lack of memory) on a thread that missions need, it stops the session with a message. A stack overflow only ends its own call.
 * The guard never throws. Safe for use by several threads.
 */
public final class ThreadGuard implements Thread.UncaughtExceptionHandler {
    private static final System.Logger LOG = System.getLogger(ThreadGuard.class.getName());
    private static final int RESERVE_BYTES = 4 << 20;
    private static final int DEEPEST_CAUSE = 20;
    private static final String ADVICE =
            "Go on where you can see it work; end the session and open it again when the missions allow it";

    private final Consumer<HealthFault> health;
    private final Consumer<String> stop;
    private final Map<String, Integer> counts = new ConcurrentHashMap<>();
    private final AtomicReference<byte[]> reserve = new AtomicReference<>(new byte[RESERVE_BYTES]);

    /**
     * A guard that has met nothing.
     *
     * @param health receives each fault
     * @param stop stops the session, for a reason in one sentence
     */
    public ThreadGuard(Consumer<HealthFault> health, Consumer<String> stop) {
        this.health = Objects.requireNonNull(health, "health");
        this.stop = Objects.requireNonNull(stop, "stop");
    }

    /** For threads without which missions cannot go on, and as the default of a program's. */
    @Override
    public void uncaughtException(Thread thread, Throwable fault) {
        caught(thread.getName(), fault);
    }

    /** Something was thrown on a thread without which missions cannot go on. */
    public void caught(String thread, Throwable fault) {
        take(thread, fault, true);
    }

    /** Something was thrown on a thread that does single pieces of work, such as reading a file: only that piece is lost. */
    public void lost(String thread, Throwable fault) {
        take(thread, fault, false);
    }

    private void take(String thread, Throwable fault, boolean stops) {
        try {
            boolean isOfMachine = isOfMachine(fault);
            if (isOfMachine) {
                reserve.set(null); // for the words, and for the last commands to boats
            }
            LOG.log(Level.ERROR, () -> "a fault on the thread '" + thread + "'", fault);
            if (isOfMachine && stops) {
                stop.accept(words(fault) + " on the thread '" + thread + "'");
            }
            health.accept(isOfMachine ? ofMachine(thread, fault) : ofThread(thread, fault));
        } catch (RuntimeException | Error again) {
            LOG.log(Level.ERROR, "a fault while another one was told", again);
        }
    }

    private static HealthFault ofMachine(String thread, Throwable fault) {
        return HealthFault.ofSession(
                        HealthKind.MEMORY,
                        Priority.CRITICAL,
                        "The program has a fault: " + words(fault),
                        "End the session and open it again, with smaller maps and projects or more memory")
                .withDetails("It was met on the thread '" + thread + "'. JAVA_OPTS=-Xmx2g gives more memory");
    }

    private HealthFault ofThread(String thread, Throwable fault) {
        int times = counts.merge(thread, 1, Integer::sum);
        return HealthFault.of(
                        HealthKind.THREAD,
                        thread,
                        Priority.HIGH,
                        "A part of the program (thread '" + thread + "') met "
                                + (times == 1 ? "an error" : times + " errors"),
                        ADVICE)
                .withDetails((times == 1 ? "" : "The last: ") + fault);
    }

    private static String words(Throwable fault) {
        Optional<Throwable> memory =
                causes(fault).filter(one -> one instanceof OutOfMemoryError).findFirst();
        return memory.map(one -> "memory ran out (" + one.getMessage() + ")")
                .orElseGet(() -> "the Java machine failed (" + fault + ")");
    }

    /** Whether it is no fault of the code that threw it. */
    private static boolean isOfMachine(Throwable fault) {
        return causes(fault)
                .anyMatch(one -> one instanceof VirtualMachineError && !(one instanceof StackOverflowError));
    }

    private static Stream<Throwable> causes(Throwable fault) {
        return Stream.iterate(fault, Objects::nonNull, Throwable::getCause).limit(DEEPEST_CAUSE);
    }
}
