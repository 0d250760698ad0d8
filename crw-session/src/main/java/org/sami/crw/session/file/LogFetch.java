package org.sami.crw.session.file;

import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.boat.link.KeptFile;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.file.FileNews;
import org.sami.crw.proxy.file.FleetFileFetch;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.session.api.LinkedBoat;

/**
 * The fetching of boats' logs as a window shows it: the boats that are linked, how far each of the chosen ones is, what came and what did not. A boat that does not answer
 * is tried again until the fetch is cancelled. To be used on the thread of its front, on which changes are notified; links and disks have threads of their own.
 */
public final class LogFetch {
    private final Executor front;
    private final Function<LinkedBoat, BoatFileSource> files;
    private final Runnable changed;
    private final Map<BoatAddress, LogRow> rows = new LinkedHashMap<>();
    private final Map<BoatAddress, Function<LogRow, LogRow>> news =
            new HashMap<>(); // guarded by itself; the newest of each boat
    private Optional<FleetFileFetch> running = Optional.empty();
    private boolean cancelled;
    private String said = "";
    private boolean bad;

    /**
     * Nothing is fetched yet.
     *
     * @param front runs what this notifies
     * @param files makes a link to a boat for its files, such as {@code fleet()::files}; from any thread
     * @param changed is called on the front after each change
     */
    public LogFetch(Executor front, Function<LinkedBoat, BoatFileSource> files, Runnable changed) {
        this.front = Objects.requireNonNull(front, "front");
        this.files = Objects.requireNonNull(files, "files");
        this.changed = Objects.requireNonNull(changed, "changed");
    }

    /** The boats that are linked now; while a fetch runs, its own stay listed. */
    public void offer(List<LinkedBoat> links) {
        Map<BoatAddress, LogRow> next = new LinkedHashMap<>();
        rows.forEach((address, row) -> {
            if (running.isPresent() && row.state() != LogRow.State.IDLE) {
                next.put(address, row);
            }
        });
        for (LinkedBoat link : links) {
            next.putIfAbsent(
                    link.address(),
                    Optional.ofNullable(rows.get(link.address())).orElse(LogRow.idle(link.boat(), link.address())));
        }
        if (!next.equals(rows)) {
            rows.clear();
            rows.putAll(next);
            changed.run();
        }
    }

    /** The boats, by their names. */
    public List<LogRow> rows() {
        return rows.values().stream()
                .sorted(java.util.Comparator.comparing(LogRow::boat))
                .toList();
    }

    /** Fetches the logs of some of these boats, unless it does already. Each gets a folder of its name in the folder. */
    public void begin(Set<BoatAddress> chosen, Path folder) {
        if (running.isPresent()) {
            return;
        }
        List<BoatAddress> addresses =
                rows.keySet().stream().filter(chosen::contains).toList();
        if (addresses.isEmpty()) {
            say("Choose a boat first", true);
            return;
        } else if (Files.exists(folder) && !Files.isDirectory(folder)) {
            say(folder + " is no folder: choose another", true);
            return;
        }
        rows.replaceAll((address, row) -> chosen.contains(address) ? row.asked() : LogRow.idle(row.boat(), address));
        Map<BoatAddress, LinkedBoat> boats = new HashMap<>();
        rows.forEach((address, row) -> boats.put(address, new LinkedBoat(row.boat(), address)));
        FleetFileFetch fetch = FleetFileFetch.untilCancelled(
                addresses, address -> files.apply(Objects.requireNonNull(boats.get(address))), new News());
        running = Optional.of(fetch);
        cancelled = false;
        say("Fetching into " + folder, false);
        Thread thread = new Thread(() -> run(fetch, folder), "log-fetch");
        thread.setDaemon(true);
        thread.start();
    }

    private void run(FleetFileFetch fetch, Path folder) {
        String fault;
        try {
            fetch.fetch(KeptFile.LOG, folder, answer -> post(answer.address(), row -> row.ended(answer, cancelled)));
            fault = "";
        } catch (InterruptedException e) {
            fault = "interrupted";
        } catch (RuntimeException e) {
            fault = String.valueOf(e.getMessage());
        }
        String why = fault;
        front.execute(() -> ended(folder, why));
    }

    private void ended(Path folder, String fault) {
        takeNews();
        running = Optional.empty();
        List<String> here = names(LogRow.State.HERE);
        List<String> without = names(LogRow.State.NO_LOG);
        List<String> missing = new ArrayList<>(names(LogRow.State.FAILED));
        missing.addAll(names(LogRow.State.CANCELLED));
        List<String> parts = new ArrayList<>();
        if (!here.isEmpty()) {
            parts.add("Logs of " + String.join(", ", here) + " are in " + folder);
        }
        if (!without.isEmpty()) {
            parts.add(String.join(", ", without) + (without.size() == 1 ? " keeps" : " keep") + " no log");
        }
        if (!missing.isEmpty()) {
            parts.add("not all of " + String.join(", ", missing) + (cancelled ? ", as it was cancelled" : "")
                    + ": fetch again, it goes on there");
        }
        if (!fault.isEmpty()) {
            parts.add(fault);
        }
        say(String.join("; ", parts), !missing.isEmpty() || !fault.isEmpty());
    }

    private List<String> names(LogRow.State state) {
        return rows().stream()
                .filter(row -> row.state() == state)
                .map(LogRow::boat)
                .collect(Collectors.toList());
    }

    private void say(String words, boolean wrong) {
        said = words;
        bad = wrong;
        changed.run();
    }

    /** Ends the fetch soon: what has come is kept, and a later fetch continues there. */
    public void cancel() {
        cancelled = running.isPresent();
        running.ifPresent(FleetFileFetch::cancel);
    }

    /** Whether a fetch runs. */
    public boolean isRunning() {
        return running.isPresent();
    }

    /** Progress of the fetch, or the result of the last one, in words. */
    public String said() {
        return said;
    }

    /** Whether something did not come. */
    public boolean isBad() {
        return bad;
    }

    /** Up to fifty pieces a second of each boat arrive on other threads: the front is notified only of the newest. */
    private void post(BoatAddress address, Function<LogRow, LogRow> change) {
        synchronized (news) {
            boolean told = !news.isEmpty();
            news.put(address, change);
            if (told) {
                return;
            }
        }
        front.execute(() -> {
            takeNews();
            changed.run();
        });
    }

    private void takeNews() {
        Map<BoatAddress, Function<LogRow, LogRow>> newest;
        synchronized (news) {
            newest = new HashMap<>(news);
            news.clear();
        }
        newest.forEach((address, change) -> rows.computeIfPresent(address, (same, row) -> change.apply(row)));
    }

    private final class News implements FileNews {
        private final Map<String, BoatAddress> addresses;

        News() {
            Map<String, BoatAddress> all = new HashMap<>();
            rows.values().forEach(row -> all.put(row.boat(), row.address()));
            addresses = Map.copyOf(all);
        }

        @Override
        public void come(String boatId, String name, long here, long bytes) {
            Optional.ofNullable(addresses.get(boatId))
                    .ifPresent(address -> post(address, row -> row.come(name, here, bytes)));
        }

        @Override
        public void waits(InetSocketAddress at, String why) {
            post(new BoatAddress(at.getHostString(), at.getPort()), row -> row.unanswered(why));
        }
    }
}
