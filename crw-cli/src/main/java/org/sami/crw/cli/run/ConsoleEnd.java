package org.sami.crw.cli.run;

import java.io.IOException;
import java.util.Objects;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.sami.crw.console.Console;
import org.sami.crw.console.LineSource;
import org.sami.crw.session.SessionListener;

/**
 * Runs a console until its lines end, or until the session cannot go on: where nobody sits at it, it ends at once then, also while it waits for a line. An
 * operator at a terminal keeps it, to bring boats home by hand.
 */
final class ConsoleEnd implements SessionListener {
    private static final long LAST_COMMAND_S = 5;

    private final Console console;
    private final LineSource lines;
    private final boolean attended;
    private final CountDownLatch over = new CountDownLatch(1);

    ConsoleEnd(Console console, LineSource lines, boolean attended) {
        this.console = Objects.requireNonNull(console, "console");
        this.lines = Objects.requireNonNull(lines, "lines");
        this.attended = attended;
    }

    @Override
    public void onBroken(String reason) {
        lines.print("crw: the session cannot go on: " + reason);
        if (attended) {
            lines.print("Boats can still be stopped ('stop all') and driven; 'quit' stops them and ends (exit code 4)");
        } else {
            end();
        }
    }

    /** Ends it, also while it waits for a line that nobody types. */
    void end() {
        console.end();
        over.countDown();
    }

    /** Runs it; gives how many commands were not carried out. */
    int run() throws IOException {
        if (attended) {
            return console.run(lines);
        }
        FutureTask<Integer> reading = new FutureTask<>(() -> {
            try {
                return console.run(lines);
            } finally {
                over.countDown();
            }
        });
        Thread reader = new Thread(reading, "console");
        reader.setDaemon(true); // it may wait for a line that never comes
        reader.start();
        try {
            over.await();
            return reading.get(LAST_COMMAND_S, TimeUnit.SECONDS);
        } catch (TimeoutException waitsForALine) {
            return 0;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        } catch (ExecutionException fault) {
            if (fault.getCause() instanceof IOException unreadable) {
                throw unreadable;
            }
            throw new IllegalStateException(fault.getCause());
        }
    }
}
