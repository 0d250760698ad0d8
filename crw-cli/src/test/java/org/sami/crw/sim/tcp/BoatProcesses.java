package org.sami.crw.sim.tcp;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.Peer;
import org.sami.boat.server.log.LogLines;
import org.sami.boat.server.log.LoggedCommand;
import org.sami.boat.server.testing.OwnPort;
import org.sami.crw.cli.CrwProcess;

/** Boats as processes of their own, side by side at a quay, with logs. All end with the fleet. */
final class BoatProcesses implements AutoCloseable {
    private static final double LAT_DEG = 45.4;
    private static final double LON_DEG = 10.9;
    private static final double APART_DEG = 1e-4;

    private final Path folder;
    private final Map<String, Boat> boats = new LinkedHashMap<>();
    private final Optional<Path> keys;

    /** Where a boat's server listens, and where the boat lies at its start. */
    private record Boat(CrwProcess process, int port, double lonDeg) {}

    /** A fleet that keeps logs and what is said in a folder. */
    BoatProcesses(Path folder) {
        this(folder, Optional.empty());
    }

    private BoatProcesses(Path folder, Optional<Path> keys) {
        this.folder = folder;
        this.keys = keys;
    }

    /** A fleet over protected links: each boat has a key of its own and is paired with the base whose keys lie in that folder. */
    static BoatProcesses paired(Path folder, Path baseKeys) {
        return new BoatProcesses(folder, Optional.of(baseKeys));
    }

    /** Starts boats; they answer when this returns. */
    BoatProcesses with(String... names) throws IOException {
        Map<String, CrwProcess> starting = new LinkedHashMap<>();
        for (String name : names) {
            if (keys.isPresent()) {
                pair(name, keys.get());
            }
            starting.put(name, start(name, OwnPort.draw(), lonDeg(starting.size()), folder));
        }
        for (Map.Entry<String, CrwProcess> one : starting.entrySet()) {
            int port = Integer.parseInt(one.getValue().awaitOut(one.getKey() + " listens on 127.0.0.1:"));
            boats.put(one.getKey(), new Boat(one.getValue(), port, lonDeg(boats.size())));
        }
        return this;
    }

    private void pair(String name, Path baseKeys) throws IOException {
        KeyRing base = new KeyStoreFolder(baseKeys).open();
        KeyRing boat = new KeyStoreFolder(keysOf(name)).open();
        boat.add(new Peer(base.identity().fingerprint(), "base", Role.COMMANDER));
        base.add(new Peer(boat.identity().fingerprint(), name, Role.COMMANDER));
    }

    private Path keysOf(String name) {
        return folder.resolve("keys").resolve(name);
    }

    private static double lonDeg(int number) {
        return LON_DEG + number * APART_DEG;
    }

    private CrwProcess start(String name, int port, double lonDeg, Path logs) throws IOException {
        List<String> command = new ArrayList<>(List.of(
                "boat",
                "--port",
                "" + port,
                "--name",
                name,
                "--at",
                LAT_DEG + "," + lonDeg,
                "--sensor",
                "temperature",
                "--log",
                logs.toString()));
        if (keys.isPresent()) {
            command.addAll(List.of("--boat-keys", keysOf(name).toString()));
        }
        return CrwProcess.start(Files.createDirectories(folder.resolve("said")), command);
    }

    /** The addresses, as {@code --connect} takes them. */
    String addresses() {
        return boats.values().stream().map(boat -> "127.0.0.1:" + boat.port).collect(Collectors.joining(","));
    }

    int port(String name) {
        return boats.get(name).port;
    }

    static double latDeg() {
        return LAT_DEG;
    }

    double lonDeg(String name) {
        return boats.get(name).lonDeg;
    }

    /** Ends a boat as {@code kill -9} does. */
    void kill(String name) throws InterruptedException {
        boats.get(name).process.kill();
    }

    /** Starts a boat again, at its port and its quay. {@code logs} is where it looks for its state. */
    void startAgain(String name, Path logs) throws IOException {
        Boat before = boats.get(name);
        CrwProcess process = start(name, before.port, before.lonDeg, logs);
        process.awaitOut(name + " listens on 127.0.0.1:");
        boats.put(name, new Boat(process, before.port, before.lonDeg));
    }

    /** What a boat has executed or refused, by its own log. */
    List<LoggedCommand> log(String name) {
        List<LoggedCommand> entries = new ArrayList<>();
        try {
            LogLines.read(folder.resolve(name + ".log"), entries::add);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return entries;
    }

    /** The ids of these commands. */
    List<String> commandIds(String name) {
        return log(name).stream().map(entry -> entry.command().commandId()).toList();
    }

    @Override
    public void close() {
        boats.values().forEach(boat -> boat.process.close());
    }
}
