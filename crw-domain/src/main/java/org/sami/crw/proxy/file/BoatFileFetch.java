package org.sami.crw.proxy.file;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.boat.link.security.LinkSecurity;

/**
 * Fetches files of the boat at one address into a folder, over links of its own, as an observer: {@link KeptFile#LOG logs}, {@link KeptFile#PICTURE pictures}. A link that breaks is made again and goes
 * on where it was; so does a later fetch into the same folder. Waits for the boat, so never on the event thread or an engine's. {@link #cancel} is for any thread.
 */
public final class BoatFileFetch {
    private static final long[] WAITS_MS = {250, 500, 1000, 2000, 4000};

    private final InetSocketAddress address;
    private final Supplier<BoatFileSource> links;
    private final FileNews news;
    private final boolean patient;
    private final ReentrantLock lock = new ReentrantLock();
    private final Condition cancelling = lock.newCondition();
    private Optional<BoatFileSource> current = Optional.empty(); // this and the next are guarded by the lock
    private boolean cancelled;
    private boolean progressed; // this and the next are for the fetching thread
    private long bytes; // of all links of this fetch

    /**
     * What came of it.
     *
     * @param boatId the boat that answered
     * @param files those asked for that are whole in the folder
     * @param bytes that came over the link this time
     * @param refused in words, one for each file that the boat did not give
     */
    public record Result(String boatId, List<Path> files, long bytes, List<String> refused) {
        /** Copies the lists. */
        public Result {
            files = List.copyOf(files);
            refused = List.copyOf(refused);
        }
    }

    private interface Work {
        Result on(BoatFileSource link) throws IOException;
    }

    /**
     * A fetch that has not begun.
     *
     * @param security such as {@code BaseProtection.ofThisProcess()}
     */
    public BoatFileFetch(InetSocketAddress address, LinkSecurity security, FileNews news) {
        this(address, () -> new BoatFileLink(address, security), news, false);
    }

    /**
     * A fetch that has not begun.
     *
     * @param links makes a link to the boat that is not open yet, for each try
     * @param patient whether it tries again until it is cancelled, however long the boat is not reached
     */
    BoatFileFetch(InetSocketAddress address, Supplier<BoatFileSource> links, FileNews news, boolean patient) {
        this.address = Objects.requireNonNull(address, "address");
        this.links = Objects.requireNonNull(links, "links");
        this.news = Objects.requireNonNull(news, "news");
        this.patient = patient;
    }

    /**
     * Fetches all files of a kind into {@code folder/BOAT}; what is there already is not fetched again. A file that the boat does not give is named in the result, and the others
     * come.
     *
     * @throws IOException with the reason, if the boat is not reached five times in a row, gives no files, or this was cancelled
     */
    public Result fetchAll(String kind, Path folder) throws IOException {
        return retrying(link -> {
            Path own = folder.resolve(checked(link.boatId()));
            List<Path> files = new ArrayList<>();
            List<String> refused = new ArrayList<>();
            for (KeptFile file : link.list(kind)) {
                try {
                    files.add(fetch(link, file, own));
                } catch (FileFetchException e) {
                    refused.add(String.valueOf(e.getMessage()));
                }
            }
            return result(link, files, refused);
        });
    }

    /**
     * Fetches one file into a folder, for instance one that an event named.
     *
     * @return the whole file
     * @throws FileFetchException if the boat at that address is another one, or does not give the file
     * @throws IOException with the reason, if the boat is not reached five times in a row, or this was cancelled
     */
    public Path fetch(String boatId, String kind, String name, Path folder) throws IOException {
        Result result = retrying(link -> {
            checkBoat(link, boatId);
            for (KeptFile file : link.list(kind)) {
                if (file.name().equals(name)) {
                    return result(link, List.of(fetch(link, file, folder)), List.of());
                }
            }
            throw keepsNone(boatId, kind, name);
        });
        return result.files().get(0);
    }

    /** What becomes of files that are asked for by name; called on the fetching thread, does not wait. */
    public interface NamedFiles {
        /** Why a file that the boat keeps is not to be fetched, in words; empty if it is. */
        Optional<String> whyNot(KeptFile file);

        /** A file is whole here. */
        void come(KeptFile file, Path at);

        /** A file will not come, for a reason in words that names the boat. */
        void missed(String name, String reason);
    }

