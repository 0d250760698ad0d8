package org.sami.crw.proxy.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.Function;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * Fetches the files of one kind from several boats at once, each on a thread of its own; a boat that fails stops no other. {@link #fetch} waits, so never on the event thread;
 * {@link #cancel} is for any thread.
 */
public final class FleetFileFetch {
    private static final int MOST_AT_ONCE = 25;

    private final Map<BoatAddress, BoatFileFetch> fetches = new LinkedHashMap<>(); // not changed after the constructor

    /**
     * What came of it at one address.
     *
     * @param boatId the boat that answered; empty if none did
     * @param files whole in the folder now
     * @param bytes that came over the link this time
     * @param faults in words; empty if all files are here
     */
    public record Answer(BoatAddress address, String boatId, List<Path> files, long bytes, List<String> faults) {
        /** Copies the lists. */
        public Answer {
            files = List.copyOf(files);
            faults = List.copyOf(faults);
        }

        /** Whether all files of the boat are here. */
        public boolean done() {
            return faults.isEmpty();
        }
    }

    /**
     * A fetch that has not begun.
     *
     * @param news called by several threads
     */
    public FleetFileFetch(List<BoatAddress> addresses, LinkSecurity security, FileNews news) {
        this(addresses, address -> new BoatFileLink(address.toSocketAddress(), security), news, false);
    }

    private FleetFileFetch(
            List<BoatAddress> addresses, Function<BoatAddress, BoatFileSource> links, FileNews news, boolean patient) {
        for (BoatAddress address : addresses) {
            fetches.put(
                    address, new BoatFileFetch(address.toSocketAddress(), () -> links.apply(address), news, patient));
        }
    }

    /**
     * A fetch that has not begun, and then tries boats again until it is cancelled, however long they are not reached.
     *
     * @param links makes a link to a boat that is not open yet, for each try; called by several threads, as the news are
     */
    public static FleetFileFetch untilCancelled(
            List<BoatAddress> addresses, Function<BoatAddress, BoatFileSource> links, FileNews news) {
        return new FleetFileFetch(addresses, links, news, true);
    }

    /**
     * Fetches what is new into {@code folder/BOAT} of each boat.
     *
     * @return an answer for each address, in their order
     * @throws InterruptedException if it is to end; what has come is kept
     */
    public List<Answer> fetch(String kind, Path folder) throws InterruptedException {
        return fetch(kind, folder, answer -> {});
    }

    /**
     * Fetches what is new into {@code folder/BOAT} of each boat.
     *
     * @param ended receives each answer as soon as it is there, on several threads
     * @return an answer for each address, in their order
     * @throws InterruptedException if it is to end; what has come is kept
     */
    public List<Answer> fetch(String kind, Path folder, Consumer<Answer> ended) throws InterruptedException {
        int threads = Math.max(1, Math.min(MOST_AT_ONCE, fetches.size()));
        ExecutorService executor = Executors.newFixedThreadPool(threads, work -> {
            Thread thread = new Thread(work, "file-fetch");
            thread.setDaemon(true);
            return thread;
        });
        try {
            List<Future<Answer>> running = new ArrayList<>();
            fetches.forEach((address, one) -> running.add(executor.submit(() -> {
                Answer answer = answer(address, one, kind, folder);
                ended.accept(answer);
                return answer;
            })));
            List<Answer> answers = new ArrayList<>();
            for (Future<Answer> each : running) {
                answers.add(each.get());
            }
            return answers;
        } catch (ExecutionException | CancellationException e) {
            throw new IllegalStateException("a fetch broke", e);
        } finally {
            cancel();
            executor.shutdownNow();
        }
    }

    private static Answer answer(BoatAddress address, BoatFileFetch fetch, String kind, Path folder) {
        try {
            BoatFileFetch.Result result = fetch.fetchAll(kind, folder);
            return new Answer(address, result.boatId(), result.files(), result.bytes(), result.refused());
        } catch (IOException e) {
            String why = e.getMessage() == null ? e.toString() : e.getMessage();
            return new Answer(address, "", List.of(), fetch.bytes(), List.of(why));
        }
    }

    /** Ends it soon: what has come is kept, and a later fetch goes on there. */
    public void cancel() {
        fetches.values().forEach(BoatFileFetch::cancel);
    }
}
