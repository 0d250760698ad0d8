package org.sami.crw.session.picture;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongSupplier;
import org.sami.boat.link.KeptFile;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.file.BoatFileFetch.NamedFiles;
import org.sami.crw.proxy.file.FileFetchException;
import org.sami.crw.proxy.status.LinkState;
import org.sami.session.record.SessionPictures;

/**
 * Fetches the pictures of each panorama as soon as the boat reports it, one panorama of a boat after the other, on separate threads. After a lost link the rest
 * is fetched when the link is back, or after 20 s. The result for each picture is published as an event of the fleet. For the fleet's thread, which it never
 * blocks.
 */
public final class PictureFetcher implements Closeable {
    private static final long AGAIN_AFTER_MS = 20_000;

    private final Function<String, Optional<PictureAccess>> sources;
    private final SessionPictures folder;
    private final PictureLimits limits;
    private final Executor fleet;
    private final Executor workers;
    private final Consumer<FleetEvent> publish;
    private final LongSupplier nowMillis;
    private final Map<String, Deque<Job>> waiting =
            new LinkedHashMap<>(); // this and those below: for the fleet's thread
    private final Map<String, Long> notBefore = new HashMap<>();
    private final Map<String, PictureAccess> running = new HashMap<>();
    private final Map<String, Integer> asked = new HashMap<>(); // pictures, by boat
    private final List<CompletableFuture<Void>> awaitDone = new ArrayList<>();
    private final Map<String, Long> bytes = new ConcurrentHashMap<>(); // by boat
    private volatile boolean closed;

    /** The pictures of one panorama that have not come. */
    private record Job(String boat, String panorama, Set<String> open) {}

    /**
     * Fetches nothing yet.
     *
     * @param sources the way to a boat's pictures, if there is one now; asked on the fleet's thread
     * @param fleet the fleet's thread
     * @param workers runs what waits for boats; several at once, if it can
     * @param publish publishes an event of the fleet; called on the fleet's thread
     */
    public PictureFetcher(
            Function<String, Optional<PictureAccess>> sources,
            SessionPictures folder,
            PictureLimits limits,
            Executor fleet,
            Executor workers,
            Consumer<FleetEvent> publish,
            LongSupplier nowMillis) {
        this.sources = sources;
        this.folder = folder;
        this.limits = limits;
        this.fleet = fleet;
        this.workers = workers;
        this.publish = publish;
        this.nowMillis = nowMillis;
    }

    /** Something happened to the fleet; on its thread. */
    public void take(FleetEvent event) {
        if (event instanceof FleetEvent.PanoramaTaken panorama
                && !panorama.files().isEmpty()) {
            add(panorama.boat(), panorama.command().commandId(), panorama.files());
        } else if (event instanceof FleetEvent.LinkChanged changed
                && changed.status().link() == LinkState.LINKED) {
            notBefore.remove(changed.boat());
            begin(changed.boat());
        }
    }

    /** Takes up what an earlier process reported; on the fleet's thread, before boats are linked. */
    public void restore(FleetEvent event) {
        if (event instanceof FleetEvent.PanoramaTaken panorama) {
            queue(panorama.boat(), panorama.command().commandId(), panorama.files());
        } else if (event instanceof FleetEvent.PictureFetched fetched) {
            over(fetched.boat(), fetched.panorama(), fetched.name());
            bytes.merge(fetched.boat(), size(fetched.file()), Long::sum);
        } else if (event instanceof FleetEvent.PictureMissed missed) {
            over(missed.boat(), missed.panorama(), missed.name());
        }
    }

    private static long size(Path file) {
        try {
            return Files.size(file);
        } catch (IOException gone) {
            return 0;
        }
    }

    private void over(String boat, String panorama, String name) {
        Deque<Job> jobs = waiting.getOrDefault(boat, new ArrayDeque<>());
        jobs.stream()
                .filter(job -> job.panorama().equals(panorama))
                .forEach(job -> job.open().remove(name));
        jobs.removeIf(job -> job.open().isEmpty());
    }

    /** Tries again what failed some time ago; to be called about once a second on the fleet's thread. */
    public void look() {
        List.copyOf(waiting.keySet()).forEach(this::begin);
    }

    private void add(String boat, String panorama, List<String> names) {
        List<String> left = queue(boat, panorama, names);
        left.forEach(name -> later(new FleetEvent.PictureMissed(boat, panorama, name, limits.tooMany(boat, name))));
        begin(boat);
    }