    /**
     * Fetches some files into a folder, for instance those that an event named; each of them comes or is missed. A file that the boat does not give stops no other.
     *
     * @throws FileFetchException if the boat at that address is another one, or gives no files
     * @throws IOException with the reason, if the boat is not reached five times in a row, or this was cancelled; what became of some files has been reported by then
     */
    public void fetch(String boatId, String kind, List<String> names, Path folder, NamedFiles result)
            throws IOException {
        Set<String> open = new LinkedHashSet<>(names);
        retrying(link -> {
            checkBoat(link, boatId);
            Map<String, KeptFile> kept = new HashMap<>();
            link.list(kind).forEach(file -> kept.put(file.name(), file));
            for (String name : List.copyOf(open)) {
                try {
                    KeptFile file =
                            Optional.ofNullable(kept.get(name)).orElseThrow(() -> keepsNone(boatId, kind, name));
                    Optional<String> whyNot = result.whyNot(file);
                    if (whyNot.isPresent()) {
                        throw new FileFetchException(whyNot.get());
                    }
                    Path here = fetch(link, file, folder);
                    open.remove(name);
                    result.come(file, here);
                } catch (FileFetchException e) {
                    open.remove(name);
                    result.missed(name, String.valueOf(e.getMessage()));
                }
            }
            return result(link, List.of(), List.of());
        });
    }

    private void checkBoat(BoatFileSource link, String boatId) throws FileFetchException {
        if (!link.boatId().equals(boatId)) {
            throw new FileFetchException("at " + address.getHostString() + ":" + address.getPort() + " answers "
                    + link.boatId() + ", not " + boatId);
        }
    }

    private static FileFetchException keepsNone(String boatId, String kind, String name) {
        return new FileFetchException(boatId + " keeps no " + kind + " " + name + ", or does so no longer");
    }

    /** Bytes that came over the link so far; for the fetching thread. */
    long bytes() {
        return bytes;
    }

    private Result result(BoatFileSource link, List<Path> files, List<String> refused) {
        return new Result(link.boatId(), files, bytes, refused);
    }

    private Path fetch(BoatFileSource link, KeptFile file, Path folder) throws IOException {
        FileCopy copy = new FileCopy(file, folder);
        copy.fetch(link, (here, piece) -> {
            bytes += piece;
            progressed = true;
            news.come(link.boatId(), file.name(), here, file.bytes());
        });
        return copy.path();
    }

    private static String checked(String boatId) throws FileFetchException {
        if (!KeptFile.isName(boatId)) {
            throw new FileFetchException("the boat's name is no name of a folder: " + boatId);
        }
        return boatId;
    }

    private Result retrying(Work work) throws IOException {
        int failures = 0;
        while (true) {
            progressed = false;
            try (BoatFileSource link = begin()) {
                link.open();
                return work.on(link);
            } catch (FileFetchException | LinkRefusedException e) {
                throw e;
            } catch (IOException e) {
                if (patient && e instanceof FileSystemException here) {
                    String why = here.getReason() == null ? "cannot be written" : here.getReason();
                    throw new FileFetchException("it cannot be kept here: " + here.getFile() + ": " + why);
                }
                failures = progressed ? 1 : failures + 1;
                if (failures > WAITS_MS.length && !patient) {
                    throw e;
                }
                checkCancelled();
                news.waits(address, e.getMessage() == null ? e.toString() : e.getMessage());
                await(WAITS_MS[Math.min(failures, WAITS_MS.length) - 1]);
            }
        }
    }

    private BoatFileSource begin() throws IOException {
        lock.lock();
        try {
            checkCancelled();
            BoatFileSource next = links.get();
            current = Optional.of(next);
            return next;
        } finally {
            lock.unlock();
        }
    }

    private void await(long waitMs) throws IOException {
        lock.lock();
        try {
            long left = TimeUnit.MILLISECONDS.toNanos(waitMs);
            while (left > 0 && !cancelled) {
                left = cancelling.awaitNanos(left);
            }
            checkCancelled();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new FileFetchException("interrupted; what has come is kept");
        } finally {
            lock.unlock();
        }
    }

    private void checkCancelled() throws FileFetchException {
        lock.lock();
        try {
            if (cancelled) {
                throw new FileFetchException("cancelled; what has come is kept");
            }
        } finally {
            lock.unlock();
        }
    }

    /** Ends it soon: what has come is kept, and a later fetch goes on there. */
    public void cancel() {
        lock.lock();
        try {
            cancelled = true;
            cancelling.signalAll();
            if (current.isPresent()) {
                current.get().close();
            }
        } catch (IOException e) {
            // it is closed for us all the same
        } finally {
            lock.unlock();
        }
    }
}
