package org.sami.crw.sim.boat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.spn.value.GeoPoint;

/**
 * A simulated boat as a process of its own, started by this one, on a free port of the loopback address. It ends when it is
 * closed, and also when this process ends in any way: it goes on only as long as its standard input is held open.
 */
public final class BoatProcess implements AutoCloseable {
    private static final long START_S = 30;
    private static final long END_S = 5;

    private final String name;
    private final Process process;
    private final FutureTask<String> firstLine;

    /**
     * Starts one; it does not answer yet.
     *
     * @param crw the command line that runs the program {@code crw}
     * @param name the boat's name
     * @param at where it lies
     * @throws IOException if no process can be started
     */
    public BoatProcess(List<String> crw, String name, GeoPoint at) throws IOException {
        this.name = name;
        List<String> command = new ArrayList<>(crw);
        String where = String.format(Locale.ROOT, "%.7f,%.7f", at.latDeg(), at.lonDeg());
        command.addAll(List.of("boat", "--port", "0", "--name", name, "--at", where, "--while-input"));
        process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        firstLine = new FutureTask<>(() ->
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8)).readLine());
        Thread reader = new Thread(firstLine, name + "-says");
        reader.setDaemon(true);
        reader.start();
    }

    /**
     * Waits until its server listens.
     *
     * @throws IOException if it does not come to that
     * @throws InterruptedException if somebody wants an end
     */
    public BoatAddress awaitAddress() throws IOException, InterruptedException {
        try {
            String line = firstLine.get(START_S, TimeUnit.SECONDS);
            if (line == null) {
                throw new IOException("the process of " + name + " has ended");
            }
            return BoatAddress.parse(line.substring(line.lastIndexOf(' ') + 1));
        } catch (ExecutionException | TimeoutException | IllegalArgumentException e) {
            throw new IOException("the process of " + name + " does not say where it listens", e);
        }
    }

    /** What the system calls the process. */
    public long pid() {
        return process.pid();
    }

    /** Ends it. */
    @Override
    public void close() {
        try {
            process.getOutputStream().close();
            process.waitFor(END_S, TimeUnit.SECONDS);
        } catch (IOException e) {
            // it has ended already
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            process.destroyForcibly();
        }
    }
}