    /** Returns those that are too many. */
    private List<String> queue(String boat, String panorama, List<String> names) {
        int before = asked.getOrDefault(boat, 0);
        int taken = Math.max(0, Math.min(names.size(), limits.picturesOfBoat() - before));
        asked.put(boat, before + taken);
        if (taken > 0) {
            waiting.computeIfAbsent(boat, id -> new ArrayDeque<>())
                    .addLast(new Job(boat, panorama, new LinkedHashSet<>(names.subList(0, taken))));
        }
        return names.subList(taken, names.size());
    }

    /** Events are published after the one that is being published. */
    private void later(FleetEvent event) {
        fleet.execute(() -> publish.accept(event));
    }

    private void begin(String boat) {
        Deque<Job> jobs = waiting.getOrDefault(boat, new ArrayDeque<>());
        boolean due = nowMillis.getAsLong() >= notBefore.getOrDefault(boat, 0L);
        if (closed || running.containsKey(boat) || jobs.isEmpty() || !due) {
            return;
        }
        sources.apply(boat).ifPresent(source -> {
            Job job = jobs.getFirst();
            List<String> names = List.copyOf(job.open());
            running.put(boat, source);
            workers.execute(() -> work(job, names, source));
        });
    }

    /** On a thread that may wait. */
    private void work(Job job, List<String> names, PictureAccess source) {
        Optional<IOException> fault = Optional.empty();
        try {
            source.fetch(names, folder.folder(job.boat(), job.panorama()), new Arrivals(job));
        } catch (IOException e) {
            fault = Optional.of(e);
        } catch (RuntimeException e) {
            fault = Optional.of(new IOException("the pictures of " + job.boat() + " cannot be fetched: " + e, e));
        }
        Optional<IOException> why = fault;
        fleet.execute(() -> ended(job, why));
    }

    /** What comes of a job; on the thread that fetches. */
    private final class Arrivals implements NamedFiles {
        private final Job job;

        Arrivals(Job job) {
            this.job = job;
        }

        @Override
        public Optional<String> whyNot(KeptFile file) {
            return limits.whyNot(job.boat(), file, bytes.getOrDefault(job.boat(), 0L));
        }

        @Override
        public void come(KeptFile file, Path at) {
            bytes.merge(job.boat(), file.bytes(), Long::sum);
            settle(file.name(), new FleetEvent.PictureFetched(job.boat(), job.panorama(), file.name(), at));
        }

        @Override
        public void missed(String name, String reason) {
            settle(name, new FleetEvent.PictureMissed(job.boat(), job.panorama(), name, reason));
        }

        private void settle(String name, FleetEvent event) {
            fleet.execute(() -> {
                if (job.open().remove(name)) {
                    publish.accept(event);
                }
            });
        }
    }

    private void ended(Job job, Optional<IOException> fault) {
        running.remove(job.boat());
        if (fault.isPresent() && fault.get() instanceof FileFetchException && !closed) { // asking again does not help
            String why = String.valueOf(fault.get().getMessage());
            Set<String> open = new HashSet<>(job.open());
            job.open().clear();
            open.forEach(name -> publish.accept(new FleetEvent.PictureMissed(job.boat(), job.panorama(), name, why)));
        } else if (fault.isPresent()) {
            notBefore.put(job.boat(), nowMillis.getAsLong() + AGAIN_AFTER_MS);
        }
        Deque<Job> jobs = waiting.getOrDefault(job.boat(), new ArrayDeque<>());
        jobs.removeIf(one -> one.open().isEmpty());
        if (jobs.isEmpty()) {
            waiting.remove(job.boat());
        }
        begin(job.boat());
        if (waiting.isEmpty() && running.isEmpty()) {
            awaitDone.forEach(one -> one.complete(null));
            awaitDone.clear();
        }
    }

    /** Completes on the fleet's thread when nothing is open that could come. From any thread. */
    public CompletionStage<Void> done() {
        CompletableFuture<Void> done = new CompletableFuture<>();
        fleet.execute(() -> {
            if (waiting.isEmpty() && running.isEmpty()) {
                done.complete(null);
            } else {
                awaitDone.add(done);
            }
        });
        return done;
    }

    /** Begins nothing more, and ends what is under way; a later session goes on there. On the fleet's thread. */
    @Override
    public void close() {
        closed = true;
        running.values().forEach(PictureAccess::cancel);
    }
}
